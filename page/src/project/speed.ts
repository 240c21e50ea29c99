/** The speed that is typed in the run bar: the server checks the scenario with it before a run has it. */
import { effect, signal } from "@preact/signals";
import { ask, newest, RefusedError, type Complaint } from "../connection/http.ts";
import { change, changes } from "../state/changes.ts";
import { beforeRun } from "../state/pending.ts";
import { scenario } from "../state/selection.ts";
import { withUnit } from "./words.ts";

/** A speed that cannot be run, as typed, and why; the last good one stays with the run until it is mended. */
export const refused = signal<{ typed: string; why: string } | null>(null);

// Another scenario has another speed.
effect(() => {
  void scenario.value;
  refused.value = null;
});

const FIELD = /(^|\.)speed$/;

/** What is wrong in a few words, without the file. */
export function inWords({ what, got, expected, text }: Complaint): string {
  if (got === undefined && expected === undefined) return what === undefined ? text : `Speed: ${what}.`;
  const parts = [what === undefined || FIELD.test(what) ? "" : what, got && `got ${got}`, expected && `expected ${expected}`];
  return `Speed: ${parts.filter(Boolean).join(", ")}.`;
}

/** The complaint about the speed itself: what else is wrong with the scenario stands in its editor. */
export const aboutSpeed = (errors: readonly Complaint[]): Complaint | null =>
  errors.find(({ field }) => field !== undefined && FIELD.test(field.join("."))) ?? null;

/** Ask the server for what is wrong with a speed; null: nothing. */
const question = newest(async (signal, path: string, field: string, typed: string): Promise<{ wrong: Complaint | null }> => {
  const { text } = await ask<{ text: string }>("file", { query: { path }, signal });
  try {
    const patched = await ask<{ text: string }>("patch", { body: { path, text, changes: { [field]: typed } }, signal });
    const found = await ask<{ errors: Complaint[] }>("check", { body: { path, text: patched.text }, signal });
    return { wrong: aboutSpeed(found.errors) };
  } catch (error) {
    if (error instanceof RefusedError) return { wrong: error.complaint };
    throw error;
  }
});

let pending: Promise<void> = Promise.resolve();
beforeRun(() => pending);

/** Take what is typed as the speed of the next run, once the server has nothing against it. */
export function typeSpeed(typed: string, of: { path: string; speed: string; speedField: string }): Promise<void> {
  const value = withUnit(typed, String(changes.peek()["speed"] ?? of.speed));
  return (pending = take(value, of).catch(() => undefined)); // without a server the banner says it
}

async function take(value: string, { path, speed, speedField }: { path: string; speed: string; speedField: string }): Promise<void> {
  if (value !== "" && value !== speed) {
    const answer = await question(path, speedField, value);
    if (!answer || scenario.peek() !== path) return;
    if (answer.wrong) {
      refused.value = { typed: value, why: inWords(answer.wrong) };
      return;
    }
  }
  refused.value = null;
  change("speed", value, speed);
}
