import { describe, expect, it } from "vitest";
import type { Figure, Layer } from "./figure.ts";
import { told } from "./pointer.ts";

const same = { x: (value: number) => value, y: (value: number) => value };
const tips = [
  { label: "force", values: "y", unit: "N", form: "0.0" },
  { label: "position", values: "x", unit: "m", form: "0.0" },
];
const curve = { kind: "curve", name: "a", x: Float32Array.of(0, 50, 100), y: Float32Array.of(10, 20, 30), tips } as unknown as Layer;
const bars = {
  kind: "bars", name: "b", left: Float32Array.of(0), right: Float32Array.of(10), low: Float32Array.of(0), high: Float32Array.of(60),
  tips: [{ label: "", values: { texts: ["span 7"] }, unit: "", form: "" }],
} as unknown as Layer;
const figure = (...layers: Layer[]) => ({ layers }) as unknown as Figure;
const none = () => false;

describe("what stands under the pointer", () => {
  it("is the nearest sample, with its numbers", () => {
    expect(told(figure(curve), { x: 48, y: 21 }, 48, 21, same, none)).toBe("force 20.0 N · position 50.0 m");
  });
  it("is nothing far away, or where the layer is hidden", () => {
    expect(told(figure(curve), { x: 75, y: 20 }, 75, 20, same, none)).toBe("");
    expect(told(figure(curve), { x: 48, y: 21 }, 48, 21, same, () => true)).toBe("");
  });
  it("is the bar that the pointer is in", () => {
    expect(told(figure(bars), { x: 5, y: 30 }, 5, 30, same, none)).toBe("span 7");
    expect(told(figure(bars), { x: 5, y: 70 }, 5, 70, same, none)).toBe("");
  });
  it("is the cell of a map", () => {
    const map = {
      kind: "map", name: "", x: [0, 2], y: [0, 2], shape: [2, 2], values: Float32Array.of(1, 2, 3, 4),
      tips: [{ label: "velocity", values: "x", unit: "m/s", form: "0.0" }],
    } as unknown as Layer;
    expect(told(figure(map), { x: 1.5, y: 0.5 }, 0, 0, same, none)).toBe("velocity 2.0 m/s");
    expect(told(figure(map), { x: 0.5, y: 1.5 }, 0, 0, same, none)).toBe("velocity 3.0 m/s");
    expect(told(figure(map), { x: 2.5, y: 1.5 }, 0, 0, same, none)).toBe("");
  });
});
