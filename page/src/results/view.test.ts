import { describe, expect, it } from "vitest";
import { placesOf, ticks, zoomedPart } from "./view.ts";

const part = { x: [0, 100] as [number, number], t: [0, 2] as [number, number] };
const frame = { left: 10, top: 20, width: 200, height: 100 };

describe("space and time", () => {
  it("have places on the canvas, time upwards", () => {
    const places = placesOf(part, frame);
    expect(places.x(50)).toBe(110);
    expect(places.t(0)).toBe(120);
    expect(places.t(2)).toBe(20);
    expect(places.backX(places.x(37))).toBeCloseTo(37);
    expect(places.backT(places.t(1.3))).toBeCloseTo(1.3);
  });
  it("are enlarged around a place, within all there is", () => {
    const found = zoomedPart(part, { x: 100, t: 2 }, 0.5, part);
    expect(found).toEqual({ x: [50, 100], t: [1, 2] });
    expect(zoomedPart(found, { x: 100, t: 2 }, 10, part)).toEqual(part);
  });
  it("have round numbers along the axes", () => {
    expect(ticks([0, 100], 5)).toEqual({ at: [0, 20, 40, 60, 80, 100], step: 20 });
    const fine = ticks([1.01, 1.05], 4);
    expect(fine.step).toBeCloseTo(0.01);
    expect(fine.at.length).toBeGreaterThan(3);
  });
});
