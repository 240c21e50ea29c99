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

/** Lowest and highest value in each column of pixels; `null` where there is none. */
export type Ends = (from: number, to: number) => [number, number] | null;

/** Ends of a column; a value that is not known, NaN, is none. */
export const columnEnds = ({ x, low, high }: Column): Ends => {
  let at = 0;
  return (from, to) => {
    while (at > 0 && x[at - 1]! >= from) at--;
    while (at < x.length && x[at]! < from) at++;
    let found: [number, number] | null = null;
    for (; at < x.length && x[at]! < to; at++) {
      const value: [number, number] = [low[at]!, high[at]!];
      if (Number.isNaN(value[0]) || Number.isNaN(value[1])) continue;
      found = found ? [Math.min(found[0], value[0]), Math.max(found[1], value[1])] : value;
    }
    return found;
  };
};

/** Highest value of a column, at least 0. */
export const highest = ({ high }: Column): number => high.reduce((most, value) => (value > most ? value : most), 0);
