/** The worst places of a run: the player goes there, a second before. */
import { signal } from "@preact/signals";
import { clock, cursor, source } from "../state/selection.ts";
import type { Place } from "./told.ts";

/** The player stands so many seconds before a place. */
const BEFORE_S = 1;

/** Places that keys go through, the worst first, of the run that was explained last. */
export const worstPlaces = signal<{ run: string; places: Place[] } | null>(null);
let current = -1;

/** Go to a place of a run: player and cursor stand there. */
export function goTo(run: string, place: Place): void {
  const played = source.peek();
  if (!(played && "run" in played && played.run === run)) source.value = { run };
  clock.playing.value = false;
  clock.time_s.value = Math.max(clock.start_s.peek(), place.time_s - BEFORE_S);
  cursor.value = place.position_m;
}

/** Go to the next or the previous of the worst places, around at the ends. */
export function step(by: 1 | -1): void {
  const found = worstPlaces.peek();
  if (!found?.places.length) return;
  const count = found.places.length;
  current = current < 0 ? (by > 0 ? 0 : count - 1) : (current + by + count) % count;
  goTo(found.run, found.places[current]!);
}

/** Take the places of an explanation; the next step begins with the worst one. */
export function remember(run: string, places: Place[]): void {
  worstPlaces.value = { run, places };
  current = -1;
}
