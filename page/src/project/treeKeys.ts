/** Keys of the tree: up and down from row to row, left and right close and open a section, Space ticks a run. */
import { isPointed } from "../shell/keys.ts";

const ROWS = "summary, .entry .name, .entry .tick input";

/** Rows that can be seen, in their order. */
function rows(tree: HTMLElement): HTMLElement[] {
  return [...tree.querySelectorAll<HTMLElement>(ROWS)].filter(
    (row) => !row.closest(row.tagName === "SUMMARY" ? "details details:not([open])" : "details:not([open])") && !row.hasAttribute("disabled"),
  );
}

function stepped(tree: HTMLElement, from: Element, direction: 1 | -1): boolean {
  const all = rows(tree);
  const row = from.closest("summary, .entry");
  const at = all.findIndex((one) => one === row || row?.contains(one));
  all[at + direction]?.focus();
  return at >= 0;
}

function opened(from: Element, isOpen: boolean): boolean {
  if (!from.matches("summary")) return false;
  (from.parentElement as HTMLDetailsElement).open = isOpen;
  return true;
}

function ticked(from: Element): boolean {
  const box = from.closest(".run-entry")?.querySelector<HTMLInputElement>("input[type=checkbox]");
  // A run that was clicked is played: Space then means the player.
  if (!box || box === from || isPointed(from)) return false;
  box.click();
  return true;
}

const ACTS: Record<string, (tree: HTMLElement, from: Element) => boolean> = {
  ArrowDown: (tree, from) => stepped(tree, from, 1),
  ArrowUp: (tree, from) => stepped(tree, from, -1),
  ArrowRight: (_, from) => opened(from, true),
  ArrowLeft: (_, from) => opened(from, false),
  " ": (_, from) => ticked(from),
};

export function treeKey(event: KeyboardEvent): void {
  if (event.ctrlKey || event.altKey || event.metaKey || event.shiftKey || !(event.target instanceof Element)) return;
  if (event.target.matches(".search")) return;
  if (ACTS[event.key]?.(event.currentTarget as HTMLElement, event.target)) event.preventDefault();
}
