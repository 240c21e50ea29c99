/** Contact force by position along the track as strips draw it, m and N. */
import { signal } from "@preact/signals";
import { below } from "../../drawing/lineIndex.ts";

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
  /** Highest force of the whole run, of which this may be a part: the scale does not jump. */
  top: number;
}

export const NONE: Stored = { raw: [], filtered: [], top: 0 };

/** Highest value of some columns; 0 where none is positive. */
export const topOf = (columns: (Column | null)[]): number =>
  columns.reduce((most, column) => column?.high.reduce((a, b) => (b > a ? b : a), most) ?? most, 0);

/** Largest distance in m of the places of a column in a range; 0 where it has less than two. */
export function widest({ x }: Column, [from, to]: [number, number]): number {
  let most = 0;
  for (let at = Math.max(below(x, from), 1); at < x.length && x[at]! <= to; at++) most = Math.max(most, x[at]! - x[at - 1]!);
  return most;
}

/** Of the run that is played, where it is known beforehand. */
export const stored = signal<Stored>(NONE);

/** Lowest and highest value in each column of pixels; `null` where there is none. */
export type Ends = (from: number, to: number) => [number, number] | null;

/** Ends of a column; a value that is not known, NaN, is none. */
export const columnEnds = ({ x, low, high }: Column): Ends => {
  let at = -1;
  return (from, to) => {
    if (at < 0) at = below(x, from);
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
