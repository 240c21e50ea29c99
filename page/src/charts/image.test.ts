import { describe, expect, it } from "vitest";
import { pixel, shades } from "./colours.ts";
import type { Scale } from "./figure.ts";
import { pixels } from "./image.ts";

const scale: Scale = { title: "", label: "", unit: "", low: -1, high: 1, order: ["#000000", "#ff0000"], under: "", under_label: "" };

describe("maps", () => {
  it("have their first row at the bottom, and holes where there is no number", () => {
    const found = pixels(Float32Array.of(-1, NaN, 1, 1), [2, 2], scale, null);
    expect([...found]).toEqual([pixel("#ff0000"), pixel("#ff0000"), pixel("#000000"), 0]);
  });
  it("have the end of the scale beyond it, or the colour of what is below", () => {
    expect(pixels(Float32Array.of(9), [1, 1], scale, null)[0]).toBe(pixel("#ff0000"));
    expect(pixels(Float32Array.of(-9), [1, 1], scale, null)[0]).toBe(pixel("#000000"));
    expect(pixels(Float32Array.of(-9), [1, 1], scale, pixel("#00ff00"))[0]).toBe(pixel("#00ff00"));
  });
  it("have shades between the colours of an order", () => {
    const table = shades(["#000000", "#ff0000", "#ffff00"], 5);
    expect([...table]).toEqual(["#000000", "#800000", "#ff0000", "#ff8000", "#ffff00"].map(pixel));
  });
});
