/** What is wrong with the text, and where its fields are: the server checks it as `arcless check`. */
import { computed, effect, signal } from "@preact/signals";
import { ask, newest, RefusedError, type Complaint } from "../connection/http.ts";
import { connection } from "../connection/stream.ts";
import { opened, text } from "./documents.ts";

/** After the last key, in ms: shorter, and half a word is told to be wrong. */
const CHECK_AFTER = 150;

/** Counted from 1; the end is behind the last character. */
export interface Place {
  line: number;
  column: number;
  end_line: number;
  end_column: number;
}

export type Finding = Complaint & Partial<Place>;

/** POST check. */
export interface Check {
  kind: string | null;
  errors: Finding[];
  /** Of a whole sentence, or with its place. */
  warnings: (Finding | string)[];
  fields: Record<string, Place>;
}

/** Of the text that is given with it. */
export const checked = signal<{ path: string; text: string; found: Check } | null>(null);

/** Errors, then warnings, of the text as it was checked last. */
export const findings = computed(() => {
  const found = checked.value?.path === opened.value?.path ? checked.value?.found : undefined;
  const warnings = (found?.warnings ?? []).map((one) => (typeof one === "string" ? { text: one } : one));
  return [
    ...(found?.errors ?? []).map((finding) => ({ level: "error" as const, finding })),
    ...warnings.map((finding: Finding) => ({ level: "warning" as const, finding })),
  ];
});

/** Whether the text as it was checked last has an error. */
export const isWrong = computed(() => findings.value.some(({ level }) => level === "error"));

/** Whether a text is an error of the file in the list below its fields, where it stands in full. */
export const isListed = (text: string): boolean => findings.value.some(({ finding }) => finding.text === text);

const question = newest((signal, path: string, content: string) =>
  ask<Check>("check", { body: { path, text: content }, signal }),
);

/** Check the text whenever it has rested; the newest one wins. */
export function followText(): () => void {
  let timer: ReturnType<typeof setTimeout> | undefined;
  return effect(() => {
    const [path, content] = [opened.value?.path, text.value];
    if (connection.value === "lost") return;
    clearTimeout(timer);
    if (path === undefined) return;
    const soon = checked.peek()?.path === path ? CHECK_AFTER : 0;
    timer = setTimeout(() => {
      question(path, content).then(
        (found) => found && (checked.value = { path, text: content, found }),
        (error: unknown) => {
          if (!(error instanceof RefusedError)) return;
          const found = { kind: null, errors: [error.complaint], warnings: [], fields: {} };
          checked.value = { path, text: content, found };
        },
      );
    }, soon);
  });
}

/** The place of a field, or of the nearest thing around it. */
export function placeOf(field: string, fields: Record<string, Place>): Place | null {
  const parts = field.split(".");
  while (parts.length) {
    const found = fields[parts.join(".")];
    if (found) return found;
    parts.pop();
  }
  return null;
}

/** The innermost field at a place, counted from 1. */
export function fieldAt(line: number, column: number, fields: Record<string, Place>): string | null {
  let best: string | null = null;
  for (const [field, place] of Object.entries(fields)) {
    const after = line > place.line || (line === place.line && column >= place.column);
    const before = line < place.end_line || (line === place.end_line && column <= place.end_column);
    // A field on the line of its key is meant anywhere in the line.
    const here = (after && before) || (line === place.line && place.line === place.end_line && column < place.column);
    if (here && (best === null || field.split(".").length > best.split(".").length)) best = field;
  }
  return best;
}
