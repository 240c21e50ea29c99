import { expect, test } from "vitest";
import { Buckets, History } from "./history.ts";

test("keeps the ends of what was received between two positions", () => {
  const buckets = new Buckets();
  for (let x = 0; x < 100; x += 0.02) buckets.add(x, 100 + 50 * Math.sin(x));
  buckets.add(-7, 3);
  const [low, high] = buckets.ends(10, 20)!;
  expect(low).toBeCloseTo(50, 0);
  expect(high).toBeCloseTo(150, 0);
  expect(buckets.ends(-8, -6)).toEqual([3, 3]);
  expect(buckets.ends(-5, -1)).toBe(null);
  expect(buckets.ends(200, 300)).toBe(null);
});

test("a line of 120 km has wider buckets, and no value is lost", () => {
  const buckets = new Buckets();
  for (let x = 0; x < 120_000; x += 0.5) buckets.add(x, x);
  expect(buckets.width).toBeGreaterThan(0.2);
  const [low, high] = buckets.ends(0, 120_000)!;
  expect([low, high]).toEqual([0, 119_999.5]);
  expect(buckets.ends(60_000, 60_000.1)![0]).toBeCloseTo(60_000, -1);
});

test("the largest uplift of each support stays", () => {
  const history = new History();
  history.addSupports(1, Float32Array.from([0.01, NaN]));
  history.addSupports(1, Float32Array.from([0.03, 0.02]));
  history.addSupports(0, Float32Array.from([NaN, 0.01]));
  expect(history.uplift[0]).toBeNaN();
  expect([...history.uplift].slice(1).map((one) => Math.round(1000 * one))).toEqual([30, 20]);
});
