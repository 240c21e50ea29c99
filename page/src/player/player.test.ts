// @vitest-environment happy-dom
import { beforeEach, expect, test } from "vitest";
import { clock } from "../state/selection.ts";
import { play, setEnds, tick } from "./clock.ts";
import { everyAt } from "./motion/wanted.ts";
import { Pace } from "./pace.ts";
import { begin, limit, pace, scene, store } from "./player.ts";

const ROW = 0.005; // s, as a run has it at 300 km/h

/** Rows from `from` to `to` as they are asked for at a rate, and come. */
function received(from: number, to: number, rate: number): void {
  const apart = Math.max(everyAt(rate, ROW), ROW);
  for (let number = 0; from + number * apart <= to; number++) {
    store.add("pantograph.0", from + number * apart, { first: 0, values: new Float32Array(4) });
  }
}

beforeEach(() => {
  begin();
  scene.value = {
    geometry: { name: "", spatial: false, height_m: 5, spans: [], wires: [], droppers: [], supports: [] },
    pantographs: [], row_s: ROW, wires: true, search: null,
  };
  [clock.time_s.value, clock.rate.value, clock.live.value] = [1, 1, false];
  pace.forget();
});

test.each([2, 4, 10, 40])("a run that is computed %d times faster than real time is followed", (speed) => {
  [clock.live.value, pace.value] = [true, speed];
  received(1, 5, speed);
  expect(limit(4)).toBe(4);
});

test("at the rate of the player nothing is shown between moments that are farther apart", () => {
  pace.value = 10;
  received(1, 5, 10);
  expect(limit(4)).toBe(1);
});

test("the end of a run is reached where its last moment is less than their distance before it", () => {
  received(1, 5, 1);
  setEnds(0, store.moments.at(-1)! + 0.011, true);
  play();
  setEnds(0, clock.end_s.value, false);
  for (let frames = 0; frames < 400; frames++) tick(1 / 60, limit);
  expect([clock.time_s.value, clock.playing.value]).toEqual([clock.end_s.value, false]);
  play();
  expect(clock.time_s.value).toBe(0);
});

test("the speed of a run is known from the second word of its edge, and is a mean from then on", () => {
  const found = new Pace();
  found.reached(10, 1000);
  expect(found.value).toBe(1);
  found.reached(14, 1500);
  expect(found.value).toBe(8);
  found.reached(15, 1510); // too near to tell a speed
  expect(found.value).toBe(8);
  found.reached(15, 2510);
  expect(found.value).toBeCloseTo(6.4);
});
