import { expect, test } from "vitest";
import { changesAfter, changesInWords, fieldWords } from "./fieldWords.ts";

test("a field is told in words, and counted from 1", () => {
  expect(fieldWords("speed")).toBe("Speed");
  expect(fieldWords("line.contact_wire.tension")).toBe("Line contact wire: tension");
  expect(fieldWords("pantographs.0.model.masses.1.stiffness")).toBe("Pantograph 1 masses 2: stiffness");
});

test("changes are told with their values", () => {
  expect(changesInWords([["pantographs.0.model", "dsa-250"], ["speed", "260 km/h"]])).toBe("Pantograph 1: dsa-250, speed 260 km/h");
  expect(changesInWords([["pantographs.1.model", "my-dsa-250.yaml"]])).toBe("Pantograph 2: my-dsa-250");
  expect(changesAfter([["pantographs.0.static_force", "130 N"]])).toBe("pantograph 1: static force 130 N");
  expect(changesInWords([["line.contact_wire.tension", "17 kN"]])).toBe("Line contact wire: tension 17 kN");
});
