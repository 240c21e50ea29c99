// @vitest-environment happy-dom
import { expect, it } from "vitest";
import { followReload } from "./over.ts";
import { project, type ProjectView, type RunEntry } from "./project.ts";
import { source, ticked } from "./selection.ts";

const run = (path: string): RunEntry => ({
  path, verdict: "met", reason: null, name: path, created: null, line: null, line_digest: null, speed_m_s: null, changes: {}, pantographs: [],
  worst: null, max_uplift_at_support_mm: null,
});
const view: ProjectView = {
  name: "p", folder: "/p", version: "", models: [], library: [], studies: [], runs: [run("runs/a"), run("runs/b")], measured: [{ path: "m.csv", bytes: 1 }],
};

it("keeps ticks and the run that is played over a reload, but for what is gone", async () => {
  project.value = view;
  followReload();
  await Promise.resolve();
  ticked.value = ["m.csv", "runs/gone", "runs/a"];
  source.value = { run: "runs/b" };
  dispatchEvent(new Event("pagehide"));
  ticked.value = [];
  source.value = null;
  followReload();
  await Promise.resolve();
  expect(ticked.value).toEqual(["m.csv", "runs/a"]);
  expect(source.value).toEqual({ run: "runs/b" });
});
