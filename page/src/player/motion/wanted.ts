/** What is asked for next: ahead of the clock first, then behind it. Times in s of the run. */
import type { Store } from "./store.ts";

export interface Wish {
  from_s: number;
  to_s: number;
  every_s: number;
}

export interface Situation {
  time: number;
  rate: number;
  start: number;
  /** The newest row that is there to be asked for. */
  edge: number;
  /** Interval of the recorded rows; 0 where it is not known. */
  row: number;
}

/** Frames of the screen in a second: finer moments than these are not seen. */
const SCREEN = 60; // 1/s
/** So much is asked for at once, in s of watching: more makes jumps wait, less makes many questions. */
const CHUNK = 1.5;
/** So much shall be there ahead of the clock, and behind it. */
const AHEAD = 4;
const BEHIND = 2;
/** At slow rates so many s of the run at least, so that steps and a faster rate find something. */
const LEAST = 0.1;
/** Shorter pieces than these many rows are not asked for alone. */
const ROWS = 4;

/**
 * The distance of moments at a rate in s; 0 is each recorded row. In powers of two of the screen's
 * frames: a rate that changes a little does not ask for what is there.
 */
export function everyAt(rate: number, row: number): number {
  const seen = 2 ** Math.floor(Math.log2(rate)) / SCREEN;
  return seen <= Math.max(row, 1e-9) * 1.5 ? 0 : seen;
}

/** The next piece to ask for, or `null` where all that is soon needed is there. */
export function wanted(store: Store, now: Situation): Wish | null {
  const every = everyAt(now.rate, now.row);
  const chunk = Math.max(CHUNK * now.rate, LEAST);
  const least = Math.max(ROWS * now.row, 1e-6);
  const time = Math.min(Math.max(now.time, now.start), now.edge);
  const room = store.budget * 0.8;

  const forward = store.reach(time, 1, every);
  const goal = Math.min(time + Math.max(AHEAD * now.rate, LEAST), now.edge);
  const nearEnd = now.edge - forward <= least && goal - forward > 1e-6;
  if (goal - forward > least || nearEnd) {
    return { from_s: forward, to_s: Math.min(forward + chunk, now.edge), every_s: every };
  }
  if (store.bytes > room) return null;
  const backward = store.reach(time, -1, every);
  const back = Math.max(time - Math.max(BEHIND * now.rate, LEAST), now.start);
  if (backward - back > least) {
    return { from_s: Math.max(backward - chunk, now.start), to_s: backward, every_s: every };
  }
  return null;
}
