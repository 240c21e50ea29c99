// @vitest-environment happy-dom
import { expect, it, vi } from "vitest";
import { keep, kept } from "./kept.ts";
import { LIMITS, resize, sizeOf } from "./layout.ts";

it("keeps sizes within their limits", () => {
  resize("left", 10);
  expect(sizeOf("left")).toBe(LIMITS.left.least);
  resize("left", 1e6);
  expect(sizeOf("left")).toBe(LIMITS.left.most);
});

it("takes nothing that it did not keep itself, and lives without storage", () => {
  keep("a", 3);
  expect(kept("a", 1, (found) => typeof found === "number")).toBe(3);
  expect(kept("a", "x", (found) => typeof found === "string")).toBe("x");
  localStorage.setItem("arcless.window:a", "{");
  expect(kept("a", 1, () => true)).toBe(1);
  const broken = vi.spyOn(localStorage, "setItem").mockImplementation(() => {
    throw new Error("full");
  });
  expect(() => keep("a", 4)).not.toThrow();
  broken.mockRestore();
});
