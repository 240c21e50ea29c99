// @vitest-environment happy-dom
import { expect, test } from "vitest";
import { topOf, widest, type Column, type Stored } from "./columns.ts";
import { wantedPart } from "./series.ts";

/** Values so many metres apart, up to 50 km. */
const column = (apart: number): Column => {
  const x = Float32Array.from({ length: 50_000 / apart }, (_, n) => n * apart);
  return { x, low: x.map(() => 100), high: x.map((at) => (at === 40_000 ? 390 : 200)) };
};
const whole = (apart: number): Stored => ({ raw: [column(apart), null], filtered: [], top: 390 });

test("the largest force is that of the whole run, whatever part is seen", () => {
  expect(topOf(whole(5).raw)).toBe(390);
  expect(topOf([null])).toBe(0);
});

test("places are as far apart as in the range that is asked about", () => {
  const own = { ...column(5), x: Float32Array.of(0, 1, 2, 7, 8) };
  expect([widest(own, [0, 2]), widest(own, [0, 8]), widest(own, [20, 30])]).toEqual([1, 5, 0]);
});

test("a part is asked for where the whole is coarser than what is seen", () => {
  expect(wantedPart([0, 50_000], whole(5), [660, 1510])).toBe("whole");
  expect(wantedPart([1000, 1170], whole(0.5), null)).toBe("whole");
  expect(wantedPart([1000, 1170], whole(5), null)).toEqual([660, 1510]);
});

test("it is asked for once, anew before its end is seen, and where much less is seen", () => {
  expect(wantedPart([1100, 1270], whole(5), [660, 1510])).toBe(null);
  expect(wantedPart([1300, 1470], whole(5), [660, 1510])).toEqual([960, 1810]);
  expect(wantedPart([1100, 1120], whole(5), [660, 1510])).toEqual([1060, 1160]);
});
