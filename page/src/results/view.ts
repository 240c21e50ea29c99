/** The part of track and time that the space–time view shows, and places of it on its canvas. */
import { within, zoomed, type Range } from "../charts/extent.ts";

/** What the server tells of a part, besides the velocities. */
export interface About {
  recorded: true;
  rows: number;
  columns: number;
  /** In m and s. */
  x: Range;
  t: Range;
  whole_x: Range;
  whole_t: Range;
  /** End of the scale, and the largest velocity of a node, in m/s. */
  scale_end: number;
  largest: number;
  /** In m/s; null of a rail. */
  wave_speed: number | null;
  /** Straight pieces of fronts: x, t of both ends. */
  fronts: [number, number, number, number][];
  supports: number[];
  paths: { name: string; colour: string; x: number[]; t: number[] }[];
}

export interface Part {
  x: Range;
  t: Range;
}

/** A frame in px: the axes stand to its left and below it. */
export interface Frame {
  left: number;
  top: number;
  width: number;
  height: number;
}

/** Time runs upwards, as position runs to the right. */
export function placesOf({ x, t }: Part, { left, top, width, height }: Frame) {
  return {
    x: (value: number) => left + ((value - x[0]) / (x[1] - x[0])) * width,
    t: (value: number) => top + height - ((value - t[0]) / (t[1] - t[0])) * height,
    backX: (px: number) => x[0] + ((px - left) / width) * (x[1] - x[0]),
    backT: (py: number) => t[0] + ((top + height - py) / height) * (t[1] - t[0]),
  };
}

/** A part enlarged around a place, within all there is. */
export function zoomedPart(part: Part, at: { x: number; t: number }, factor: number, whole: Part): Part {
  return {
    x: within(zoomed(part.x, at.x, factor), whole.x),
    t: within(zoomed(part.t, at.t, factor), whole.t),
  };
}

/** Round numbers inside of a range, about so many. */
export function ticks([low, high]: Range, about: number): { at: number[]; step: number } {
  const rough = (high - low) / Math.max(about, 1);
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map((one) => one * power).find((one) => one >= rough * (1 - 1e-9)) ?? 10 * power;
  const at: number[] = [];
  for (let k = Math.ceil(low / step); k * step <= high; k++) at.push(k * step);
  return { at, step };
}
