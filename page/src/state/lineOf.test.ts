import { expect, test } from "vitest";
import { lineOf } from "./lineOf.ts";

test("a line is a shipped name, or a file beside the scenario", () => {
  expect(lineOf("a.yaml", "ac-simple-55")).toBe("shipped:line/ac-simple-55");
  expect(lineOf("shipped:scenario/x", "ac-simple-55")).toBe("shipped:line/ac-simple-55");
  expect(lineOf("a.yaml", "line.yaml")).toBe("line.yaml");
  expect(lineOf("north/a.yaml", "./line.yaml")).toBe("north/line.yaml");
  expect(lineOf("north/a.yaml", "../lines/line.yml")).toBe("lines/line.yml");
});
