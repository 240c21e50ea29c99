/** Contact force by position along the track as strips draw it, m and N. */
import { signal } from "@preact/signals";

/** Lowest and highest value at ascending positions. */
export interface Column {
  x: Float32Array;
  low: Float32Array;
  high: Float32Array;
}

/** By pantograph; `null` where it is not known. */
export interface Stored {
  raw: (Column | null)[];
  filtered: (Column | null)[];
}

export const NONE: Stored = { raw: [], filtered: [] };

/** Of the run that is played, where it is known beforehand. */
export const stored = signal<Stored>(NONE);
