/** A map of numbers → an image in the colours of a scale; what is not a number is transparent. */
import { colour, pixel, shades } from "./colours.ts";
import type { Grid, Scale } from "./figure.ts";

/** Pixels of a map, the first row of values at the bottom. */
export function pixels(values: Float32Array, shape: [number, number], scale: Scale, under: number | null): Uint32Array {
  const [rows, columns] = shape;
  const table = shades(scale.order);
  const found = new Uint32Array(rows * columns);
  const factor = (table.length - 1) / (scale.high - scale.low || 1);
  for (let row = 0; row < rows; row++) {
    const into = (rows - 1 - row) * columns;
    for (let column = 0; column < columns; column++) {
      const value = values[row * columns + column]!;
      if (Number.isNaN(value)) continue;
      const place = Math.round((value - scale.low) * factor);
      const below = place < 0 && under !== null;
      found[into + column] = below ? under : table[Math.min(Math.max(place, 0), table.length - 1)]!;
    }
  }
  return found;
}

const drawn = new WeakMap<Float32Array, HTMLCanvasElement>();

/** The image of a map, made once. */
export function imageOf(grid: Pick<Grid, "values" | "shape">, scale: Scale): HTMLCanvasElement {
  const known = drawn.get(grid.values);
  if (known) return known;
  const canvas = document.createElement("canvas");
  const [rows, columns] = grid.shape;
  [canvas.width, canvas.height] = [columns, rows];
  const under = scale.under ? pixel(colour(scale.under)) : null;
  const bytes = new Uint8ClampedArray(pixels(grid.values, grid.shape, scale, under).buffer as ArrayBuffer);
  canvas.getContext("2d")?.putImageData(new ImageData(bytes, columns, rows), 0, 0);
  drawn.set(grid.values, canvas);
  return canvas;
}
