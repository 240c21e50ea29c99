import { expect, it } from "vitest";
import { sourceAt, typedAt, typedLike } from "./typedLike.ts";

const text = `
geometry:
  stagger: [0.20 m, -200 mm]
span_types:
  a: {droppers: {positions: {value: [4.5, 10.25], mark: A}}}
height: 5300 mm
`;

it("finds values by their paths, through those that carry a source", async () => {
  expect(await typedAt(text, "geometry.stagger.0")).toBe("0.20 m");
  expect(await typedAt(text, "span_types.a.droppers.positions.1")).toBe(10.25);
  expect(await typedAt(text, "span_types.a.droppers.positions")).toEqual([4.5, 10.25]);
  expect(await typedAt(text, "span_types.b.droppers")).toBeUndefined();
});

it("writes a length as the one that stands there", async () => {
  expect(await typedLike(text, "geometry.stagger.0", 0.25)).toBe("0.25 m");
  expect(await typedLike(text, "geometry.stagger.1", -0.15)).toBe("-150 mm");
  expect(await typedLike(text, "span_types.a.droppers.positions.1", 10.5)).toBe(10.5);
  expect(await typedLike(text, "span_types.a.length", 50)).toBe("50 m");
});

it("tells where a value is from", async () => {
  expect(await sourceAt(text, ["span_types", "a", "droppers", "positions"])).toEqual(["Mark: A"]);
  expect(await sourceAt(text, ["height"])).toEqual([]);
  expect(await sourceAt("a: [", ["a"])).toEqual([]);
});
