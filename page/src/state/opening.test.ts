import { afterEach, beforeEach, expect, test } from "vitest";
import { followOpening, openModel } from "./opening.ts";
import { project, type ModelKind, type ProjectView } from "./project.ts";
import { file, scenario } from "./selection.ts";

const view = (...models: [string, ModelKind][]): ProjectView => ({
  name: "p", folder: "/p", version: "", library: [], runs: [], studies: [], measured: [],
  models: models.map(([path, kind]) => ({ path, kind, name: path, description: "" })),
});

let end: () => void;
beforeEach(() => {
  project.value = view(["a.yaml", "scenario"], ["b.yaml", "scenario"], ["line.yaml", "line"]);
  file.value = scenario.value = null;
  end = followOpening();
});
afterEach(() => end());

test("a scenario that is opened is the one that is run; a line that is opened changes nothing of it", () => {
  expect(scenario.value).toBe("a.yaml");
  file.value = "b.yaml";
  expect(scenario.value).toBe("b.yaml");
  openModel("line.yaml", "line");
  expect([file.value, scenario.value]).toEqual(["line.yaml", "b.yaml"]);
});

test("a scenario that is open already is chosen when it is opened again", () => {
  openModel("a.yaml", "scenario");
  scenario.value = "b.yaml";
  openModel("a.yaml", "scenario");
  expect(scenario.value).toBe("a.yaml");
});

test("a file that was just written is chosen as soon as the list has it", () => {
  file.value = "new.yaml";
  expect(scenario.value).toBe("a.yaml");
  project.value = view(["a.yaml", "scenario"], ["new.yaml", "scenario"]);
  expect(scenario.value).toBe("new.yaml");
});

test("a scenario that no list has yet stays, and one that is gone is let go", () => {
  openModel("new.yaml", "scenario");
  project.value = view(["a.yaml", "scenario"], ["b.yaml", "scenario"]);
  expect(scenario.value).toBe("new.yaml");
  project.value = view(["a.yaml", "scenario"], ["new.yaml", "scenario"]);
  project.value = view(["a.yaml", "scenario"]);
  expect(scenario.value).toBe("a.yaml");
});
