import { describe, expect, it } from "vitest";
import type { FormField } from "../editor/formData.ts";
import { firstSliders, PRESAG, presagScale, sliderBy, sliderOf, stepOf, written } from "./sliders.ts";

const field = (own: Partial<FormField>): FormField => ({
  field: "contact_wire.tension", label: "Tension", typed: "22 kN", value: 22000, unit: "N", units: ["N", "kN"],
  minimum: 0.001, maximum: 1e9, description: "", line: 1, required: true, ...own,
});
const presag = field({ field: "span_types.a.droppers.presag", label: "Pre-sag", typed: ["0 mm", "24 mm", 0.05], value: [0, 0.024, 0.05], unit: "m" });
const groups = [{ title: "Wires", fields: [field({}), presag] }];

describe("sliders", () => {
  it("reach around the value in the file, in its unit", () => {
    const slider = sliderOf(field({}))!;
    expect([slider.low, slider.high]).toEqual([15.4, 28.6]);
    expect(slider.changes(24.3)).toEqual({ "contact_wire.tension": "24.3 kN" });
  });
  it("stay inside of the limits, which are in SI", () => {
    expect(sliderOf(field({ maximum: 25000, minimum: 20000 }))).toMatchObject({ low: 20, high: 25 });
  });
  it("keep a number without a unit one", () => {
    expect(sliderOf(field({ typed: 22000, value: 22000 }))!.changes(23500)).toEqual({ "contact_wire.tension": 23500 });
    expect(sliderOf(field({ typed: "fixed", value: "fixed" }))).toBeNull();
    expect(sliderOf(field({ typed: null, value: null }))).toBeNull();
  });
  it("scale all pre-sags together", () => {
    expect(presagScale(groups)!.changes(0.5)).toEqual({ "span_types.a.droppers.presag": ["0 mm", "12 mm", 0.025] });
    expect(presagScale([{ title: "", fields: [field({})] }])).toBeNull();
  });
  it("are found by their fields, items of lists too", () => {
    expect(firstSliders(groups)).toEqual(["contact_wire.tension", PRESAG]);
    expect(sliderBy("span_types.a.droppers.presag.1", groups)).toMatchObject({ start: 24, unit: "mm" });
    expect(sliderBy("nothing", groups)).toBeNull();
  });
  it("have plain steps", () => {
    expect(stepOf(13.2)).toBe(0.2);
    expect(stepOf(0.03)).toBe(0.0005);
    expect(written(24.300000001, 0.2)).toBe("24.3");
    expect(written(24000, 200)).toBe("24000");
  });
});
