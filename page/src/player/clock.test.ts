import { beforeEach, expect, test } from "vitest";
import { clock } from "../state/selection.ts";
import { changeRate, follow, jump, pause, play, setEnds, step, tick } from "./clock.ts";

beforeEach(() => {
  pause();
  setEnds(0, 10, false);
  jump(0);
  clock.rate.value = 1;
});

test("plays at its rate, and stops at the end of a whole run", () => {
  clock.rate.value = 5;
  play();
  tick(0.5);
  expect(clock.time_s.value).toBeCloseTo(2.5);
  tick(9);
  expect([clock.time_s.value, clock.playing.value]).toEqual([10, false]);
  play();
  expect(clock.time_s.value).toBe(0);
});

test("plays from the start where less than a frame is left", () => {
  // A stored run may end a row later than it did while it was computed.
  setEnds(0, 10.005, false);
  jump(10);
  play();
  expect(clock.time_s.value).toBe(0);
});

test("waits for frames that are not there", () => {
  play();
  tick(0.5, () => 0.2);
  expect([clock.time_s.value, clock.playing.value]).toEqual([0.2, true]);
});

test("follows a run that grows, and plays its rest when it has ended", () => {
  setEnds(0, 4, true);
  follow();
  expect([clock.time_s.value, clock.live.value, clock.playing.value]).toEqual([4, true, true]);
  setEnds(0, 6, true);
  tick(0.05);
  expect(clock.time_s.value).toBeGreaterThan(4);
  expect(clock.time_s.value).toBeLessThan(6);
  tick(5);
  expect([clock.live.value, clock.playing.value]).toEqual([true, true]);
  setEnds(0, 7, false);
  tick(5);
  expect([clock.time_s.value, clock.live.value, clock.playing.value]).toEqual([7, false, false]);
});

test("a clock that reaches the edge of a growing run follows it", () => {
  setEnds(0, 1, true);
  clock.rate.value = 20;
  play();
  tick(1);
  expect(clock.live.value).toBe(true);
});

test("jumps stay within the run and leave the edge; steps pause", () => {
  setEnds(1, 10, true);
  follow();
  jump(-3);
  expect([clock.time_s.value, clock.live.value]).toEqual([1, false]);
  play();
  step(1, 0.02);
  expect([clock.time_s.value, clock.playing.value]).toEqual([1.02, false]);
});

test("rates go through their list", () => {
  changeRate(1);
  expect(clock.rate.value).toBe(2);
  clock.rate.value = 0.05;
  changeRate(-1);
  expect(clock.rate.value).toBe(0.05);
});
