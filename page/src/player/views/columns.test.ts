import { expect, it } from "vitest";
import { columnEnds, topOf } from "./columns.ts";

const column = {
  x: Float32Array.of(0, 1, 2, 3),
  low: Float32Array.of(10, NaN, 30, NaN),
  high: Float32Array.of(20, NaN, 40, NaN),
};

it("gives lowest and highest of what is known", () => {
  expect(columnEnds(column)(0, 4)).toEqual([10, 40]);
  expect(columnEnds(column)(1, 2)).toBeNull();
  expect(topOf([column, null])).toBe(40);
});
