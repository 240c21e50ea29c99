import { expect, it } from "vitest";
import { scaleOf } from "./scale.ts";

it.each([
  [[38.2, 91.7, 55], 4],
  [[0, 101], 3],
  [[-12, 3], 5],
  [[70, 70.0001], 2],
  [[0.311, 0.487], 6],
])("holds its data between ticks: %j", (values, most) => {
  const { low, high, ticks } = scaleOf(values, most);
  expect(ticks[0]).toBeCloseTo(low, 9);
  expect(ticks.at(-1)).toBeCloseTo(high, 9);
  expect(Math.min(...values)).toBeGreaterThanOrEqual(low - 1e-9);
  expect(Math.max(...values)).toBeLessThanOrEqual(high + 1e-9);
  expect(ticks.length).toBeGreaterThan(1);
  expect(ticks.length).toBeLessThanOrEqual(most + 2);
});
