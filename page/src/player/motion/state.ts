/**
 * The motion at one time: linear in time between the two moments that are kept on both sides of it.
 * Displacements in m from rest, velocities in m/s, forces in N. A node outside of the recorded
 * window is drawn at rest.
 */
import type { Store } from "./store.ts";
import { lastAt, type Piece, type Track } from "./track.ts";

export interface PantographState {
  /** Position along the track in m; NaN before anything is known. */
  position: number;
  /** Contact force in N. */
  force: number;
  /** Height of the contact wire above it in m. */
  height: number;
  /** Uplift of the contact wire there in m; NaN where it is not known. */
  uplift: number;
  /** Displacements of its masses in m, upwards, from the collector head down. */
  masses: number[];
}

export interface WireMotion {
  up: Float32Array;
  across: Float32Array | null;
  /** Mean velocity upwards between the two moments, m/s. */
  velocity: Float32Array;
  /** Nodes that move now, in ranges [first, end). */
  moving: [number, number][];
}

export interface MotionState {
  wires: WireMotion[];
  /** Tension in N; NaN where it is not known. */
  droppers: Float32Array;
  /** Uplift of the contact wire in m; NaN where it is not known. */
  supports: Float32Array;
  pantographs: PantographState[];
  /** Whether moments near enough on both sides were there. */
  complete: boolean;
}

export interface Sizes {
  wires: readonly number[];
  spatial: boolean;
  droppers: number;
  supports: number;
  pantographs: number;
}

/** Two moments farther apart than so many intervals are not neighbours: something is missing. */
const GAP = 1.6;
/** How far a moment may be from the clock, in s, where rows are their own interval. */
const SLACK = 1e-6;
/** Rows of droppers and supports may be so much rarer than moments, and are mixed nevertheless. */
const RARE = 20;

export function newState(sizes: Sizes): MotionState {
  return {
    wires: sizes.wires.map((count) => ({
      up: new Float32Array(count),
      across: sizes.spatial ? new Float32Array(count) : null,
      velocity: new Float32Array(count),
      moving: [],
    })),
    droppers: new Float32Array(sizes.droppers).fill(NaN),
    supports: new Float32Array(sizes.supports).fill(NaN),
    pantographs: Array.from({ length: sizes.pantographs }, () => ({
      position: NaN, force: NaN, height: NaN, uplift: NaN, masses: [],
    })),
    complete: false,
  };
}

interface Between {
  before: Piece[];
  after: Piece[];
  /** Share of the later one. */
  share: number;
  /** Time between them in s; 0 where there is one alone. */
  apart: number;
  complete: boolean;
}

/** The moments on both sides of a time, `null` where nothing is kept near it. */
export function between(track: Track | undefined, time: number, gap: number): Between | null {
  if (!track || !track.times.length) return null;
  const { times, entries } = track;
  const at = lastAt(times, time);
  const earlier = Math.max(at, 0);
  const later = Math.min(at + 1, times.length - 1);
  const [t0, t1] = [times[earlier]!, times[later]!];
  const near = (moment: number) => Math.abs(moment - time) <= gap + SLACK;
  if (earlier !== later && t1 - t0 <= gap + SLACK) {
    return { before: entries[earlier]!, after: entries[later]!, share: (time - t0) / (t1 - t0), apart: t1 - t0, complete: true };
  }
  const one = Math.abs(t1 - time) < Math.abs(time - t0) ? later : earlier;
  const pieces = entries[one]!;
  return { before: pieces, after: pieces, share: 0, apart: 0, complete: near(times[one]!) };
}

/** Add values with a weight; where pieces overlap the first one counts. */
function add(out: Float32Array, pieces: Piece[], weight: number): void {
  let done = 0;
  for (const { first, values } of pieces) {
    const end = Math.min(first + values.length, out.length);
    for (let node = Math.max(first, done); node < end; node++) out[node]! += weight * values[node - first]!;
    done = Math.max(done, end);
  }
}

