import { expect, test } from "vitest";
import { ascends, seen, trace } from "./thin.ts";

function traced(x: number[], y: number[], range: [number, number] = [0, x.length]): (number | string)[][] {
  const out: (number | string)[][] = [];
  trace(range, (k) => [x[k]!, y[k]!], (a, b) => out.push(["move", a, b]), (a, b) => out.push(["line", a, b]));
  return out;
}

test("of the samples in a column of pixels the lowest and the highest are drawn, in their order", () => {
  expect(traced([0.1, 0.2, 0.4, 0.8, 1.5], [5, 9, 1, 4, 5])).toEqual([["move", 0.2, 9], ["line", 0.4, 1], ["line", 1.5, 5]]);
  expect(traced([0.1, 0.2, 0.4], [5, 1, 9])).toEqual([["move", 0.2, 1], ["line", 0.4, 9]]);
});

test("every extreme of a curve is drawn, however many samples it has", () => {
  const x = Array.from({ length: 10_000 }, (_, k) => k / 100);
  const y = x.map((value, k) => Math.sin(value) + (k === 4321 ? 50 : 0));
  const found = traced(x, y);
  expect(found.length).toBeLessThanOrEqual(200);
  expect(Math.max(...found.map((one) => one[2] as number))).toBe(y[4321]);
});

test("few samples are drawn as they are, and NaN interrupts the line", () => {
  expect(traced([0, 2, 4, 6], [1, NaN, 3, 4])).toEqual([["move", 0, 1], ["move", 4, 3], ["line", 6, 4]]);
  expect(traced([0.1, 0.2, 0.3], [NaN, 7, NaN])).toEqual([["move", 0.2, 7]]);
});

test("samples that are seen have a neighbour on each side", () => {
  const x = [0, 1, 2, 3, 3, 4, 5];
  expect(seen(x, 1.5, 3)).toEqual([1, 6]);
  expect(seen(x, -9, 99)).toEqual([0, 7]);
  expect(seen(x, 6, 7)).toEqual([6, 7]);
  expect(seen(x, -3, -2)).toEqual([0, 1]);
});

test("places that go back are found", () => {
  expect([ascends([1, 1, 2]), ascends([1, 0.5, 2])]).toEqual([true, false]);
});
