/**
 * What is played: a source, its line, its frames, and the state at the clock's time. One frame of
 * the screen does all: the clock goes on, frames are asked for, the state is set, views are drawn.
 */
import { batch, effect, signal } from "@preact/signals";
import type { Geometry } from "../drawing/geometry.ts";
import { moved, played, redrawNow, showing, type MovedWire } from "../drawing/scene.ts";
import { clock } from "../state/selection.ts";
import { growing, pause, setEnds, tick } from "./clock.ts";
import { History } from "./motion/history.ts";
import { newState, sample, type MotionState, type Sizes } from "./motion/state.ts";
import { Store } from "./motion/store.ts";
import { lastAt } from "./motion/track.ts";
import { everyAt } from "./motion/wanted.ts";
import { Pace } from "./pace.ts";

export interface PantographAbout {
  name: string;
  /** Names of its masses, from the collector head down. */
  masses: string[];
}

/** What of a motion does not change while it is played. */
export interface Scene {
  geometry: Geometry;
  pantographs: PantographAbout[];
  /** Interval of rows in s; 0 where it is not known. */
  row_s: number;
  /** Whether the motion of wires is there. */
  wires: boolean;
  /** Which attempt of a search for the static force it is, from 1; `null`: it is the run. */
  search: number | null;
}

/** Where rows have no known interval, moments so far apart in s are neighbours. */
const UNKNOWN_ROW = 0.05;
/** Longest step of the clock in s: a page that slept goes on where it was. */
const LONGEST = 0.25;

export const scene = signal<Scene | null>(null);
/** Frames at the clock's time are on their way. */
export const waiting = signal(false);

export const store = new Store();
export const history = new History();
export const state: { current: MotionState } = { current: newState({ wires: [], spatial: false, droppers: 0, supports: 0, pantographs: 0 }) };
/** Called after each change of the state, in the same frame of the screen. */
export const viewers = new Set<() => void>();
/** Asks for frames; set while a source is open. */
export const asking: { current: (() => void) | null } = { current: null };

let awake = false;
let before = 0;

export const pace = new Pace();

/** Seconds of the run in a second of watching: the newest frame is followed at its own speed. */
export function rate(): number {
  return clock.live.peek() ? Math.max(pace.value, 1) : clock.rate.peek();
}

/** Distance in s of neighbouring moments: what is asked for at this rate is what is waited for. */
export function every(): number {
  const row = scene.peek()?.row_s || UNKNOWN_ROW;
  return Math.max(row, everyAt(rate(), row));
}

/** The last time up to `time` whose frames are there, from the clock on without a gap. */
export function limit(time: number): number {
  const { times } = store.track("pantograph.0");
  const gap = every() * 1.6;
  let at = lastAt(times, clock.time_s.peek());
  if (at < 0) return times.length && times[0]! - time <= gap ? time : clock.time_s.peek();
  while (times[at + 1] !== undefined && times[at]! < time && times[at + 1]! - times[at]! <= gap) at++;
  // Moments are asked for at their distance, and the last one of a run may be less than it before the end.
  const rest = clock.end_s.peek() - times[at]!;
  if (!growing.peek() && rest >= 0 && rest <= gap) return time;
  return Math.min(time, times[at]!);
}

function show(): void {
  const now = scene.peek();
  if (now) {
    sample(store, clock.time_s.peek(), every(), state.current);
    moved.current = { wires: state.current.wires.map(movedWire), dropper_N: state.current.droppers };
    waiting.value = !state.current.complete;
  }
  for (const view of viewers) view();
  redrawNow();
}

function movedWire({ up, across, moving }: MotionState["wires"][number]): MovedWire | null {
  const first = moving[0]?.[0];
  const end = moving.at(-1)?.[1];
  if (first === undefined || end === undefined) return null;
  return { first, up: up.subarray(first, end), across: across && across.subarray(first, end) };
}

function frame(now: number): void {
  awake = false;
  // Views are drawn at the end, once, of all that has changed.
  batch(() => {
    tick(Math.min((now - before) / 1000, LONGEST), limit);
    before = now;
    asking.current?.();
    show();
  });
  if (clock.playing.peek()) wake();
}

/** Have one frame of the screen done. */
export function wake(): void {
  if (awake) return;
  awake = true;
  requestAnimationFrame((now) => {
    if (now - before > 1000 * LONGEST) before = now - 1000 / 60;
    frame(now);
  });
}

/** Begin with an empty store at the start: another source is opened. */
export function begin(): void {
  store.clear();
  history.clear();
  batch(() => {
    pause();
    clock.time_s.value = 0;
    scene.value = null;
    played.value = null;
    moved.current = null;
  });
}

const sizesOf = ({ geometry, pantographs }: Scene): Sizes => ({
  wires: geometry.wires.map((wire) => wire.x.length),
  spatial: geometry.spatial,
  droppers: geometry.droppers.length,
  supports: geometry.supports.length,
  pantographs: pantographs.length,
});

/** Whether one motion can go on where another one is: as many nodes, droppers, supports, pantographs. */
export const fits = (one: Scene, other: Scene): boolean =>
  JSON.stringify(sizesOf(one)) === JSON.stringify(sizesOf(other));

/** The line and what moves on it are known. */
export function present(next: Scene, start: number, end: number, more: boolean): void {
  const { geometry } = next;
  const before = scene.peek();
  // What is shown stays until there are frames of what comes.
  if (!before || !fits(before, next)) state.current = newState(sizesOf(next));
  batch(() => {
    scene.value = next;
    played.value = geometry;
    showing.value = "played";
    setEnds(start, end, more);
  });
  wake();
}

effect(() => {
  // Whoever sets the clock, also from another room, has a frame done.
  void [clock.time_s.value, clock.playing.value, clock.rate.value, clock.live.value];
  wake();
});
