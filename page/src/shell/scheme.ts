/** Light or dark: as the system says, unless the user chose. */
import { effect, signal } from "@preact/signals";
import { keep, kept } from "./kept.ts";
import { say } from "./messages.ts";

export type Scheme = "system" | "light" | "dark";
export const SCHEMES: readonly Scheme[] = ["system", "light", "dark"];

export const scheme = signal<Scheme>(kept("scheme", "system", (found) => SCHEMES.includes(found as Scheme)));

export function followScheme(): void {
  effect(() => {
    keep("scheme", scheme.value);
    if (scheme.value === "system") delete document.documentElement.dataset["scheme"];
    else document.documentElement.dataset["scheme"] = scheme.value;
  });
}

const isDark = (): boolean => matchMedia("(prefers-color-scheme: dark)").matches;

/** The other one of light and dark; by the system where it says the same, so that each press changes what is seen. */
export function nextScheme(): void {
  const system = isDark() ? "dark" : "light";
  const seen = scheme.peek() === "system" ? system : scheme.peek();
  const next = seen === "dark" ? "light" : "dark";
  scheme.value = next === system ? "system" : next;
  say("note", `Theme: ${scheme.value === "system" ? `as the system, ${system}` : scheme.value}.`);
}
