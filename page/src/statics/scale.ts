/** A scale that holds its data: it ends at the tick below the lowest value, and above the highest. */
import { plainStep, ticks } from "../drawing/camera.ts";

/** The smallest range of values, as a share of the largest: noise is not blown up. */
const LEAST = 1e-3;

export interface Scale {
  low: number;
  high: number;
  ticks: number[];
}

/** `most`: how many steps there is room for. */
export function scaleOf(values: readonly number[], most: number): Scale {
  const [least, greatest] = [Math.min(...values), Math.max(...values)];
  const middle = (least + greatest) / 2;
  const half = Math.max(greatest - least, LEAST * Math.abs(middle), Number.EPSILON) / 2;
  const step = plainStep((2 * half) / Math.max(1, most - 1));
  const [low, high] = [Math.floor((middle - half) / step) * step, Math.ceil((middle + half) / step) * step];
  return { low, high, ticks: ticks(low, high, step) };
}
