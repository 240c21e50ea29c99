/** What the user is told: complaints, warnings, notes. Whole sentences. */
import { signal } from "@preact/signals";
import { RefusedError } from "../connection/http.ts";
import { connection } from "../connection/stream.ts";
import { isMissingPart, look } from "../connection/version.ts";
import { below } from "../state/project.ts";

export interface Told {
  id: number;
  level: "error" | "warning" | "note";
  text: string;
  /** What can be done about it. */
  action?: Action;
}

export interface Action {
  label: string;
  act: () => void;
}

/** The level of the worst of some messages; null without any. */
export const worstOf = (all: readonly Told[]): Told["level"] | null =>
  (["error", "warning", "note"] as const).find((level) => all.some((told) => told.level === level)) ?? null;

let count = 0;
export const messages = signal<Told[]>([]);

export function say(level: Told["level"], text: string, action?: Action): void {
  messages.value = [...messages.peek(), { id: ++count, level, text, ...(action && { action }) }];
}

export function dismiss(id: number): void {
  messages.value = messages.peek().filter((one) => one.id !== id);
}

/** Tell what went wrong with something that was asked for. */
export function complain(error: unknown): void {
  if (isMissingPart(error)) return void partIsMissing();
  say("error", error instanceof RefusedError ? below(error.complaint.text) : String(error));
}

/** Of another version, or of a server that is gone, the banner tells; of nothing else that can be known. */
async function partIsMissing(): Promise<void> {
  if (!(await look()) && connection.peek() === "open") say("error", "A part of the page could not be loaded. Reload the page.");
}
