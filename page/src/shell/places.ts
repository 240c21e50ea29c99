/** Parts of the window that the focus goes to at once. */
import { fold, folded } from "./layout.ts";
import { part, type Part } from "./panels.ts";

export interface Place {
  title: string;
  /** What has the focus there: the first of these that is there. */
  at: string[];
  part?: Part;
}

export const PROJECT: Place = { title: "To the project", at: ["nav.left [aria-current=true]", "nav.left summary, nav.left button"], part: "left" };

export const PLACES: readonly Place[] = [
  PROJECT,
  { title: "To the views", at: ["main [role=tab][aria-selected=true]"], part: "main" },
  { title: "To the fields", at: [".slot.right [role=tab][aria-selected=true]"], part: "right" },
  { title: "To the player", at: [".slot.bottom .play"] },
];

export function goTo({ at, part: of }: Place): void {
  if (of) part.value = of;
  if (of && of !== "main" && folded.peek()[of]) folded.value = { ...folded.peek(), [of]: false };
  // What was hidden takes no focus before it is drawn.
  requestAnimationFrame(() => {
    const found = at.map((selector) => document.querySelector<HTMLElement>(selector)).find((one) => one !== null);
    found?.focus();
  });
}

/** Go to the tree, or hide it where the focus is in it. */
export function toOrFromProject(): void {
  if (document.activeElement?.closest("nav.left")) fold("left");
  else goTo(PROJECT);
}
