import { expect, it } from "vitest";
import { order, scenarioNamed } from "./MotionOffer.tsx";

it("orders the scenario with the changes of the run, and its motion", () => {
  expect(order("lines/a.yaml", { speed: "300 km/h" })).toEqual({
    scenario: "lines/a.yaml",
    changes: { speed: "300 km/h", "output.motion": true },
    record_motion: true,
    keep_both: true,
  });
});

it("finds the scenario of the run, not the one that is chosen", () => {
  const entry = (path: string, name: string) => ({ path, kind: "scenario" as const, name, description: "" });
  const view = {
    name: "", folder: "", version: "", runs: [], studies: [], measured: [],
    models: [entry("other.yaml", "other"), entry("lines/a.yaml", "a")],
    library: [entry("shipped:scenario/b", "b")],
  };
  expect(["a", "b", "gone", null].map((name) => scenarioNamed(name, view))).toEqual(["lines/a.yaml", "shipped:scenario/b", null, null]);
});
