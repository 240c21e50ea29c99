/** Between positions along the track and times: where the first pantograph stands. m, s. */
import { clock } from "../state/selection.ts";
import { wentTo, worst } from "../state/worst.ts";
import { jump } from "./clock.ts";
import { lastAt } from "./motion/track.ts";
import { scene, store } from "./player.ts";

/** Speed of the first pantograph in m/s, of the frames that are kept; NaN where they do not say it. */
export function speed(): number {
  const { times, entries } = store.track("pantograph.0");
  if (times.length < 2) return NaN;
  const x = (at: number) => entries[at]![0]!.values[0]!;
  const last = times.length - 1;
  return (x(last) - x(0)) / (times[last]! - times[0]!);
}

/**
 * Where the first pantograph is at the clock's time, from the frame before it on; NaN where no frame is
 * kept. A clock that has just jumped has no frame of its own yet, and two keys follow one another faster.
 */
export function placeNow(): number {
  const { times, entries } = store.track("pantograph.0");
  const at = Math.max(lastAt(times, clock.time_s.peek()), 0);
  const x = entries[at]?.[0]?.values[0] ?? NaN;
  const away = clock.time_s.peek() - (times[at] ?? NaN);
  return away === 0 ? x : x + away * speed();
}

/** The time at which the first pantograph is at a position; `null` where it is not known. */
export function timeAt(x: number): number | null {
  const now = placeNow();
  const v = speed();
  if (!Number.isFinite(now) || !Number.isFinite(v) || v === 0) return null;
  return clock.time_s.peek() + (x - now) / v;
}

/** Stand at a position, `before_s` s earlier; the speed of the frames that are kept leads there. */
export function standAt(x: number, { before_s = 0 } = {}): void {
  const time = timeAt(x);
  if (time !== null) jump(time - before_s);
}

/** Go to the next or previous start of a span. */
export function stepSpan(direction: 1 | -1): void {
  const spans = scene.peek()?.geometry.spans ?? [];
  const now = placeNow();
  const starts = [...spans.map((span) => span.start_m), ...spans.slice(-1).map((span) => span.end_m)];
  // A place that the clock stands at, to a rounding error, is not the next one.
  const next = direction > 0 ? starts.find((x) => x > now + 0.01) : starts.findLast((x) => x < now - 0.01);
  if (next !== undefined) standAt(next);
}

/** Go to the next or previous worst place, a second before the pantograph reaches it; it is marked. */
export function stepWorst(direction: 1 | -1): void {
  const v = speed();
  const now = placeNow() + BEFORE * (Number.isFinite(v) ? v : 0);
  const all = worst.peek();
  // After the last one comes the first.
  const next =
    direction > 0
      ? (all.find(({ position_m: x }) => x > now + APART) ?? all[0])
      : (all.findLast(({ position_m: x }) => x < now - APART) ?? all.at(-1));
  if (!next) return;
  standAt(next.position_m, { before_s: BEFORE });
  wentTo.value = next;
}

const BEFORE = 1; // s
/** Nearer than so many m is the place that the clock stands at. */
const APART = 0.5;
