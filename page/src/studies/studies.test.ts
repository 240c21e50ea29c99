import { expect, test } from "vitest";
import { BUCKETS, bucketOf } from "./colours.ts";
import { columnsOf, extent, kept, shown, sorted, variantOf } from "./columns.ts";
import { changes } from "../state/changes.ts";
import {
  aimAt, amount, asChanged, columnName, definition, fileOf, freeName, name, outputs, sample, scenario, size, varied, vary, way, withChanges, type VariedField,
} from "./defining.ts";
import type { Definition, Row } from "./open.ts";
import { layout, lineAt, pointAt } from "./parallel.ts";
import { limitsOf, verdictOf, verdictOn, wordsOf } from "./verdicts.ts";

const about: Definition = {
  name: "s", description: "", scenario: "x", design: "grid", count: 4,
  variables: [{ name: "tension", field: "line.contact_wire.tension", unit: "kN", scale: 1000, label: "Contact wire: tension", description: "" }],
  outputs: [{ name: "sigma", expression: "std_force_N", unit: "N", label: "standard deviation σ", of: "", decimals: 1, description: "", objective: null, bounds: null }],
};
const rows: Row[] = [
  [1, "done", 20000, 30, "", 0.1],
  [2, "done", 22000, 10, "", 0.1],
  [3, "failed", 24000, null, "the line has no equilibrium", 0.1],
  [4, "done", 26000, 20, "", 0.1],
];
const columns = columnsOf(about);

test("a variable is shown in the unit of its file, an output as it is", () => {
  expect(columns.map((column) => column.number(rows[0]!))).toEqual([20, 30]);
  expect(columns[1]!.number(rows[2]!)).toBeNull();
  expect(extent(columns[0]!, rows)).toEqual([20, 26]);
  expect(shown(1234567)).toBe("1.235e+6");
});

test("brushes and words leave what fits all of them; a row without a value fits no brush", () => {
  expect(kept(rows, columns, { tension: [21, 25] }, "")).toEqual([1, 2]);
  expect(kept(rows, columns, { tension: [21, 25], sigma: [0, 15] }, "")).toEqual([1]);
  expect(kept(rows, columns, { sigma: [-Infinity, Infinity] }, "")).toEqual([0, 1, 3]);
  expect(kept(rows, columns, {}, "equilibrium")).toEqual([2]);
  expect(kept(rows, columns, {}, "4")).toEqual([3]);
});

test("rows are sorted by a column, those without a value last either way", () => {
  const by = (down: boolean) => sorted([0, 1, 2, 3], rows, columns, { by: "sigma", down }).map((at) => variantOf(rows[at]!));
  expect(by(false)).toEqual([2, 4, 1, 3]);
  expect(by(true)).toEqual([1, 4, 2, 3]);
});

test("the line of a variant is found where it passes, and places on axes are read back", () => {
  const picture = { columns, rows, places: [0, 1, 3], brushes: {}, coloured: null, picked: null, criteria: [], limits: {} };
  const on = layout(picture, 400, 300);
  expect(on.value(0, on.y(0, 21.5))).toBeCloseTo(21.5, 9);
  const x = (on.x(0) + on.x(1)) / 2;
  const y = (on.y(0, 22) + on.y(1, 10)) / 2;
  expect(lineAt(picture, 400, 300, x, y + 1)).toBe(2);
  expect(lineAt({ ...picture, places: [0] }, 400, 300, x, y)).toBe(1);
  expect(lineAt(picture, 400, 300, on.x(1) + 30, y)).toBeNull();
  expect(pointAt(picture, 400, 300, 1, on.y(1, 10) - 3)).toBe(2);
  expect(pointAt({ ...picture, places: [] }, 400, 300, 1, 0)).toBeNull();
});

test("colours are of the whole scale and of no other", () => {
  expect([0, 5, 10].map((value) => bucketOf(value, [0, 10]))).toEqual([0, BUCKETS / 2, BUCKETS - 1]);
  expect(bucketOf(null, [0, 10])).toBe(-1);
});

const tension: VariedField = {
  field: "line.contact_wire.tension", label: "Tension", group: "Line contact wire", description: "", typed: "22 kN", unit: "kN", value: 22,
  offered: [19.8, 24.2], limits: "",
};

test("what is ticked becomes the study as its file has it", () => {
  scenario.value = "own.yaml";
  name.value = "my study";
  outputs.value = ["std_force_N"];
  varied.value = [];
  expect(definition.value).toBeNull();
  vary(tension);
  vary({ ...tension, field: "line.messenger_wire.tension" });
  expect(definition.value).toEqual({
    name: "my study", scenario: "own.yaml", set: null, design: { kind: "grid" }, outputs: ["std_force_N"],
    variables: {
      tension: { field: "line.contact_wire.tension", range: ["19.8 kN", "24.2 kN"], count: 5 },
      tension_2: { field: "line.messenger_wire.tension", range: ["19.8 kN", "24.2 kN"], count: 5 },
    },
  });
  way.value = "sample";
  sample.value = "sobol";
  expect(definition.value?.design).toEqual({ kind: "sobol", count: 32 });
  expect(definition.value?.variables["tension"]).toEqual({ field: "line.contact_wire.tension", range: ["19.8 kN", "24.2 kN"] });
});

