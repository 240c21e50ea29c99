// @vitest-environment happy-dom
import { describe, expect, it } from "vitest";
import { pressed, type Handle } from "./gestures.ts";

function handle() {
  const state = { x: [0, 100] as [number, number], at: null as number | null, reset: 0 };
  const found: Handle = {
    x: () => state.x,
    bounds: [0, 1000],
    logarithmic: false,
    at: (px) => px,
    width: () => 100,
    show: (x) => (state.x = x),
    reset: () => state.reset++,
    point: (x) => (state.at = x),
    pointed: () => state.at,
  };
  return { state, found };
}
const key = (name: string, shiftKey = false) => new KeyboardEvent("keydown", { key: name, shiftKey });

describe("keys on a chart", () => {
  it("move and enlarge its range, within the bounds", () => {
    const { state, found } = handle();
    expect(pressed(key("ArrowRight"), found)).toBe(true);
    expect(state.x).toEqual([10, 110]);
    pressed(key("ArrowLeft"), found);
    pressed(key("ArrowLeft"), found);
    expect(state.x).toEqual([0, 100]);
    pressed(key("+"), found);
    expect(state.x[1] - state.x[0]).toBeCloseTo(100 / 1.2);
    pressed(key("0"), found);
    expect(state.reset).toBe(1);
  });
  it("put the cursor somewhere, and enlarge around it", () => {
    const { state, found } = handle();
    pressed(key("ArrowRight", true), found);
    expect(state.at).toBe(51);
    pressed(key("+"), found);
    expect((51 - state.x[0]) / (state.x[1] - state.x[0])).toBeCloseTo(0.51);
  });
  it("leave all others alone", () => {
    const { state, found } = handle();
    expect(pressed(key("q"), found)).toBe(false);
    expect(pressed(key(" "), found)).toBe(false);
    expect(state.x).toEqual([0, 100]);
  });
});
