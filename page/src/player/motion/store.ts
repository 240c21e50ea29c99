/**
 * Frames of a motion in a bounded number of bytes, and which ranges of time are complete. Times
 * are in s of the run. What is farthest from the clock is forgotten first.
 */
import { Track, type Piece } from "./track.ts";

/** Times from `from` to `to` are there, rows `every` apart (s; 0: each recorded row). */
export interface Covered {
  from: number;
  to: number;
  every: number;
}

/**
 * Enough for ten thousand moments of 6 kB, 50 s of rows 5 ms apart; with less the player asks again
 * more often, with more a page grows beyond what an old notebook has.
 */
export const BUDGET = 64 * 1024 * 1024; // bytes
/** Forgetting goes so far below the budget that it is not done for every frame. */
const KEPT_SHARE = 0.9;
/** Neighbouring ranges join where less than so many s are between them: rounding of times. */
const JOIN = 1e-6;

export class Store {
  readonly tracks = new Map<string, Track>();
  private covered: Covered[] = [];

  constructor(readonly budget = BUDGET) {}

  get bytes(): number {
    let sum = 0;
    for (const track of this.tracks.values()) sum += track.bytes;
    return sum;
  }

  track(name: string): Track {
    let found = this.tracks.get(name);
    if (!found) this.tracks.set(name, (found = new Track()));
    return found;
  }

  add(name: string, time: number, piece: Piece): void {
    this.track(name).add(time, piece);
  }

  /** Times of moments: those of the channel of the first pantograph, which each moment has. */
  get moments(): readonly number[] {
    return this.track("pantograph.0").times;
  }

  /** A range was received whole. */
  cover(range: Covered): void {
    const others = this.covered.flatMap((one) => {
      if (one.to < range.from - JOIN || one.from > range.to + JOIN) return [one];
      // A finer range that is there stays; of a coarser one, what the new range does not reach.
      if (one.every < range.every) return [one];
      const rest: Covered[] = [];
      if (one.every === range.every) {
        range = { from: Math.min(one.from, range.from), to: Math.max(one.to, range.to), every: range.every };
        return rest;
      }
      if (one.from < range.from - JOIN) rest.push({ ...one, to: range.from });
      if (one.to > range.to + JOIN) rest.push({ ...one, from: range.to });
      return rest;
    });
    this.covered = [...others, range].sort((a, b) => a.from - b.from);
  }

  /** The end of what is there from `time` on in a direction, with rows at most `every` apart. */
  reach(time: number, direction: 1 | -1, every: number): number {
    const fine = this.covered.filter((one) => one.every <= every + JOIN);
    if (direction < 0) fine.reverse();
    let end = time;
    for (let more = true; more; ) {
      more = false;
      for (const { from, to } of fine) {
        if (from <= end + JOIN && to >= end - JOIN) {
          const next = direction > 0 ? Math.max(end, to) : Math.min(end, from);
          more ||= Math.abs(next - end) > JOIN;
          end = next;
        }
      }
    }
    return end;
  }

  /** Forget the farthest from the clock until the budget holds; `true` where something went. */
  trim(time: number): boolean {
    const bytes = this.bytes;
    const times = this.moments;
    if (bytes <= this.budget || times.length < 2) return false;
    const keep = Math.max(2, Math.floor((times.length * KEPT_SHARE * this.budget) / bytes));
    let first = 0;
    let last = times.length - 1;
    while (last - first + 1 > keep) {
      if (time - times[first]! > times[last]! - time) first++;
      else last--;
    }
    this.keep(times[first]!, times[last]!);
    return true;
  }

  private keep(from: number, to: number): void {
    for (const track of this.tracks.values()) track.keep(from, to);
    this.covered = this.covered
      .filter((one) => one.to > from && one.from < to)
      .map((one) => ({ ...one, from: Math.max(one.from, from), to: Math.min(one.to, to) }));
  }

  clear(): void {
    this.tracks.clear();
    this.covered = [];
  }
}
