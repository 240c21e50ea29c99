import { expect, test } from "vitest";
import type { ModelEntry, RunEntry } from "../state/project.ts";
import { isPart, markOf, runWords } from "./standing.ts";

const run: RunEntry = {
  path: "runs/a", verdict: "met", reason: null, name: "a", created: null, line: "l", line_digest: "1", speed_m_s: 50,
  changes: { speed: "300 km/h", "output.motion": "true" }, pantographs: [], worst: null, max_uplift_at_support_mm: null,
};

test("a verdict names its run, and what is recorded is no part of the name", () => {
  expect(runWords(run)).toBe("a, speed 300 km/h");
});

test("a verdict of another run than the bar would run says so", () => {
  const changes = { speed: "300 km/h" };
  expect(markOf(run, "a", changes, true)).toBe("");
  expect(markOf(run, "a", changes, null)).toBe("");
  expect(markOf(run, "b", changes, null)).toBe("of another scenario");
  expect(markOf(run, "a", changes, false)).toBe("outdated: changed since");
  expect(markOf(run, "a", {}, false)).toBe("of another variant");
  expect(markOf(run, null, {}, null)).toBe("");
});

test("a file is part of a scenario that names it, its base, or a change", () => {
  const model = (path: string, kind: ModelEntry["kind"], names: string[] = []): ModelEntry => ({ path, kind, name: path, description: "", names });
  const models = [
    model("v.yaml", "scenario", ["s.yaml"]), model("s.yaml", "scenario", ["line.yaml"]), model("line.yaml", "line", ["droppers.csv"]), model("other.yaml", "line"),
  ];
  const fields = { path: "v.yaml", speed: null, speedField: "speed", line: null, pantographs: ["dsa-250"] };
  const part = (path: string, changes = {}, found: typeof fields | null = fields) => isPart(path, "v.yaml", found, changes, models);
  expect(["v.yaml", "s.yaml", "line.yaml"].map((path) => part(path))).toEqual([true, true, true]);
  expect(part("other.yaml")).toBe(false);
  expect(part("other.yaml", { line: "other.yaml" })).toBe(true);
  expect(part("shipped:pantograph/dsa-250")).toBe(true);
  expect(part("shipped:pantograph/dsa-250", { "pantographs.0.model": "wbl-85" })).toBe(false);
  expect(part("other.yaml", {}, null)).toBeNull();
  expect(part("shipped:line/re-250")).toBeNull();
});
