import { describe, expect, test } from "vitest";
import { newState, ranges, sample } from "./state.ts";
import { Store } from "./store.ts";
import { bytesOf, lastAt, Track } from "./track.ts";
import { everyAt, wanted } from "./wanted.ts";

const piece = (first: number, ...values: number[]) => ({ first, values: Float32Array.from(values) });
const sizes = { wires: [6], spatial: false, droppers: 3, supports: 2, pantographs: 1 };

describe("a track", () => {
  test("finds the last time that is not later", () => {
    expect([-1, 0, 0.5, 2, 9].map((time) => lastAt([0, 1, 2], time))).toEqual([-1, 0, 0, 2, 2]);
  });

  test("is sorted, however its pieces arrive, and replaces the same piece", () => {
    const track = new Track();
    for (const time of [3, 1, 2, 1]) track.add(time, piece(0, time));
    track.add(2, piece(7, 1));
    expect(track.times).toEqual([1, 2, 3]);
    expect(track.entries.map((pieces) => pieces.length)).toEqual([1, 2, 1]);
    expect(track.bytes).toBe(4 * bytesOf(piece(0, 1)));
  });

  test("forgets both ends, and counts what is left", () => {
    const track = new Track();
    for (const time of [0, 1, 2, 3, 4]) track.add(time, piece(0, time));
    track.keep(0.5, 3);
    expect(track.times).toEqual([1, 2, 3]);
    expect(track.bytes).toBe(3 * bytesOf(piece(0, 1)));
  });
});

describe("a store", () => {
  const filled = (budget: number) => {
    const store = new Store(budget);
    for (let at = 0; at < 100; at++) {
      store.add("pantograph.0", at, piece(0, at, 1, 5, 0));
      store.add("wire.0.up", at, piece(0, ...Array<number>(250).fill(at)));
    }
    store.cover({ from: 0, to: 99, every: 0 });
    return store;
  };

  test("stays within its bytes and keeps what is near the clock", () => {
    const whole = filled(1e9).bytes;
    const store = filled(whole / 4);
    expect(store.trim(40)).toBe(true);
    expect(store.bytes).toBeLessThanOrEqual(whole / 4);
    expect(store.moments[0]).toBeLessThan(40);
    expect(store.moments.at(-1)).toBeGreaterThan(40);
    // What was forgotten is no longer said to be there.
    expect(store.reach(40, 1, 0)).toBe(store.moments.at(-1));
    expect(store.reach(40, -1, 0)).toBe(store.moments[0]);
    expect(store.trim(40)).toBe(false);
  });

  test("joins ranges, and coarse ones do not count as fine", () => {
    const store = new Store();
    store.cover({ from: 0, to: 1, every: 0 });
    store.cover({ from: 1, to: 2, every: 0 });
    store.cover({ from: 1.5, to: 5, every: 0.3 });
    expect(store.reach(0.5, 1, 0)).toBe(2);
    expect(store.reach(0.5, 1, 0.3)).toBe(5);
    expect(store.reach(4, -1, 0.3)).toBe(0);
    expect(store.reach(4, -1, 0)).toBe(4);
  });
});

describe("what is asked for", () => {
  const now = { time: 2, rate: 1, start: 0, edge: 10, row: 0.005 };

  test("moments are as far apart as the screen shows them", () => {
    expect(everyAt(0.05, 0.005)).toBe(0);
    expect(everyAt(20, 0.005)).toBeCloseTo(16 / 60);
    expect(everyAt(2.1, 0.005)).toBe(everyAt(2.9, 0.005));
  });

  test("ahead of the clock first, then behind it, then nothing", () => {
    const store = new Store();
    const asked = [];
    for (let wish = wanted(store, now); wish; wish = wanted(store, now)) {
      asked.push([wish.from_s, wish.to_s]);
      store.cover({ from: wish.from_s, to: wish.to_s, every: wish.every_s });
    }
    expect(asked).toEqual([[2, 3.5], [3.5, 5], [5, 6.5], [0.5, 2], [0, 0.5]]);
  });

  test("at the edge of a live run its last rows are asked for, and nothing beyond", () => {
    const store = new Store();
    store.cover({ from: 0, to: 9.998, every: 1 / 60 });
    expect(wanted(store, { ...now, time: 9.9 })).toEqual({ from_s: 9.998, to_s: 10, every_s: 1 / 60 });
    store.cover({ from: 9.998, to: 10, every: 1 / 60 });
    expect(wanted(store, { ...now, time: 10 })).toBe(null);
  });
});

describe("the state at a time", () => {
  const store = () => {
    const made = new Store();
    made.add("wire.0.up", 0, piece(1, 1, 2));
    made.add("wire.0.up", 1, piece(2, 4, 8));
    made.add("pantograph.0", 0, piece(0, 10, 100, 5, NaN, 0.1));
    made.add("pantograph.0", 1, piece(0, 20, 200, 5.2, NaN, 0.3));
    made.add("droppers", 0, piece(1, 50, 0));
    return made;
  };

  test("is linear between moments, also where windows moved on", () => {
    const state = newState(sizes);
    sample(store(), 0.25, 1, state);
    expect([...state.wires[0]!.up]).toEqual([0, 0.75, 2.5, 2, 0, 0]);
    expect([...state.wires[0]!.velocity]).toEqual([0, 0, 2, 0, 0, 0]);
    expect(state.wires[0]!.moving).toEqual([[1, 4]]);
    expect(state.pantographs[0]!.position).toBeCloseTo(12.5);
    expect(state.pantographs[0]!.masses[0]).toBeCloseTo(0.15);
    expect(state.pantographs[0]!.uplift).toBeNaN();
    expect([...state.droppers]).toEqual([NaN, 50, 0]);
    expect(state.complete).toBe(true);
  });

  test("a window that has gone by leaves the wire at rest", () => {
    const state = newState(sizes);
    const made = store();
    sample(made, 0, 1, state);
    made.add("wire.0.up", 2, piece(4, 3));
    sample(made, 2, 1, state);
    expect([...state.wires[0]!.up]).toEqual([0, 0, 0, 0, 3, 0]);
  });

  test("moments that are far apart are not mixed, and said not to be complete", () => {
    const state = newState(sizes);
    sample(store(), 0.3, 0.1, state);
    expect(state.pantographs[0]!.position).toBe(10);
    expect(state.complete).toBe(false);
  });

  test("ranges that touch are one", () => {
    expect(ranges([piece(4, 1, 1), piece(0, 1, 1), piece(2, 1, 1), piece(9, 1, 1)], 10)).toEqual([[0, 6], [9, 10]]);
  });
});
