import { describe, expect, it } from "vitest";
import { figureOf, unpacked } from "./figure.ts";

const packed = (...values: number[]) => btoa(String.fromCharCode(...new Uint8Array(new Float32Array(values).buffer)));

describe("figures as the server tells them", () => {
  it("have their numbers, gaps included", () => {
    expect([...unpacked(packed(1, -2.5, NaN))]).toEqual([1, -2.5, NaN]);
    expect(unpacked("")).toHaveLength(0);
  });

  it("keep what is no series of numbers", () => {
    const figure = figureOf({
      key: "k",
      layers: [
        { kind: "strip", axis: "x", low: 1, high: 2, name: "section", tips: [] },
        { kind: "map", x: [0, 3], y: [0, 1], values: packed(1, 2, 3), shape: [1, 3], tips: [] },
        {
          kind: "curve",
          x: packed(0, 1),
          y: packed(5, 6),
          colour: "pantograph_1",
          tips: [
            { label: "force", unit: "N", form: "0.0", values: "y" },
            { label: "time", unit: "s", form: "0.00", values: { numbers: packed(7, 8) } },
            { label: "", unit: "", form: "", values: { texts: ["a", "b"] } },
          ],
        },
      ],
    });
    expect(figure.layers[0]).toMatchObject({ axis: "x", low: 1, high: 2 });
    expect(figure.layers[1]).toMatchObject({ x: [0, 3], shape: [1, 3], values: new Float32Array([1, 2, 3]) });
    expect(figure.layers[2]).toMatchObject({ x: new Float32Array([0, 1]), colour: "pantograph_1" });
    expect(figure.layers[2]!.tips[1]!.values).toEqual({ numbers: new Float32Array([7, 8]) });
    expect(figure.layers[2]!.tips[2]!.values).toEqual({ texts: ["a", "b"] });
  });
});
