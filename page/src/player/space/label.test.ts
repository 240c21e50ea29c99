// @vitest-environment happy-dom
import { expect, test, vi } from "vitest";

vi.mock("./stage.ts", () => ({ Stage: class {} }));

test("a label stands right of its mast, left of it at the edge, and is never cut", async () => {
  const { beside } = await import("./SpaceView.tsx");
  expect(beside(100, 90, 400)).toBe(104);
  expect(beside(390, 90, 400)).toBe(296);
  expect(beside(60, 90, 120)).toBe(null);
  expect(beside(-5, 90, 400)).toBe(null);
});
