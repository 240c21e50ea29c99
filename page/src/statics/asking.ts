/**
 * The line at rest of the text that is edited, and of the values that sliders try. At most two
 * questions are under way; of those that wait the newest is asked, and a late answer is ignored.
 */
import { computed, effect, signal } from "@preact/signals";
import { ask, RefusedError, type Complaint } from "../connection/http.ts";
import { connection } from "../connection/stream.ts";
import type { Geometry, Handles } from "../drawing/geometry.ts";
import { edited, handles, isDraft, isTried, showing, wrong } from "../drawing/scene.ts";
import { kindOf, opened, text } from "../editor/documents.ts";
import type { Value } from "../editor/patch.ts";
import { below } from "../state/project.ts";

export interface DropperRow {
  name: string;
  span: number;
  x_m: number;
  from: string;
  to: string;
  length_m: number;
  unstretched_length_m: number;
  force_N: number;
}

export interface SupportRow {
  name: string;
  x_m: number;
  steady_arm_force_N: number | null;
  contact_wire_height_m: number;
  contact_wire_lateral_force_N: number | null;
  messenger_force_N?: number | null;
  contact_support_force_N?: number | null;
}

/** POST statics; parts that were not wanted are absent, and all of a line that is wrong. */
export interface AtRest {
  /** What is wrong with the line; then there is nothing else. */
  errors: Complaint[];
  /** A newer question came before this one began. */
  dropped?: boolean;
  question: number;
  draft: boolean;
  name: string;
  middle_span: number;
  sag_m: number;
  wave_speed_m_s: number | null;
  frequencies_Hz: number[] | null;
  nonuniformity?: number;
  elasticity?: { x_m: number[]; mm_per_N: number[] };
  droppers?: DropperRow[];
  supports?: SupportRow[];
  line?: Geometry;
  handles?: Handles;
}

export type Changes = Record<string, Value>;

/** Values that are tried: by field, as typed. Nothing of them is in the file. */
export const tried = signal<Changes>({});
/** Whether numbers are looked at; without, the drawing alone is asked for. */
export const wanted = signal(false);
/** Of the text with what is tried, and of the text alone. */
export const now = signal<AtRest | null>(null);
export const ofFile = signal<AtRest | null>(null);
/** Natural frequencies in Hz of `now`; null until the slider rests. */
export const frequencies = signal<number[] | null>(null);
/** Whether anything is tried. */
export const isTrying = computed(() => Object.keys(tried.value).length > 0);
/** Whether an answer is awaited. */
export const isAsking = signal(false);

const NUMBERS = ["line", "droppers", "supports", "elasticity"];
const MOST = 2;
/**
 * A line whose numbers take longer than this, in ms, is divided coarsely while a slider moves, and
 * that is said. With 80 ms two processes answer 10 times a second beside a page that draws; with 150
 * ms, 6 times, which is felt as dragging behind.
 */
const SLOW = 110;
/** A slider or a key that did nothing for so long rests, in ms. */
export const REST = 300;
const PAGE = typeof crypto === "undefined" || !crypto.randomUUID ? String(Math.random()) : crypto.randomUUID();

interface Question {
  path: string;
  text: string;
  changes: Changes;
  want: string[];
  draft: boolean;
  /** Whether a slider moves: the line is searched for from the one before. */
  moving: boolean;
}

let count = 0;
let shownNumber = 0;
/** How long the last line took while a slider moved, in ms, where no other was asked for beside it. */
let took = 0;
/** What is left of that when the slider rests: a machine that was busy once may be free again. */
const FORGOTTEN = 0.5;
let running = 0;
let waiting: Question | null = null;

function put(question: Question): Promise<AtRest> {
  return ask<AtRest>("statics", { body: { ...question, question: ++count, page: PAGE } });
}

/** Ask a part of the line that is edited now, beside what is followed: the dropper schedule. */
export function askPart<Part>(want: string, more: Record<string, Value>): Promise<Part> {
  const body = { path: opened.peek()?.path, text: text.peek(), changes: tried.peek(), want: [want], ...more };
  return ask<Part>("statics", { body: { ...body, question: ++count, page: `${PAGE} part` } });
}

