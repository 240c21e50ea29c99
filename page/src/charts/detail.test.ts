import { describe, expect, it } from "vitest";
import { isWhole, loadedBy, question } from "./detail.ts";
import type { Figure } from "./figure.ts";

const all: [number, number] = [0, 1000];
const figure = (length: number, samples: number) =>
  ({ layers: [{ kind: "curve", x: new Float32Array(length), samples }, { kind: "rules" }] }) as unknown as Figure;

describe("questions for more samples", () => {
  it("asks for all at first, with two samples on a pixel and as much beside", () => {
    expect(question(all, all, 800, null)).toEqual({ points: 4800 });
  });

  it("asks for nothing where all samples are there", () => {
    const loaded = loadedBy({ points: 4800 }, figure(500, 500));
    expect(loaded).toEqual({ range: null, whole: true });
    expect(question([10, 11], all, 800, loaded)).toBeNull();
  });

  it("asks anew where too few samples are in the range", () => {
    const loaded = loadedBy({ points: 4800 }, figure(4800, 1e6));
    expect(loaded.whole).toBe(false);
    expect(question(all, all, 800, loaded)).toBeNull();
    expect(question([0, 500], all, 800, loaded)).toBeNull();
    expect(question([400, 500], all, 800, loaded)).toEqual({ from: 300, to: 600, points: 4800 });
  });

  it("asks for what lies beside a range that was loaded, though that is whole", () => {
    const loaded = loadedBy({ from: 300, to: 600, points: 4800 }, figure(100, 1e6));
    expect(loaded.whole).toBe(true);
    expect(question([400, 401], all, 800, loaded)).toBeNull();
    expect(question([550, 650], all, 800, loaded)).toEqual({ from: 450, to: 750, points: 4800 });
  });

  it("never asks for more than the server gives", () => {
    expect(question(all, all, 20_000, null)).toEqual({ points: 40_000 });
  });

  it("knows a figure without long curves as whole", () => {
    expect(isWhole(figure(5, 5))).toBe(true);
    expect(isWhole(figure(4, 5))).toBe(false);
  });
});
