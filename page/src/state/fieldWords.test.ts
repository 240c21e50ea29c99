import { expect, test } from "vitest";
import { changeWords, fieldWords } from "./fieldWords.ts";

test("a field is told in words, and counted from 1", () => {
  expect(fieldWords("speed")).toBe("Speed");
  expect(fieldWords("line.contact_wire.tension")).toBe("Line contact wire: tension");
  expect(fieldWords("pantographs.0.model.masses.1.stiffness")).toBe("Pantograph 1 masses 2: stiffness");
});

test("a change is told with its value", () => {
  expect(changeWords("pantographs.0.model", "dsa-250")).toBe("Pantograph 1: dsa-250");
  expect(changeWords("pantographs.1.model", "my-dsa-250.yaml")).toBe("Pantograph 2: my-dsa-250");
  expect(changeWords("pantographs.0.static_force", "130 N")).toBe("Pantograph 1: static force 130 N");
  expect(changeWords("line.contact_wire.tension", "17 kN")).toBe("Line contact wire: tension 17 kN");
});
