// @vitest-environment happy-dom
import { beforeEach, expect, it } from "vitest";
import { project, type ProjectView } from "../state/project.ts";
import { scenario, varied, vary, way, type VariedField } from "./defining.ts";
import { followDraft } from "./draft.ts";

const view = (folder: string): ProjectView => ({ name: "p", folder, version: "", models: [], library: [], studies: [], runs: [], measured: [] });
const tension: VariedField = {
  field: "line.tension", label: "Tension", group: "", description: "", typed: "20 kN", unit: "kN", value: 20, offered: [18, 22], limits: "",
};

/** Define a study, leave the page, and come back to it with nothing. */
function reload(folder: string): void {
  scenario.value = "praks-250";
  way.value = "sample";
  vary(tension);
  const end = followDraft();
  dispatchEvent(new Event("pagehide"));
  [scenario.value, way.value, varied.value] = [null, "grid", []];
  dispatchEvent(new Event("pagehide"));
  end();
  project.value = view(folder);
  followDraft()();
}

beforeEach(() => {
  sessionStorage.clear();
  [scenario.value, way.value, varied.value] = [null, "grid", []];
  project.value = view("/p");
});

it("is kept over a reload", () => {
  reload("/p");
  expect([scenario.value, way.value, varied.value.map(({ low }) => low)]).toEqual(["praks-250", "sample", ["18"]]);
});

it("belongs to its folder", () => {
  reload("/other");
  expect([scenario.value, varied.value]).toEqual([null, []]);
});

it("does not replace one that is being defined", () => {
  reload("/p");
  varied.value = [];
  followDraft();
  expect(varied.value).toEqual([]);
});
