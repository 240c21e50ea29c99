import { expect, it } from "vitest";
import { linePath, ofScenario } from "./variant.ts";

it("finds the line that a scenario names", () => {
  expect(linePath("a.yaml", "a-line.yaml")).toBe("a-line.yaml");
  expect(linePath("north/a.yaml", "../lines/b.yml")).toBe("lines/b.yml");
  expect(linePath("north/a.yaml", "./b.json")).toBe("north/b.json");
  expect(linePath("north/a.yaml", "norway-s25")).toBe("shipped:line/norway-s25");
});

it("puts fields of a line below the line of the scenario", () => {
  const tried = { "contact_wire.tension": "24 kN", "span_types.a.droppers.presag": [0, 0.01] };
  expect(ofScenario(tried, true)).toEqual({
    "line.contact_wire.tension": "24 kN",
    "line.span_types.a.droppers.presag": [0, 0.01],
  });
  expect(ofScenario({ "line.contact_wire.tension": "24 kN" }, false)).toEqual({ "line.contact_wire.tension": "24 kN" });
});
