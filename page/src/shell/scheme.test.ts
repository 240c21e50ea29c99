// @vitest-environment happy-dom
import { beforeEach, expect, test, vi } from "vitest";
import { messages } from "./messages.ts";
import { nextScheme, scheme } from "./scheme.ts";

const system = (dark: boolean) => vi.stubGlobal("matchMedia", () => ({ matches: dark }));

beforeEach(() => {
  scheme.value = "system";
  messages.value = [];
});

test.each([[true, "light"], [false, "dark"]] as const)("each press changes what is seen, and says so (system dark: %s)", (dark, other) => {
  system(dark);
  nextScheme();
  expect(scheme.value).toBe(other);
  nextScheme();
  expect(scheme.value).toBe("system");
  expect(messages.value.map(({ text }) => text)).toEqual([`Theme: ${other}.`, `Theme: as the system, ${dark ? "dark" : "light"}.`]);
});

test("a theme that the system has meanwhile, too, goes to the other one", () => {
  system(true);
  scheme.value = "dark";
  nextScheme();
  expect(scheme.value).toBe("light");
});
