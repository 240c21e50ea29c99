/** Show all of the line, and the next exaggeration of heights. */
import { effect } from "@preact/signals";
import { exaggeration, range } from "../state/selection.ts";
import { fitted, nextExaggeration } from "./camera.ts";
import { indexOf } from "./lineIndex.ts";
import { edited, shown, sight, whole } from "./scene.ts";

/** Width and height of the side view in px; it says them when it is drawn. */
export const size: { current: [number, number] | null } = { current: null };

/** Show all of the line, heights filling the picture. */
export function fit(): void {
  const geometry = shown.peek();
  if (!geometry) return;
  range.value = null;
  const [low, high] = indexOf(geometry).z;
  exaggeration.value = fitted(whole(geometry), high - low, ...(size.current ?? [900, 300]));
}

/** Look at a range; an exaggeration that fitted the one before fits this one. */
export function look(to: [number, number]): void {
  const geometry = shown.peek();
  if (geometry) {
    const [low, high] = indexOf(geometry).z;
    const best = (seen: [number, number]) => fitted(seen, high - low, ...(size.current ?? [900, 300]));
    if (exaggeration.peek() === best(sight.peek())) exaggeration.value = best(to);
  }
  range.value = to;
}

export function exaggerate(larger: boolean): void {
  exaggeration.value = nextExaggeration(exaggeration.peek(), larger);
}

/** Ends of a line that differ by less than this, in m, are the same: those of coarse elements are rounded. */
const SAME_END = 1e-3;

const isSame = (one: [number, number], other: [number, number]): boolean =>
  one.every((end, at) => Math.abs(end - other[at]!) < SAME_END);

let name: string | null = null;
/** Ends in m of the line that was seen last. */
let seen: [number, number] | null = null;
effect(() => {
  const line = shown.value;
  if (line && line !== edited.peek()) seen = indexOf(line).x;
});
// Another line is seen as a whole first. One that was changed, and one as long as the line of the
// run that was seen until now, stay where they were looked at.
effect(() => {
  const line = edited.value;
  if (!line || shown.peek() !== line) return;
  const { x } = indexOf(line);
  if (line.name !== name && !(seen && isSame(seen, x))) requestAnimationFrame(fit);
  [name, seen] = [line.name, x];
});
