/** Of what is drawn, the thing nearest to the pointer, and its numbers as lines of text. */
import type { Figure, Layer, Tip } from "./figure.ts";
import { formed } from "./numbers.ts";

/** Farther than this in px from the pointer, nothing is told. */
const NEAR = 24;

interface Places {
  x: (value: number) => number;
  y: (value: number) => number;
}

interface Found {
  layer: Layer;
  index: number;
  distance: number;
}

function nearestOf(layer: Layer, at: { x: number; y: number }, px: number, py: number, to: Places): Found | null {
  let best: Found | null = null;
  const consider = (index: number, distance: number) => {
    if (distance <= NEAR && distance < (best?.distance ?? Infinity)) best = { layer, index, distance };
  };
  if (layer.kind === "curve" || layer.kind === "points") {
    for (let k = 0; k < layer.x.length; k++) {
      const dx = Math.abs(to.x(layer.x[k]!) - px);
      // Of a curve the sample below the pointer counts, wherever it is on the other axis.
      const dy = Math.abs(to.y(layer.y[k]!) - py);
      if (dx <= NEAR) consider(k, layer.kind === "curve" ? Math.max(dx, dy / 8) : Math.hypot(dx, dy));
    }
  } else if (layer.kind === "bars") {
    layer.left.forEach((left, k) => {
      const inside = left <= at.x && at.x <= layer.right[k]! && layer.low[k]! <= at.y && at.y <= layer.high[k]!;
      if (inside) consider(k, 1);
    });
  } else if (layer.kind === "map") {
    const [rows, columns] = layer.shape;
    const column = Math.floor(((at.x - layer.x[0]) / (layer.x[1] - layer.x[0])) * columns);
    const row = Math.floor(((at.y - layer.y[0]) / (layer.y[1] - layer.y[0])) * rows);
    if (column >= 0 && column < columns && row >= 0 && row < rows) consider(row * columns + column, NEAR);
  }
  return best;
}

function line(tip: Tip, layer: Layer, index: number, at: { x: number; y: number }): string {
  let value: string;
  if (layer.kind === "map") value = formed(layer.values[index]!, tip.form);
  else if (typeof tip.values === "string") {
    const places = layer as unknown as Record<string, Float32Array>;
    value = formed(places[tip.values]?.[index] ?? at[tip.values as "x" | "y"], tip.form);
  } else if ("texts" in tip.values) value = tip.values.texts[index] ?? "";
  else value = formed(tip.values.numbers[index] ?? NaN, tip.form);
  return `${tip.label} ${value}${tip.unit ? ` ${tip.unit}` : ""}`.trim();
}

/**
 * What stands under the pointer, in words; empty for nothing.
 *
 * @param at place of the pointer in the units of the axes
 * @param px, py the same in pixels
 */
export function told(
  figure: Figure,
  at: { x: number; y: number },
  px: number,
  py: number,
  to: Places,
  isHidden: (layer: Layer) => boolean,
): string {
  let best: Found | null = null;
  for (const layer of figure.layers) {
    if (!layer.tips.length || isHidden(layer)) continue;
    const found = nearestOf(layer, at, px, py, to);
    if (found && found.distance <= (best?.distance ?? Infinity)) best = found;
  }
  if (!best) return "";
  const { layer, index } = best;
  return layer.tips.map((tip) => line(tip, layer, index, at)).join(" · ");
}
