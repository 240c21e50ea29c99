/** What the drawing shows: the line of the text that is edited, or that of what is played. */
import { computed, effect, signal } from "@preact/signals";
import type { Complaint } from "../connection/http.ts";
import { range, selected } from "../state/selection.ts";
import type { Camera } from "./camera.ts";
import type { Geometry, Handles } from "./geometry.ts";
import { indexOf, type LineIndex } from "./lineIndex.ts";

/** The line of the text: the last valid one. The editor sets it. */
export const edited = signal<Geometry | null>(null);
export const handles = signal<Handles | null>(null);
/** On long elements, while it is typed: drawn, and its numbers are not shown. */
export const isDraft = signal(false);
/** With values that are tried in statics, and are not in the file. */
export const isTried = signal(false);
/** Why the text has no line at rest; then `edited` is older than the text, and drawn pale. */
export const wrong = signal<Complaint | null>(null);
/** The line of the run that is played. The player sets it. */
export const played = signal<Geometry | null>(null);
export const showing = signal<"edited" | "played">("edited");
/** Whether the line at rest is drawn below the moved one. */
export const ghost = signal(true);

export const shown = computed(() =>
  showing.value === "played" ? (played.value ?? edited.value) : (edited.value ?? played.value),
);
export const isPlayed = computed(() => shown.value !== null && shown.value === played.value);

/** The field of the text behind what is selected, wherever that was: a dropper's is its position. */
export const selectedField = computed(() => {
  const [chosen, line, found] = [selected.value, edited.value, handles.value];
  if (chosen?.kind === "field") return chosen.field;
  if (!line || !found || (chosen?.kind !== "dropper" && chosen?.kind !== "support")) return null;
  const index = line[`${chosen.kind}s`].findIndex((one) => one.name === chosen.name);
  return found[`${chosen.kind}s`][index]?.field ?? null;
});

/** Droppers that are marked, by number: the one that is selected, or all whose field is. */
export const marked = computed(() => {
  const [chosen, line] = [selected.value, shown.value];
  const all = new Set<number>();
  line?.droppers.forEach((dropper, number) => {
    const isIt = chosen?.kind === "dropper" && chosen.name === dropper.name;
    const isField = chosen?.kind === "field" && !isPlayed.value && handles.value?.droppers[number]?.field === chosen.field;
    if (isIt || isField) all.add(number);
  });
  return all;
});

/** Displacement from rest in m of the nodes first … first + up.length − 1 of a wire. */
export interface MovedWire {
  first: number;
  up: Float32Array;
  /** To the left; null in the plane. */
  across: Float32Array | null;
}

export interface Moved {
  /** By wire of the geometry; null: at rest. */
  wires: (MovedWire | null)[];
  /** Tension in N by dropper: 0 is slack, NaN not known. */
  dropper_N: Float32Array | null;
}

/** The line now, of `played`; the player sets it, and calls `redraw`. */
export const moved: { current: Moved | null } = { current: null };

/** What a layer draws with. */
export interface Pencil {
  context: CanvasRenderingContext2D;
  camera: Camera;
  geometry: Geometry;
  line: LineIndex;
  /** A colour by the name of its token, such as `contact_wire`. */
  colour(name: string): string;
}

export interface Layer {
  id: string;
  /** Above the line, those of a higher order later. */
  order: number;
  view: "side" | "plan";
  draw(pencil: Pencil): void;
}

export const layers: Layer[] = [];

/** Draw something over the line; the returned function ends it. */
export function addLayer(layer: Layer): () => void {
  layers.push(layer);
  layers.sort((a, b) => a.order - b.order);
  redraw();
  return () => {
    layers.splice(layers.indexOf(layer), 1);
    redraw();
  };
}

/** Changes whenever all canvases are to be drawn: each reads it, as it reads the signals that it draws. */
export const drawing = signal(0);
let asked = false;

/** Draw all canvases at the end of the batch: with what else has changed in it once, and not twice. */
export function redrawNow(): void {
  drawing.value = drawing.peek() + 1;
}

/** Draw all canvases at the next frame, once. */
export function redraw(): void {
  if (asked) return;
  asked = true;
  requestAnimationFrame(() => {
    asked = false;
    redrawNow();
  });
}

/** Share of its length that is left free at either end of the line. */
const MARGIN = 0.02;

/** All of a line that can be looked at, in m. */
export function whole(geometry: Geometry): [number, number] {
  const [start, end] = indexOf(geometry).x;
  const margin = MARGIN * (end - start || 1);
  return [start - margin, end + margin];
}

/** What is seen of the line that is shown, in m. */
export const sight = computed<[number, number]>(() => {
  const line = shown.value;
  return range.value ?? (line ? whole(line) : [0, 100]);
});

let last: [number, number] | null = null;
// A line of another length: a range of the old one may show nothing of it.
effect(() => {
  const line = shown.value;
  if (!line) return;
  const now = indexOf(line).x;
  const seen = range.peek();
  if (last && seen && (seen[1] <= now[0] || seen[0] >= now[1])) range.value = null;
  last = now;
});
