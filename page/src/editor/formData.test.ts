import { expect, it } from "vitest";
import { amount, parts } from "./formData.ts";

it("splits what is typed into number and unit, and keeps every digit", () => {
  expect(parts("22 kN")).toEqual({ number: "22", unit: "kN" });
  expect(parts("195.0 N m²")).toEqual({ number: "195.0", unit: "N m²" });
  expect(parts("-1e-4 1/s")).toEqual({ number: "-1e-4", unit: "1/s" });
  expect(parts(4.5)).toEqual({ number: "4.5", unit: "" });
  expect(parts("fixed")).toEqual({ number: "fixed", unit: "" });
  expect(parts(null)).toEqual({ number: "", unit: "" });
});

it("puts them together again", () => {
  expect(amount("22", "kN")).toBe("22 kN");
  expect(amount("4.50", "")).toBe(4.5);
  expect(amount("free", "")).toBe("free");
  expect(amount("", "")).toBe("");
});
