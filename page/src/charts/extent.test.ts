import { describe, expect, it } from "vitest";
import { ends, moved, within, zoomed } from "./extent.ts";
import type { Axis, Layer } from "./figure.ts";

const axis = (more: Partial<Axis> = {}): Axis => ({
  label: "", unit: "", title: "", low: null, high: null, bounds: null, logarithmic: false, categories: [], group: "", form: "", ...more,
});
const curve = (...y: number[]) =>
  ({ kind: "curve", x: Float32Array.from(y.keys()), y: Float32Array.from(y), hidden: false }) as unknown as Layer;

describe("ranges", () => {
  it("are those of the figure where it has them", () => {
    expect(ends(axis({ low: -1, high: 4 }), [curve(100)], "y")).toEqual([-1, 4]);
    const [low, high] = ends(axis({ low: 0 }), [curve(5, 10)], "y");
    expect(low).toBe(0);
    expect(high).toBeCloseTo(10.2);
  });

  it("are around the data, gaps and hidden layers left out", () => {
    const hidden = { ...curve(1000), hidden: true } as Layer;
    expect(ends(axis(), [curve(0, NaN, 100), hidden], "y")).toEqual([-4, 104]);
    expect(ends(axis(), [], "y")[1]).toBeGreaterThan(0);
    expect(ends(axis({ logarithmic: true }), [curve(0, 1, 100)], "y")[0]).toBeGreaterThan(0);
  });

  it("stay within bounds with their extent", () => {
    expect(within([-5, 5], [0, 100])).toEqual([0, 10]);
    expect(within([95, 105], [0, 100])).toEqual([90, 100]);
    expect(within([-50, 500], [0, 100])).toEqual([0, 100]);
    expect(within([-50, 500], null)).toEqual([-50, 500]);
  });

  it("are enlarged around a place that stays where it is", () => {
    expect(zoomed([0, 10], 2, 0.5)).toEqual([1, 6]);
    const [low, high] = zoomed([1, 100], 10, 0.5, true);
    expect(low).toBeCloseTo(10 ** 0.5);
    expect(high).toBeCloseTo(10 ** 1.5);
    expect(moved([0, 10], 0.1)).toEqual([1, 11]);
  });
});