test("all variants have what the run bar changes, but for what is varied", () => {
  scenario.value = "own.yaml";
  varied.value = [];
  vary(tension);
  changes.value = { speed: "300 km/h", "line.contact_wire.tension": "17 kN", "pantographs.0.model": "dsa-250" };
  expect(definition.value?.set).toEqual({ speed: "300 km/h", "pantographs.0.model": "dsa-250" });
  withChanges.value = false;
  expect(definition.value?.set).toBeNull();
  withChanges.value = true;
  changes.value = {};
  expect(definition.value?.set).toBeNull();
});

test("the range of a field begins around the value that the run bar gives it", () => {
  expect(asChanged(tension, undefined)).toBe(tension);
  expect(asChanged(tension, "11 kN")).toEqual({ ...tension, typed: "11 kN", value: 11, offered: [9.9, 12.1] });
  expect(asChanged(tension, "11000 N")).toEqual({ ...tension, typed: "11000 N" });
});

test("a search has the aims and bounds of the outputs that are ticked, and of no others", () => {
  scenario.value = "own.yaml";
  name.value = "best";
  way.value = "optimise";
  size.value = 12;
  outputs.value = ["std_force_N", "max_uplift_at_support_mm", "passed"];
  varied.value = [];
  vary(tension);
  aimAt("max_uplift_at_support_mm", { most: " 90 " });
  aimAt("max_force_N", { aim: "maximise" });
  expect(definition.value?.design).toEqual({
    kind: "optimise", trials: 12, objectives: { std_force_N: "minimise" },
    constraints: [{ output: "max_uplift_at_support_mm", at_most: 90 }, { output: "passed", at_least: 1 }],
  });
  expect(definition.value?.variables["tension"]).not.toHaveProperty("count");
  way.value = "grid";
  expect(definition.value?.design).toEqual({ kind: "grid" });
});

test("a name that is taken is numbered on", () => {
  expect(freeName("a-study", ["b"])).toBe("a-study");
  expect(freeName("a-study", ["a-study", "a-study-2"])).toBe("a-study-3");
  expect(freeName("a-study-2", ["a-study-2"])).toBe("a-study-3");
});

test("limits of an output are told by row, and a row's verdict on it is the worst", () => {
  const criteria = [
    { title: "standard deviation σ", of: "", output: "sigma", relation: "<=", tolerance: 0, source: "A" },
    { title: "mean force", of: "", output: "mean", relation: ">=", tolerance: 1, source: "C" },
    { title: "σ again", of: "", output: "sigma", relation: "<=", tolerance: 0, source: "A" },
  ];
  const judged: Row[] = [
    [1, "done", 20000, 30, "not met", [[0, "not met", 28], [2, "met", 40]], "", 0.1],
    [2, "done", 22000, 10, "met", [[0, "met", 31], [2, "met", 40]], "", 0.1],
    [3, "failed", 24000, null, "not judged", [], "it diverged", 0.1],
  ];
  const sigma = columns[1]!;
  expect(judged.map((row) => verdictOn(sigma, row, criteria))).toEqual(["not met", "met", null]);
  expect(verdictOn(columns[0]!, judged[0]!, criteria)).toBeNull();
  expect(judged.map(verdictOf)).toEqual(["not met", "met", "not judged"]);
  expect(limitsOf(sigma, judged, criteria).map(wordsOf)).toEqual(["limit 28 to 31, by variant", "limit ≤ 40"]);
  const bound = { ...sigma, output: { ...sigma.output!, bounds: { at_least: 1, at_most: null } } };
  expect(limitsOf(bound, [], criteria).map(wordsOf)).toEqual(["limit ≥ 1"]);
  expect(wordsOf({ sign: "≤", low: 34.24, high: 34.6, source: "" })).toBe("limit 34.24 to 34.60, by variant");
  // An axis is lengthened by a limit that is near its values, and by none that is far from them.
  const picture = { columns, rows: judged, places: [0, 1], brushes: {}, coloured: null, picked: null, criteria, limits: { sigma: limitsOf(sigma, judged, criteria) } };
  expect(layout(picture, 400, 300).extents[1]).toEqual([10, 40]);
  const far = { ...picture, limits: { sigma: [{ sign: "≤", low: 300, high: 300, source: "" }] } };
  expect(layout(far, 400, 300).extents[1]).toEqual([10, 30]);
});

test("amounts have the unit of the field unless one is typed", () => {
  expect(amount("20", "kN")).toBe("20 kN");
  expect(amount(" 20 N ", "kN")).toBe("20 N");
  expect(amount("0.5", "")).toBe(0.5);
  expect(columnName("Mean σ, N", ["mean_n"])).toBe("mean_n_2");
  expect(fileOf("Größe / 1")).toBe("Größe-1.yaml");
});
