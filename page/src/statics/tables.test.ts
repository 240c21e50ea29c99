import { expect, it } from "vitest";
import { millimetres } from "./Tables.tsx";

it("reads an allowance in mm, with or without the unit", () => {
  expect(["50", " 50 mm", "0.5mm", ""].map(millimetres)).toEqual([50, 50, 0.5, 0]);
  // The schedule has these, or refuses them; the table says nothing of them.
  expect(["5 cm", "-3", "x"].map(millimetres)).toEqual([null, null, null]);
});
