/** Ranges of axes: those of a figure, else around what its layers show. */
import type { Axis, Layer } from "./figure.ts";

export type Range = [number, number];

/** Part of the range of the data that an end without a given value stays away from them. */
const PADDING = 0.04;

function numbersOf(layer: Layer, along: "x" | "y"): ArrayLike<number>[] {
  const isX = along === "x";
  switch (layer.kind) {
    case "curve":
    case "points":
    case "texts":
      return [isX ? layer.x : layer.y];
    case "area":
      return isX ? [layer.x] : [layer.low, layer.high];
    case "segments":
      return isX ? [layer.x0, layer.x1] : [layer.y0, layer.y1];
    case "bars":
      return isX ? [layer.left, layer.right] : [layer.low, layer.high];
    case "map":
      return [isX ? layer.x : layer.y];
    default:
      return []; // strips and rules take the range that is there
  }
}

/** The ends of an axis at first. */
export function ends(axis: Axis, layers: Layer[], along: "x" | "y"): Range {
  let [low, high] = [Infinity, -Infinity];
  if (axis.low === null || axis.high === null) {
    for (const layer of layers) {
      for (const values of layer.hidden ? [] : numbersOf(layer, along)) {
        for (let k = 0; k < values.length; k++) {
          const value = values[k]!;
          if (!Number.isFinite(value) || (axis.logarithmic && value <= 0)) continue;
          if (value < low) low = value;
          if (value > high) high = value;
        }
      }
    }
    if (low > high) [low, high] = axis.logarithmic ? [1, 10] : [0, 1];
    if (axis.logarithmic) {
      const factor = high > low ? (high / low) ** PADDING : 2;
      [low, high] = [low / factor, high * factor];
    } else {
      const margin = PADDING * (high - low) || 0.5 * Math.max(Math.abs(high), 1);
      [low, high] = [low - margin, high + margin];
    }
  }
  return [axis.low ?? low, axis.high ?? high];
}

/** A range of the same extent that lies within bounds; the bounds where it is wider than they are. */
export function within([low, high]: Range, bounds: Range | null): Range {
  if (!bounds) return [low, high];
  const extent = high - low;
  if (extent >= bounds[1] - bounds[0]) return bounds;
  if (low < bounds[0]) return [bounds[0], bounds[0] + extent];
  if (high > bounds[1]) return [bounds[1] - extent, bounds[1]];
  return [low, high];
}

/** A range enlarged by a factor around a place; a logarithmic one by its powers. */
export function zoomed([low, high]: Range, around: number, factor: number, logarithmic = false): Range {
  if (!logarithmic) return [around + (low - around) * factor, around + (high - around) * factor];
  return [around * (low / around) ** factor, around * (high / around) ** factor];
}

/** A range moved by a part of itself. */
export function moved([low, high]: Range, part: number): Range {
  const by = part * (high - low);
  return [low + by, high + by];
}
