/** What stands at a place of the drawing; distances in px of CSS. */
import type { Camera } from "./camera.ts";
import type { Geometry, Span } from "./geometry.ts";
import { dropperEnds, droppersSeen } from "./linePainter.ts";
import type { LineIndex } from "./lineIndex.ts";
import type { Moved } from "./scene.ts";
import type { View } from "./wirePath.ts";

/** As far as this from a dropper or support, in px, it is meant: half of a finger's width. */
const NEAR = 8;
// Above and below its ends a dropper can still be taken, in px.
const BEYOND = 10;

export type Picked =
  | { kind: "dropper"; index: number }
  | { kind: "support"; index: number }
  | { kind: "span"; number: number };

export interface Looked {
  geometry: Geometry;
  line: LineIndex;
  camera: Camera;
  view: View;
  now: Moved | null;
}

export function pick({ geometry, line, camera, view, now }: Looked, x: number, y: number): Picked | null {
  let best: Picked | null = null;
  let least = NEAR;
  for (const index of droppersSeen({ line, camera })) {
    const [x0, y0, x1, y1] = dropperEnds(geometry.droppers[index]!, camera, view, now);
    const inside = y >= Math.min(y0, y1) - BEYOND && y <= Math.max(y0, y1) + BEYOND;
    const away = Math.abs(x - (x0 + x1) / 2);
    if (inside && away < least) [best, least] = [{ kind: "dropper", index }, away];
  }
  geometry.supports.forEach((support, index) => {
    const away = Math.abs(x - camera.x(support.x_m));
    if (away < least) [best, least] = [{ kind: "support", index }, away];
  });
  if (best) return best;
  const span = spanAt(geometry, camera.metres(x));
  return span ? { kind: "span", number: span.number } : null;
}

/** The span at a position in m. */
export function spanAt(geometry: Geometry, x: number): Span | null {
  return geometry.spans.find((span) => x >= span.start_m && x < span.end_m) ?? null;
}
