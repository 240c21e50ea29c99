/**
 * The model file that is edited. Its text is the truth of the page; it is saved at once, whether it
 * is valid or not, and undone by Ctrl-Z. What is typed is also kept in the browser until it is saved.
 */
import { computed, signal } from "@preact/signals";

export type ModelKind = "line" | "pantograph" | "scenario" | "study";

/** GET file. */
export interface FileAnswer {
  path: string;
  kind: ModelKind | null;
  text: string;
  /** SHA-256 of the bytes on the disk. */
  version: string;
  writable: boolean;
}

export interface Document {
  path: string;
  writable: boolean;
  /** What is on the disk, as far as is known. */
  saved: { text: string; version: string | null };
}

/** Two texts of one file: what was typed here, and what another program wrote. */
export interface Conflict {
  path: string;
  mine: string;
  /** null: the file is gone. */
  theirs: { text: string; version: string } | null;
}

export type Saving = "saved" | "waiting" | "saving" | "not saved" | "conflict";

export const opened = signal<Document | null>(null);
/** The text of the file that is open; empty without one. */
export const text = signal("");
export const saving = signal<Saving>("saved");
export const conflict = signal<Conflict | null>(null);

const FORMAT = /^["']?format["']?\s*:\s*["']?arcless-(\w+)\//m;
const KINDS = ["line", "pantograph", "scenario", "study"];

/** The kind that a text says to be. */
export function kindOf(content: string): ModelKind | null {
  const found = FORMAT.exec(content)?.[1];
  return found && KINDS.includes(found) ? (found as ModelKind) : null;
}

export const kind = computed(() => kindOf(text.value));
/** Whether the file can be changed; shipped models cannot. */
export const writable = computed(() => opened.value?.writable ?? false);
