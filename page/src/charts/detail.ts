/** More samples for a range that is shown: which range to ask for, and when none is needed. */
import type { Range } from "./extent.ts";
import type { Figure, Shown } from "./figure.ts";

/** Ranges are asked for so many times wider than shown, so that moving them shows something at once. */
const AROUND = 3;
/** A range is asked for anew where samples for one this many times wider are all there are. */
const COARSE = 2 * AROUND;
/** Samples on a pixel: the lowest and the highest of its bucket. */
const ON_A_PIXEL = 2;
/** As many as the server gives. */
const MOST_POINTS = 40_000;

/** What is there: the range that was asked for (null: all of it), and whether all samples came. */
export interface Loaded {
  range: Range | null;
  whole: boolean;
}

/** Whether every curve has all of its samples. */
export function isWhole(figure: Figure): boolean {
  return figure.layers.every((layer) => layer.kind !== "curve" || layer.x.length >= layer.samples);
}

/**
 * The question for a range, or null where what is there will do.
 *
 * @param shown what is seen; null for all
 * @param all first and last place of the whole figure
 * @param width of the frame in px
 */
export function question(shown: Range, all: Range, width: number, loaded: Loaded | null): Shown | null {
  const extent = shown[1] - shown[0];
  const points = Math.min(MOST_POINTS, Math.round(AROUND * ON_A_PIXEL * width));
  if (loaded) {
    if (loaded.whole && loaded.range === null) return null;
    const [low, high] = loaded.range ?? all;
    const inside = low <= Math.max(shown[0], all[0]) && Math.min(shown[1], all[1]) <= high;
    if (inside && (loaded.whole || (high - low) / extent <= COARSE)) return null;
  }
  const beside = ((AROUND - 1) / 2) * extent;
  const [from, to] = [shown[0] - beside, shown[1] + beside];
  return from <= all[0] && to >= all[1] ? { points } : { from, to, points };
}

/** What is there after an answer. */
export function loadedBy(asked: Shown, figure: Figure): Loaded {
  const range: Range | null = asked.from === undefined || asked.to === undefined ? null : [asked.from, asked.to];
  // Of a range a curve has fewer samples than in all: it is whole where it was not thinned.
  const most = asked.points / 2;
  const whole = range ? figure.layers.every((one) => one.kind !== "curve" || one.x.length < most) : isWhole(figure);
  return { range, whole };
}
