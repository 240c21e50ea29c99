/** What the user is told: complaints, warnings, notes. Whole sentences. */
import { signal } from "@preact/signals";
import { RefusedError } from "../connection/http.ts";

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
  say("error", error instanceof RefusedError ? error.complaint.text : String(error));
}
