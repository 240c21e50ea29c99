/**
 * The study that is looked at: what it asks, its rows as they come, and which of them are picked.
 * Values of variables are in SI until they are shown, see `columns.ts`.
 */
import { batch, signal } from "@preact/signals";
import { ask } from "../connection/http.ts";
import { keep, kept } from "../shell/kept.ts";
import { complain } from "../shell/messages.ts";

export interface Variable {
  name: string;
  field: string;
  /** Unit it is shown in, and its size in SI. */
  unit: string;
  scale: number;
  /** The field in words. */
  label: string;
  description: string;
}

export interface Output {
  name: string;
  expression: string;
  unit: string;
  /** Of the assessed quantity; its own name where it is none. */
  label: string;
  /** Digits after the point of the quantity; null where it is none. */
  decimals: number | null;
  /** The pantograph, in words; empty of one alone. */
  of: string;
  description: string;
  objective: string | null;
  bounds: { at_least: number | null; at_most: number | null } | null;
}

export interface Definition {
  name: string;
  description: string;
  /** Name of the scenario. */
  scenario: string;
  design: string;
  count: number;
  variables: Variable[];
  outputs: Output[];
}

/** A criterion that rows are judged by. */
export interface Criterion {
  title: string;
  of: string;
  /** Name of the output that has its value; null of a value that the scenario alone has. */
  output: string | null;
  /** "<=", ">=", ">"; empty where the output is the verdict itself. */
  relation: string;
  tolerance: number;
  source: string;
}

/** Number of the criterion, verdict in words, limit in the unit of the output. */
export type Judgement = [number, string, number | null];
export type Cell = number | string | boolean | null | Judgement[];
/** Number of the variant, status, variables, outputs, verdict, judgements, error, wall time in s. */
export type Row = Cell[];

export interface Progress {
  there: number;
  /** null before the study has begun. */
  total: number | null;
  counts: Record<string, number>;
  running: boolean;
  /** Sum over the rows, s. */
  wall_time_s: number;
  missing: number | null;
  /** What ended it before its time. */
  error: string | null;
  /** Whether this studio computes it, and can stop it. */
  own: boolean;
  criteria: Criterion[];
  /** Criteria that decide and that no output tells, in words. */
  not_judged: string[];
}

interface Answer extends Progress {
  edition: string;
  rows: Row[];
  next: number;
}

/** Between two looks, ms: while rows come, and while another program may begin. */
const SOON = 700;
const LATER = 4000;

/** Folder of the study, below that of the project. */
export const current = signal<string | null>(null);
export const about = signal<Definition | null>(null);
export const progress = signal<Progress | null>(null);
/** Rows in the order in which they came; `count` tells when there are more. */
export const rows: Row[] = [];
export const count = signal(0);
/** Number of the variant that is picked. */
export const picked = signal<number | null>(null);

let edition = "";
let next = 0;

/** The study that was open when the window was closed or read anew. */
export const lastOpen = (): string | null => kept<string | null>("study", null, (found) => typeof found === "string");

export function openStudy(path: string | null): void {
  keep("study", path);
  edition = "";
  next = rows.length = 0;
  batch(() => {
    current.value = path;
    about.value = null;
    progress.value = null;
    picked.value = null;
    count.value = 0;
  });
}

async function look(path: string): Promise<boolean> {
  const answer = await ask<Answer>("studies/rows", { query: { path, after: next, edition } });
  if (current.peek() !== path) return false;
  if (answer.edition !== edition) {
    edition = answer.edition;
    rows.length = 0;
    about.value = null;
  }
  if (answer.edition && !about.peek()) {
    const found = await ask<Definition>("studies/definition", { query: { path } });
    if (current.peek() !== path) return false;
    about.value = found;
  }
  rows.push(...answer.rows);
  next = answer.next;
  batch(() => {
    progress.value = answer;
    count.value = rows.length;
  });
  return next < answer.there;
}

/** Follow the rows of the study that is open; the returned function ends it. */
export function follow(): () => void {
  let timer: ReturnType<typeof setTimeout> | undefined;
  let ended = false;
  const again = (more: boolean) => {
    if (ended) return;
    timer = setTimeout(act, more ? 0 : progress.peek()?.running ? SOON : LATER);
  };
  const act = () => {
    const path = current.peek();
    if (path === null) return;
    look(path).then(again, (error: unknown) => {
      complain(error);
      if (current.peek() === path) openStudy(null);
    });
  };
  const end = current.subscribe(() => {
    clearTimeout(timer);
    act();
  });
  return () => {
    ended = true;
    clearTimeout(timer);
    end();
  };
}
