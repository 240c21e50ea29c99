/** Keys of commands: "Ctrl+Enter", "Shift+ArrowRight", "F"; on a Mac ⌘ is Ctrl. */
import { commands, type Command } from "./panels.ts";

const NAMES: Record<string, string> = { " ": "Space" };

/** The name of a key that was pressed. A letter is written large; Shift is named only where it changes no sign. */
export function nameOf(event: Pick<KeyboardEvent, "key" | "ctrlKey" | "metaKey" | "altKey" | "shiftKey">): string {
  const plain = NAMES[event.key] ?? (event.key.length === 1 ? event.key.toUpperCase() : event.key);
  const isSign = event.key.length === 1 && event.key.toUpperCase() === event.key.toLowerCase() && event.key !== " ";
  return [
    ...(event.ctrlKey || event.metaKey ? ["Ctrl"] : []),
    ...(event.altKey ? ["Alt"] : []),
    ...(event.shiftKey && !isSign ? ["Shift"] : []),
    plain,
  ].join("+");
}

/** The button that has the focus because it was pressed with the pointer: nobody means it by Space. */
let pointed: Element | null = null;

/** Whether a button has the focus because it was pressed with the pointer. */
export const isPointed = (at: Element): boolean => at === pointed;

const BUTTONS = "button, a, summary, [role=tab]";

/** What a key does where the focus is: in a field it types, on a button Space and Enter press it. */
function isTaken(event: KeyboardEvent, name: string): boolean {
  const at = event.target instanceof Element ? event.target : null;
  if (at?.closest("dialog")) return true;
  if (name.startsWith("Ctrl+") || name.startsWith("Alt+")) return name !== "Ctrl+Enter" && name !== "Ctrl+K" && isText(at);
  if (isText(at) || at?.closest("select")) return true;
  if (at?.closest("input[type=range], [role=slider], [role=separator]")) return /Arrow|Home|End|Page/.test(name);
  if (at?.closest("[role=tab], [role=treeitem], [role=tablist]") && /Arrow|Home|End/.test(name)) return true;
  const button = at?.closest(`${BUTTONS}, input`);
  return (name === "Enter" || (name === "Space" && button !== pointed)) && !!button;
}

const isText = (at: Element | null): boolean =>
  !!at?.closest("textarea, [contenteditable]:not([contenteditable=false]), input:not([type=range], [type=checkbox], [type=radio], [type=button])");

/** The command of a key; of several that are offered the one registered last. */
export function commandOf(name: string): Command | undefined {
  return commands.peek().findLast((one) => one.keys?.includes(name) && (one.when?.peek() ?? true));
}

/** Letters that were typed after the key of a dialog, before its field was there. */
let early = "";

/** What was typed for a field that had not come yet; it is the field's from now on. */
export function typedEarly(): string {
  const found = early;
  early = "";
  return found;
}

/** A key for a dialog that is on its way: the page does nothing with it. */
function keepForDialog(event: KeyboardEvent): void {
  event.preventDefault();
  if (event.key.length === 1 && !event.ctrlKey && !event.metaKey && !event.altKey) early += event.key;
}

/** Have commands done by their keys, until the returned function is called; none while `isOver` says that a dialog is over the window. */
export function followKeys(isOver: () => boolean = () => false): () => void {
  const end = new AbortController();
  const { signal } = end;
  addEventListener("pointerdown", (event) => {
    pointed = event.target instanceof Element ? event.target.closest(BUTTONS) : null;
  }, { signal });
  addEventListener("focusin", (event) => {
    if (event.target !== pointed) pointed = null;
  }, { signal });
  addEventListener("keydown", (event) => {
    if (event.defaultPrevented || event.isComposing) return;
    const isInside = event.target instanceof Element && event.target.closest("dialog");
    if (isOver() && !isInside) return keepForDialog(event);
    early = "";
    const name = nameOf(event);
    const command = isTaken(event, name) ? undefined : commandOf(name);
    if (!command) return;
    event.preventDefault();
    command.act();
  }, { signal });
  return () => end.abort();
}

const SHOWN: Record<string, string> = { ArrowLeft: "←", ArrowRight: "→", ArrowUp: "↑", ArrowDown: "↓" };

/** A key as it is written on the screen. */
export const written = (key: string): string[] => key.split("+").filter(Boolean).map((part) => SHOWN[part] ?? part);
