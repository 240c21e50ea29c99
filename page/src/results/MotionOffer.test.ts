import { expect, it } from "vitest";
import { order } from "./MotionOffer.tsx";

it("orders the scenario with the changes of the run, and its motion", () => {
  expect(order("lines/a.yaml", { speed: "300 km/h" })).toEqual({
    scenario: "lines/a.yaml",
    changes: { speed: "300 km/h", "output.motion": true },
    record_motion: true,
  });
});
