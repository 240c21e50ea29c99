/** What the user is told: complaints, warnings, notes. Whole sentences. */
import { signal } from "@preact/signals";
import { RefusedError } from "../connection/http.ts";
import { below } from "../state/project.ts";

export interface Told {
  id: number;
  level: "error" | "warning" | "note";
  text: string;
}

let count = 0;
export const messages = signal<Told[]>([]);

export function say(level: Told["level"], text: string): void {
  messages.value = [...messages.peek(), { id: ++count, level, text }];
}

export function dismiss(id: number): void {
  messages.value = messages.peek().filter((one) => one.id !== id);
}

/** Tell what went wrong with something that was asked for. */
export function complain(error: unknown): void {
  say("error", error instanceof RefusedError ? below(error.complaint.text) : String(error));
}
