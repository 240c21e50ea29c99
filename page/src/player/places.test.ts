// @vitest-environment happy-dom
import { beforeEach, expect, test } from "vitest";
import { clock } from "../state/selection.ts";
import { inWords, wentTo, worst } from "../state/worst.ts";
import { jump, setEnds } from "./clock.ts";
import { placeNow, stepWorst } from "./places.ts";
import { begin, store } from "./player.ts";

beforeEach(() => {
  begin();
  setEnds(0, 10, false);
  // 80 m/s from 100 m on; of the rest no frame has come.
  for (const time of [0, 0.5, 1]) store.add("pantograph.0", time, { first: 0, values: Float32Array.of(100 + 80 * time, 100, 5, NaN) });
});

test("a place is known where no frame has come", () => {
  jump(0.5);
  expect(placeNow()).toBe(140);
  jump(0.75);
  expect(placeNow()).toBeCloseTo(160);
  jump(4);
  expect(placeNow()).toBeCloseTo(420);
});

test("keys that follow one another at once go on from place to place", () => {
  worst.value = [240, 320, 600].map((position_m) => ({ position_m, force_N: 210.4 }));
  const times = [1, 1, 1, -1, -1].map((way) => (stepWorst(way as 1 | -1), clock.time_s.value));
  // A second before each place.
  expect(times.map((time) => Math.round(100 + 80 * (time + 1)))).toEqual([240, 320, 600, 320, 240]);
  expect(inWords(wentTo.value!)).toBe("1 of 3: 210 N");
});
