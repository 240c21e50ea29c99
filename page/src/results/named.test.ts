import { expect, it } from "vitest";
import type { ProjectView, RunEntry } from "../state/project.ts";
import { namesOf, oldestOf, ordered } from "./named.ts";

const run = (path: string, created: string, changes: Record<string, string> = {}): RunEntry => ({
  path, created, changes, verdict: "met", reason: null, name: "mine", line: "l", line_digest: "1", speed_m_s: 50, pantographs: [],
  worst: null, max_uplift_at_support_mm: null,
});
const view: Pick<ProjectView, "runs" | "measured"> = {
  runs: [run("runs/a", "2026-01-01"), run("runs/b", "2026-01-03", { speed: "280 km/h" }), run("runs/c", "2026-01-02", { speed: "280 km/h" })],
  measured: [{ path: "measured/site 7.csv", bytes: 1 }],
};

it("calls runs and measurements as the tree does, each by another name", () => {
  expect([...namesOf(view)]).toEqual([
    ["runs/b", "mine, Speed 280 km/h, run 2 of 2"],
    ["runs/c", "mine, Speed 280 km/h, run 1 of 2"],
    ["runs/a", "mine, as in the file"],
    ["measured/site 7.csv", "site 7 (measured)"],
  ]);
});

it("compares with the oldest run in whatever order they were ticked", () => {
  expect(oldestOf(["runs/b", "runs/c"], view.runs)).toBe("runs/c");
  expect(oldestOf(["measured/site 7.csv"], view.runs)).toBe("measured/site 7.csv");
  for (const ticked of [["measured/site 7.csv", "runs/b", "runs/a"], ["runs/a", "measured/site 7.csv", "runs/b"]]) {
    expect(ordered(ticked, null, view)).toEqual(["runs/a", "runs/b", "measured/site 7.csv"]);
  }
});

it("compares with another one where that is chosen and ticked", () => {
  expect(ordered(["runs/a", "runs/b"], "runs/b", view)).toEqual(["runs/b", "runs/a"]);
  expect(ordered(["runs/a", "runs/b"], "runs/c", view)).toEqual(["runs/a", "runs/b"]);
});
