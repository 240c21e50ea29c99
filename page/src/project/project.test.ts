import { expect, it } from "vitest";
import { change, changes } from "../state/changes.ts";
import type { RunEntry } from "../state/project.ts";
import { freeName } from "./copy.ts";
import { differences, matches, verdictOf, withUnit } from "./words.ts";
import { sorted } from "./scenarioFields.ts";

const run = (path: string, more: Partial<RunEntry>): RunEntry => ({
  path, verdict: "met", reason: null, name: "a", created: null, speed_m_s: 50, changes: {}, pantographs: [],
  worst: null, max_uplift_at_support_mm: null, ...more,
});

it("takes names that are free", () => {
  expect(freeName("a", ["b"])).toBe("a");
  expect(freeName("a", ["a", "a-2"])).toBe("a-3");
});

it("takes a change back that is the value of the file", () => {
  change("speed", "300 km/h", "275 km/h");
  expect(changes.value).toEqual({ speed: "300 km/h" });
  change("speed", "275 km/h", "275 km/h");
  expect(changes.value).toEqual({});
});

it("gives a bare number the unit that stood there", () => {
  expect(withUnit("250", "320 km/h")).toBe("250 km/h");
  expect(withUnit(" 2.5e2 ", "320km/h")).toBe("2.5e2 km/h");
  expect(withUnit("70 m/s", "320 km/h")).toBe("70 m/s");
  expect(withUnit("70", "80")).toBe("70");
});

it("finds speed and pantographs among the fields of a form", () => {
  const found = [
    { field: "pantographs.1.model", typed: "b" },
    { field: "speed", typed: "275 km/h" },
    { field: "pantographs.0.model", typed: "a" },
    { field: "pantographs.0.mean_force", typed: "100 N" },
  ];
  expect(sorted("x", found)).toEqual({ path: "x", speed: "275 km/h", line: null, pantographs: ["a", "b"] });
  // Of a variant: what it sets, else what its base has.
  const variant = [
    { field: "set.speed", typed: null, inherited: "275 km/h" },
    { field: "set.pantographs.0.model", typed: "b", inherited: null },
  ];
  expect(sorted("x", variant)).toEqual({ path: "x", speed: "275 km/h", line: null, pantographs: ["b"] });
});

it("names what differs between runs, and nothing else", () => {
  const runs = [
    run("r/1", { changes: { "output.motion": "true" } }),
    run("r/2", { changes: { speed: "300 km/h" }, speed_m_s: 83.3 }),
    run("r/3", { name: "b", changes: { speed: "300 km/h" }, speed_m_s: 83.3 }),
  ];
  expect(differences(runs)).toEqual([["a", "speed as in the file"], ["a", "speed 300 km/h"], ["b", "speed 300 km/h"]]);
  expect(differences(runs.slice(1, 2))).toEqual([["a", "speed 300 km/h"]]);
});

it("tells verdicts by word and shape", () => {
  const seen = (["met", "not met", "not judged", "stopped early", "unreadable"] as const).map(verdictOf);
  expect(new Set(seen.map((one) => one.sign)).size).toBe(5);
  expect(seen.map((one) => one.word)).toEqual(["met", "not met", "not judged", "stopped early", "unreadable"]);
});

it("finds a model by all words that are typed", () => {
  const entry = { path: "shipped:line/a", kind: "line" as const, name: "germany-re-200", description: "Re 200 of 80 m spans" };
  expect(matches(entry, "re 80")).toBe(true);
  expect(matches(entry, "re 90")).toBe(false);
});
