/** The range that all views show follows the first pantograph, until somebody moves it. Lengths in m. */
import { signal } from "@preact/signals";
import { kept } from "../../drawing/camera.ts";
import { look } from "../../drawing/fit.ts";
import { isPlayed, shown, whole } from "../../drawing/scene.ts";
import { range } from "../../state/selection.ts";
import { state } from "../player.ts";

export const following = signal(true);

/** The pantograph stands so far along the picture: waves run ahead of it, and behind it the line swings. */
const PLACE = 0.5;
/** What is seen first when a long line begins to be followed, in m: three spans. */
const SEEN = 170;
/** A range is another one where it differs by more than this, in m. */
const SAME = 1e-6;

let mine: [number, number] | null = null;

/** Follow again, from wherever the range is. */
export function startFollowing(): void {
  mine = null;
  following.value = true;
}

/** Move the range after the pantograph. */
export function followCamera(): void {
  const x = state.current.pantographs[0]?.position ?? NaN;
  const line = shown.peek();
  if (!following.peek() || !isPlayed.peek() || !line || !Number.isFinite(x)) return;
  const seen = range.peek();
  const length = seen ? seen[1] - seen[0] : Math.min(SEEN, whole(line)[1] - whole(line)[0]);
  if (mine && seen) {
    const zoomed = Math.abs(length - (mine[1] - mine[0])) > SAME;
    // Moved without a zoom: somebody looks at another place.
    if (!zoomed && Math.abs(seen[0] - mine[0]) > SAME) {
      following.value = false;
      return;
    }
  } else if (mine && !seen) {
    following.value = false; // all of the line is wanted
    mine = null;
    return;
  }
  const isFirst = mine === null;
  mine = kept([x - PLACE * length, x + (1 - PLACE) * length], whole(line));
  if (isFirst) look(mine); // heights that fill the picture of the whole line are cut in that of a part
  else if (!seen || mine.some((end, at) => Math.abs(end - seen[at]!) > SAME)) range.value = mine;
}
