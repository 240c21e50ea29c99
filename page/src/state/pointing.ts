/** Whether somebody points at the cursor now: drawing and strips show it then, and not where it was left. m. */
import { computed, effect, signal } from "@preact/signals";
import { clock, cursor, file, source } from "./selection.ts";

/** What points at the cursor: the pointer over a view, or keys in one. */
const by = signal<"pointer" | "keys" | null>(null);

/** The cursor as long as somebody points at it; other rooms keep where it was, as the row of a table. */
export const pointed = computed(() => (by.value === null ? null : cursor.value));

export function point(x: number, how: "pointer" | "keys" = "pointer"): void {
  by.value = how;
  cursor.value = x;
}

/** The pointer has left, or the focus a view in which keys moved the cursor. */
export function leave(): void {
  by.value = null;
}

/** A cursor was on a line that is not shown any more; one that keys have put does not stand over what is played. */
export function followPointing(): void {
  effect(() => {
    void [source.value, file.value];
    cursor.value = null;
  });
  effect(() => {
    if (clock.playing.value && by.peek() === "keys") by.value = null;
  });
}
