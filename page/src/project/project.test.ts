import { expect, it, vi } from "vitest";
import { change, changes } from "../state/changes.ts";
import type { Criterion } from "../results/told.ts";
import type { RunEntry } from "../state/project.ts";
import { freeName } from "./copy.ts";
import { differences, leadingWords, matches, verdictOf, withUnit } from "./words.ts";
import { canRun, newestRun } from "./running.ts";
import { aboutSpeed, inWords, refused, typeSpeed } from "./speed.ts";
import { scenario } from "../state/selection.ts";
import { sorted } from "./scenarioFields.ts";

const run = (path: string, more: Partial<RunEntry>): RunEntry => ({
  path, verdict: "met", reason: null, name: "a", created: null, line: "re-250", line_digest: "1", speed_m_s: 50, changes: {}, pantographs: [],
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
  expect(sorted("x", found)).toEqual({ path: "x", speed: "275 km/h", speedField: "speed", line: null, pantographs: ["a", "b"] });
  // Of a variant: what it sets, else what its base has.
  const variant = [
    { field: "set.speed", typed: null, inherited: "275 km/h" },
    { field: "set.pantographs.0.model", typed: "b", inherited: null },
  ];
  expect(sorted("x", variant)).toEqual({ path: "x", speed: "275 km/h", speedField: "set.speed", line: null, pantographs: ["b"] });
  expect(sorted("x", [{ field: "line", typed: "a-line.yaml" }]).line).toBe("a-line.yaml");
});

it("names what differs between runs, and nothing else", () => {
  const runs = [
    run("r/1", { changes: { "output.motion": "true" } }),
    run("r/2", { changes: { speed: "300 km/h" }, speed_m_s: 83.3 }),
    run("r/3", { name: "b", changes: { speed: "300 km/h" }, speed_m_s: 83.3 }),
  ];
  expect(differences(runs)).toEqual([["a", "as in the file"], ["a", "Speed 300 km/h"], ["b", "Speed 300 km/h"]]);
  expect(differences(runs.slice(1, 2))).toEqual([["a", "Speed 300 km/h"]]);
});

it("finds the newest run that can be read", () => {
  expect(newestRun([])).toBeNull();
  const all = [run("a", { created: "2026-01-02" }), run("b", { created: "2026-01-01" }), run("c", { created: "2026-01-03", verdict: "unreadable" })];
  expect(newestRun(all)).toBe("a");
});

it("names the line where runs differ by nothing else", () => {
  const other = [run("r/1", {}), run("r/2", { line: "re-330", line_digest: "2" }), run("r/3", { name: "b", line: "x", line_digest: "3" })];
  expect(differences(other)).toEqual([["a", "line re-250"], ["a", "line re-330"], ["b", ""]]);
  const edited = [
    run("r/2", { line_digest: "2", created: "2026-01-02" }),
    run("r/1", { created: "2026-01-01" }),
  ];
  expect(differences(edited)).toEqual([["a", "line re-250, version 2 of 2"], ["a", "line re-250, version 1 of 2"]]);
  // A field of the line that was set says what differs.
  const field = "line.contact_wire.tension";
  const set = [run("r/1", { changes: { [field]: "15 kN" } }), run("r/2", { changes: { [field]: "16 kN" }, line_digest: "2" })];
  expect(differences(set)).toEqual([["a", "Line contact wire: tension 15 kN"], ["a", "Line contact wire: tension 16 kN"]]);
});

const criterion = (name: string, more: Partial<Criterion>): Criterion => ({
  name, title: name, pantograph: "P1", value: "60.8", limit: "≤ 50.8", margin: "-10.0", unit: "N", verdict: "not met",
  state: "missed", mark: "A", source: "", note: "", reason: "", ...more,
});

it("says of the leading criterion value, limit and unit, and how many more there are", () => {
  const uplift = criterion("uplift_space", { title: "space required for the uplift", value: "116", limit: "≤ 100", unit: "mm" });
  const all = [uplift, criterion("standard_deviation", {}), criterion("wave_speed_use", { verdict: "met" })];
  expect(leadingWords(uplift, all, false)).toEqual({
    verdict: "not met", title: "space required for the uplift", isSign: false, value: "116 mm", limit: "≤ 100 mm", more: 1,
  });
  const met = criterion("standard_deviation", { verdict: "met" });
  expect(leadingWords(met, [met, met], true)).toMatchObject({ title: "σ of P1", value: "60.8 N", more: 0 });
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

it("says of a speed what is wrong with it, and of no other field", () => {
  const speed = { text: "a.yaml:3: speed: not a number", what: "not a number", got: "`abc`", expected: "a speed such as 250 km/h", field: ["set", "speed"] };
  expect(aboutSpeed([{ text: "b", field: ["line"] }, speed])).toBe(speed);
  expect(aboutSpeed([{ text: "b", field: ["speed_profile", "speeds"] }, { text: "c" }])).toBeNull();
  expect(inWords(speed)).toBe("Speed: not a number, got `abc`, expected a speed such as 250 km/h.");
  expect(inWords({ ...speed, what: "speed" })).toBe("Speed: got `abc`, expected a speed such as 250 km/h.");
  expect(inWords({ text: "No file." })).toBe("No file.");
});

it("keeps the last good speed and its unit where junk is typed, and nothing can be run until it is mended", async () => {
  const of = { path: "mine.yaml", speed: "275 km/h", speedField: "speed" };
  scenario.value = of.path;
  changes.value = {};
  const patched: unknown[] = [];
  vi.stubGlobal("fetch", (address: string, { body }: { body?: string }) => {
    const asked = JSON.parse(body ?? "{}") as { changes?: { speed: string }; text?: string };
    if (asked.changes) patched.push(asked.changes.speed);
    const isBad = asked.text?.includes("abc");
    const answer = address.startsWith("api/check")
      ? { errors: isBad ? [{ text: "x", what: "no number", field: ["speed"] }] : [] }
      : { text: asked.changes?.speed ?? "" };
    return Promise.resolve(new Response(JSON.stringify(answer)));
  });
  await typeSpeed("abc", of);
  expect([refused.value?.why, changes.value, canRun.value]).toEqual(["Speed: no number.", {}, false]);
  await typeSpeed("250", of);
  expect([refused.value?.why, changes.value, canRun.value]).toEqual([undefined, { speed: "250 km/h" }, true]);
  expect(patched).toEqual(["abc", "250 km/h"]);
  await typeSpeed("275", of);
  expect(changes.value).toEqual({});
  vi.unstubAllGlobals();
});