function follow(question: Question): void {
  waiting = question;
  next();
}

function next(): void {
  if (!waiting || running >= MOST) return;
  const question = waiting;
  waiting = null;
  running++;
  isAsking.value = true;
  const [mine, begun] = [count + 1, performance.now()];
  const alone = running === 1 && !question.draft && question.moving;
  put(question)
    .then(
      (answer) => {
        if (alone && !waiting) took = performance.now() - begun;
        if (mine > shownNumber) take(question, answer, mine);
      },
      // A server that is gone says nothing; the connection does.
      (error: unknown) => error instanceof RefusedError && (wrong.value = error.complaint),
    )
    .finally(() => {
      running--;
      isAsking.value = running > 0;
      next();
    });
}

function take(question: Question, answer: AtRest, number: number): void {
  if (question.path !== opened.peek()?.path || answer.dropped) return;
  shownNumber = number;
  wrong.value = answer.errors[0] ? { ...answer.errors[0], text: below(answer.errors[0].text) } : null;
  if (wrong.value) return;
  if (answer.line) {
    handles.value = answer.handles ?? null;
    isDraft.value = answer.draft;
    edited.value = answer.line;
    isTried.value = Object.keys(question.changes).length > 0;
  }
  if (!answer.droppers) return;
  frequencies.value = null;
  now.value = answer;
  if (!answer.draft && !Object.keys(question.changes).length) ofFile.value = answer;
}

/** Whatever takes long, once slider and keys rest. */
async function rested(question: Question): Promise<void> {
  const isSame = () => question.path === opened.peek()?.path && question.text === text.peek() && question.changes === tried.peek();
  try {
    if (ofFile.peek() === null && Object.keys(question.changes).length) {
      const base = await put({ ...question, changes: {}, want: NUMBERS.slice(1), draft: false });
      if (question.text === text.peek() && base.droppers) ofFile.value = base;
    }
    const found = await put({ ...question, want: ["frequencies"], draft: false });
    if (isSame()) frequencies.value = found.frequencies_Hz ?? null;
  } catch {
    // What goes wrong was told by the answer before.
  }
}

/** Follow text and sliders; the returned function ends it. */
export function followLine(): () => void {
  let timer: ReturnType<typeof setTimeout> | undefined;
  let before: { path: string | undefined; text: string; changes: Changes } = { path: undefined, text: "", changes: {} };
  return effect(() => {
    const [path, content, changes, numbers] = [opened.value?.path, text.value, tried.value, wanted.value];
    if (connection.value === "lost") return;
    clearTimeout(timer);
    if (path !== before.path) {
      [edited.value, handles.value, wrong.value, isDraft.value] = [null, null, null, false];
      [now.value, ofFile.value, frequencies.value] = [null, null, null];
      took = 0;
      if (Object.keys(changes).length) tried.value = {};
    }
    const isTyped = path === before.path && content !== before.text;
    if (content !== before.text) ofFile.value = null;
    // A change has to be seen: a run that was played shows the line as it was.
    if (isTyped || changes !== before.changes) showing.value = "edited";
    const kind = kindOf(content);
    if (path === undefined || (kind !== "line" && kind !== "scenario")) {
      before = { path, text: content, changes };
      return;
    }
    const question = { path, text: content, changes, want: numbers ? NUMBERS : ["line"], draft: false, moving: false };
    const isMoved = changes !== before.changes && numbers;
    before = { path, text: content, changes };
    const quick = { ...question, want: isMoved ? NUMBERS.slice(1) : ["line"] };
    const isQuick = isTyped || isMoved;
    follow(isQuick ? { ...quick, draft: isTyped || took > SLOW, moving: isMoved } : question);
    timer = setTimeout(() => {
      if (isQuick) follow(question);
      took *= FORGOTTEN;
      if (numbers) void rested(question);
    }, REST);
  });
}
