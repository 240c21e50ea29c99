/**
 * From metres to pixels of CSS and back. The axis along the track is `range` of the selection, one
 * for all views; heights and lateral positions are drawn `exaggeration` times larger than lengths.
 */

/** Left free for numbers, and right, by all that shares the ruler. In px. */
export const LEFT = 56;
export const RIGHT = 12;
// Fit fills so much of the height; below the wires there is room for pantographs.
const FILLED = 0.62;
const CENTRE = 0.42;
// Exaggerations that are offered, so that the number on the screen is a plain one.
export const EXAGGERATIONS = [1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000];
/** Shortest range that can be looked at, in m: some elements of a wire. */
export const SHORTEST = 0.5;

export interface Camera {
  /** Ends of what is seen, in m. */
  x0: number;
  x1: number;
  width: number;
  height: number;
  exaggeration: number;
  /** Pixel of a position along the track in m, and of a height (in plan: a lateral position) in m. */
  x(metres: number): number;
  y(metres: number): number;
  /** Position along the track in m at a pixel, and height (lateral position). */
  metres(pixel: number): number;
  up(pixel: number): number;
  /** Pixels of a metre along the track. */
  scale: number;
}

export interface Sight {
  range: [number, number];
  width: number;
  height: number;
  exaggeration: number;
  /** Height in m that stands at the centre, and the share of the picture above it. */
  middle: number;
  centre?: number;
}

export function camera({ range, width, height, exaggeration, middle, centre = CENTRE }: Sight): Camera {
  const [x0, x1] = range;
  const scale = Math.max(1, width - LEFT - RIGHT) / Math.max(x1 - x0, SHORTEST);
  const up = scale * exaggeration;
  const origin = height * centre;
  return {
    x0,
    x1,
    width,
    height,
    exaggeration,
    scale,
    x: (metres) => LEFT + (metres - x0) * scale,
    y: (metres) => origin - (metres - middle) * up,
    metres: (pixel) => x0 + (pixel - LEFT) / scale,
    up: (pixel) => middle + (origin - pixel) / up,
  };
}

/** The largest offered exaggeration with which heights of so many metres fill the picture. */
export function fitted(range: [number, number], heights: number, width: number, height: number): number {
  const { scale } = camera({ range, width, height, exaggeration: 1, middle: 0 });
  const largest = (FILLED * height) / (Math.max(heights, 0.05) * scale);
  return EXAGGERATIONS.filter((one) => one <= largest).at(-1) ?? 1;
}

/** The next larger (or smaller) exaggeration that is offered; at the end it stays. */
export function nextExaggeration(current: number, larger: boolean): number {
  const all = larger ? EXAGGERATIONS : [...EXAGGERATIONS].reverse();
  return all.find((one) => (larger ? one > current * 1.001 : one < current * 0.999)) ?? current;
}

/** A range that is zoomed about a position in m, inside the ends of the line with a margin. */
export function zoomed(
  range: [number, number],
  factor: number,
  about: number,
  whole: [number, number],
): [number, number] {
  const length = Math.min(Math.max((range[1] - range[0]) * factor, SHORTEST), whole[1] - whole[0]);
  const share = (about - range[0]) / (range[1] - range[0]);
  return kept([about - share * length, about + (1 - share) * length], whole);
}

/** A range that is moved back where it leads beyond the whole. */
export function kept([start, end]: [number, number], whole: [number, number]): [number, number] {
  const length = Math.min(end - start, whole[1] - whole[0]);
  const first = Math.min(Math.max(start, whole[0]), whole[1] - length);
  return [first, first + length];
}

const STEPS = [1, 2, 5];

/** A plain step that is not smaller than a length. */
export function plainStep(least: number): number {
  const power = 10 ** Math.floor(Math.log10(least));
  return [...STEPS.map((one) => one * power), 10 * power].find((one) => one >= least) ?? least;
}

/** Plain positions of marks between two values, so that they are at least `least` apart. */
export function ticks(start: number, end: number, least: number): number[] {
  const step = plainStep(least);
  const found: number[] = [];
  for (let n = Math.ceil(start / step - 1e-9); n * step <= end + 1e-9 * step; n++) {
    found.push(Number((n * step).toPrecision(12)));
  }
  return found;
}
