/** The clock of the player: play, pause, rate, jump, step, follow the newest frame. Times in s. */
import { batch, signal } from "@preact/signals";
import { clock } from "../state/selection.ts";

export const RATES = [0.05, 0.1, 0.25, 0.5, 1, 2, 5, 10, 20] as const;
/**
 * The clock comes near to the newest frame of a live run in so many s: shorter shows how frames
 * arrive in bundles, longer lags behind the run.
 */
const FOLLOW = 0.15;
/** Frames of the screen in a second. */
const SCREEN = 60; // 1/s

/** Whether more frames will come; the stream says it. */
export const growing = signal(false);

export function setEnds(start: number, end: number, more: boolean): void {
  batch(() => {
    growing.value = more;
    clock.start_s.value = start;
    clock.end_s.value = Math.max(end, start);
    if (!more && clock.live.peek() && clock.time_s.peek() >= end) clock.live.value = false;
    clock.time_s.value = Math.min(Math.max(clock.time_s.peek(), start), clock.end_s.peek());
  });
}

/**
 * Go on by so many s of the wall. `limit` gives the last time up to a wanted one whose frames are
 * there: the clock waits for them, and never shows a line that was not computed.
 */
export function tick(wall: number, limit: (time: number) => number = (time) => time): void {
  if (!clock.playing.peek()) return;
  const time = clock.time_s.peek();
  const end = clock.end_s.peek();
  const goal = clock.live.peek()
    ? end - (end - time) * Math.exp(-wall / FOLLOW)
    : Math.min(time + wall * clock.rate.peek(), end);
  const next = Math.max(time, limit(goal));
  const arrived = end - next < 1e-4 * Math.max(end - clock.start_s.peek(), 1e-3);
  batch(() => {
    clock.time_s.value = arrived && !growing.peek() ? end : next;
    if (arrived && growing.peek()) clock.live.value = true;
    if (arrived && !growing.peek()) clock.playing.value = clock.live.value = false;
  });
}

export function play(): void {
  batch(() => {
    // At the end of a whole run there is nothing to play but from its start; less than a frame is not seen to move.
    const left = clock.end_s.peek() - clock.time_s.peek();
    if (!growing.peek() && left < clock.rate.peek() / SCREEN) clock.time_s.value = clock.start_s.peek();
    clock.playing.value = true;
  });
}

export function pause(): void {
  batch(() => (clock.playing.value = clock.live.value = false));
}

export const toggle = (): void => (clock.playing.peek() ? pause() : play());

export function jump(time: number): void {
  batch(() => {
    clock.live.value = false;
    clock.time_s.value = Math.min(Math.max(time, clock.start_s.peek()), clock.end_s.peek());
  });
}

/** Follow the newest frame. */
export function follow(): void {
  batch(() => {
    clock.time_s.value = clock.end_s.peek();
    clock.live.value = growing.peek();
    clock.playing.value = growing.peek() || clock.playing.peek();
  });
}

/** The next rate up or down; between two of the list, the next one in this direction. */
export function changeRate(direction: 1 | -1): void {
  const now = clock.rate.peek();
  const next = direction > 0 ? RATES.find((rate) => rate > now) : RATES.findLast((rate) => rate < now);
  if (next !== undefined) clock.rate.value = next;
}

/** A step to a neighbouring row, `row` s away. */
export function step(direction: 1 | -1, row: number): void {
  pause();
  jump(clock.time_s.peek() + direction * row);
}
