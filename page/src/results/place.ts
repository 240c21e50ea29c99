/** A place of a run that was explained: the player goes there, a second before. */
import { showing } from "../drawing/scene.ts";
import { show } from "../shell/panels.ts";
import { clock, source } from "../state/selection.ts";
import { wentTo } from "../state/worst.ts";
import type { Place } from "./told.ts";

/** The player stands so many seconds before a place. */
const BEFORE_S = 1;

/** Go to a place of a run: it is marked in the line, which is seen. */
export function goTo(run: string, place: Place): void {
  const played = source.peek();
  if (!(played && "run" in played && played.run === run)) source.value = { run };
  clock.playing.value = false;
  clock.time_s.value = Math.max(clock.start_s.peek(), place.time_s - BEFORE_S);
  wentTo.value = place;
  showing.value = "played";
  show("drawing");
}
