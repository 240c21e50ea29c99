/** Light or dark: as the system says, unless the user chose. */
import { effect, signal } from "@preact/signals";
import { keep, kept } from "./kept.ts";

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

export function nextScheme(): void {
  scheme.value = SCHEMES[(SCHEMES.indexOf(scheme.peek()) + 1) % SCHEMES.length]!;
}