/** Set mean velocities; a node that only one of both windows has keeps 0. */
function difference(out: Float32Array, { before, after, apart }: Between): void {
  for (const one of before) {
    for (const two of after) {
      const first = Math.max(one.first, two.first);
      const end = Math.min(one.first + one.values.length, two.first + two.values.length, out.length);
      for (let node = first; node < end; node++) {
        out[node] = (two.values[node - two.first]! - one.values[node - one.first]!) / apart;
      }
    }
  }
}

function clear(out: Float32Array, ranges: [number, number][]): void {
  for (const [first, end] of ranges) out.fill(0, first, end);
}

/** Ranges of nodes that any of the pieces has, joined. */
export function ranges(pieces: Piece[], count: number): [number, number][] {
  const all = pieces
    .map(({ first, values }): [number, number] => [first, Math.min(first + values.length, count)])
    .filter(([first, end]) => end > first)
    .sort((a, b) => a[0] - b[0]);
  const joined: [number, number][] = [];
  for (const [first, end] of all) {
    const last = joined.at(-1);
    if (last && first <= last[1]) last[1] = Math.max(last[1], end);
    else joined.push([first, end]);
  }
  return joined;
}

function setWire(wire: WireMotion, up: Between | null, across: Between | null): void {
  clear(wire.up, wire.moving);
  clear(wire.velocity, wire.moving);
  if (wire.across) clear(wire.across, wire.moving);
  wire.moving = up ? ranges([...up.before, ...up.after], wire.up.length) : [];
  if (!up) return;
  add(wire.up, up.before, 1 - up.share);
  if (up.apart > 0) {
    add(wire.up, up.after, up.share);
    difference(wire.velocity, up);
  }
  if (!wire.across || !across) return;
  add(wire.across, across.before, 1 - across.share);
  if (across.apart > 0) add(wire.across, across.after, across.share);
}

/** Values that are known on both sides are mixed; of others the nearer moment counts, NaN where none is. */
function setValues(out: Float32Array, found: Between | null): void {
  out.fill(NaN);
  if (!found) return;
  for (const { first, values } of found.before) out.set(values.subarray(0, Math.max(0, out.length - first)), first);
  if (found.apart === 0) return;
  for (const { first, values } of found.after) {
    const end = Math.min(first + values.length, out.length);
    for (let at = first; at < end; at++) {
      const before = out[at]!;
      const after = values[at - first]!;
      out[at] = Number.isNaN(before) ? after : before + found.share * (after - before);
    }
  }
}

const HEAD = 4; // position, force, height, uplift; masses follow

function setPantograph(out: PantographState, found: Between | null): void {
  const a = found?.before[0]?.values;
  const b = found?.after[0]?.values;
  const mixed = (at: number): number => {
    if (!found || !a || !b || at >= a.length) return NaN;
    return found.apart > 0 && at < b.length ? a[at]! + found.share * (b[at]! - a[at]!) : a[at]!;
  };
  [out.position, out.force, out.height, out.uplift] = [mixed(0), mixed(1), mixed(2), mixed(3)];
  out.masses.length = 0;
  for (let at = HEAD; a && at < a.length; at++) out.masses.push(mixed(at));
}

/**
 * Set the state to a time in s.
 *
 * `every` is the distance of moments that were asked for, in s: moments farther apart are not
 * mixed, the nearer one is shown and the state is not complete.
 */
export function sample(store: Store, time: number, every: number, state: MotionState): void {
  const gap = Math.max(every * GAP, SLACK);
  const at = (name: string, rare = 1) => between(store.tracks.get(name), time, gap * rare);
  state.wires.forEach((wire, number) => {
    setWire(wire, at(`wire.${number}.up`), wire.across && at(`wire.${number}.across`));
  });
  setValues(state.droppers, at("droppers", RARE));
  setValues(state.supports, at("supports", RARE));
  const first = at("pantograph.0");
  state.pantographs.forEach((one, number) => setPantograph(one, at(`pantograph.${number}`)));
  state.complete = first?.complete ?? false;
}
