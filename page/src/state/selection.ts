/**
 * One axis, one cursor, one selection: position along the track is the axis of drawing, strips,
 * statics and tables. Where the cursor stands, everything stands.
 */
import { signal } from "@preact/signals";

/** What moves: a run on the disk, or one that is being computed. */
export type Source = { run: string } | { job: string };

export type Selected =
  | { kind: "dropper" | "support" | "pantograph"; name: string; x_m?: number }
  | { kind: "span"; number: number }
  /** A field of the model file that is edited, as a dotted path. */
  | { kind: "field"; field: string };

/** The model file that is edited, by its path; `shipped:KIND/NAME` is read-only. */
export const file = signal<string | null>(null);
/** The scenario that is run, by its path. */
export const scenario = signal<string | null>(null);
/** What the player shows. */
export const source = signal<Source | null>(null);
/** Runs (folders) and measured files that are ticked for comparison, in their order. */
export const ticked = signal<string[]>([]);
/** Position along the track in m under the cursor, in whatever view it is. */
export const cursor = signal<number | null>(null);
export const selected = signal<Selected | null>(null);
/** Range of positions in m that drawing, strips and charts show; null: all. */
export const range = signal<[number, number] | null>(null);
/** Heights are drawn so many times larger. */
export const exaggeration = signal(20);

/** The player's clock; the player owns it, everybody may read and set it. */
export const clock = {
  time_s: signal(0),
  start_s: signal(0),
  /** Of a run that is being computed it grows. */
  end_s: signal(0),
  playing: signal(false),
  /** 1 is real time. */
  rate: signal(1),
  /** Follow the newest frame of a run that is being computed. */
  live: signal(false),
};
