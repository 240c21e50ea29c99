/**
 * The motion that a report carries: channels of the stream, thinned, as integers of 16 bits with a
 * stated step, in base64, little-endian. Times in s of the run.
 */
import type { Geometry } from "../../drawing/geometry.ts";
import type { Store } from "../motion/store.ts";
import type { History } from "../motion/history.ts";
import type { PantographAbout } from "../player.ts";
import type { Column } from "../views/columns.ts";

/** One piece of a channel in each row. */
export interface Block {
  /** As on the stream, such as `wire.0.up`. */
  name: string;
  /** Of the integers, in the unit of the channel; `null`: singles. */
  step: number | null;
  /** Number of the first value of each row, u32. */
  first: string;
  /** Number of values of each row, u32. */
  count: string;
  values: string;
}

type PackedColumn = Record<keyof Column, string> | null;

export interface Packed {
  geometry: Geometry;
  pantographs: PantographAbout[];
  /** Doubles, s. */
  times: string;
  row_s: number;
  /** Where it begins to be played, in s. */
  begin_s: number;
  blocks: Block[];
  force: { raw: PackedColumn[]; filtered: PackedColumn[] };
  /** Positions in m of the worst places, ascending. */
  worst: number[];
}

/** A value that is not known. */
const UNKNOWN = -32768;

function bytes(text: string): ArrayBuffer {
  const characters = atob(text);
  const found = new Uint8Array(characters.length);
  for (let at = 0; at < found.length; at++) found[at] = characters.charCodeAt(at);
  return found.buffer;
}

/** Values of integers with a step; what is not known is NaN. */
export function scaled(integers: Int16Array, step: number): Float32Array {
  return Float32Array.from(integers, (value) => (value === UNKNOWN ? NaN : value * step));
}

export const timesOf = (packed: Packed): Float64Array => new Float64Array(bytes(packed.times));

export function columnOf(packed: PackedColumn): Column | null {
  if (!packed) return null;
  const values = (text: string) => new Float32Array(bytes(text));
  return { x: values(packed.x), low: values(packed.low), high: values(packed.high) };
}

/** Put all rows into a store, which has them for good. */
export function unpack(packed: Packed, store: Store, history: History): void {
  const times = timesOf(packed);
  for (const { name, step, first, count, values } of packed.blocks) {
    const all = step === null ? new Float32Array(bytes(values)) : scaled(new Int16Array(bytes(values)), step);
    const firsts = new Uint32Array(bytes(first));
    const counts = new Uint32Array(bytes(count));
    let at = 0;
    times.forEach((time, row) => {
      const piece = { first: firsts[row]!, values: all.subarray(at, (at += counts[row]!)) };
      store.add(name, time, piece);
      if (name === "supports") history.addSupports(piece.first, piece.values);
    });
  }
}
