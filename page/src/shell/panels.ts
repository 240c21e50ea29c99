/** Panels and commands: each room of the page registers its own, and the shell shows them. */
import { signal, type ReadonlySignal } from "@preact/signals";
import type { ComponentType } from "preact";

export type Slot = "top" | "left" | "main" | "below" | "right" | "bottom";

export interface Panel {
  id: string;
  slot: Slot;
  /** On its tab, where its slot has tabs (main, right). */
  title: string;
  /** Place among the panels of its slot. */
  order: number;
  /** Loaded when it is first shown. */
  load: () => Promise<ComponentType>;
  /** Whether it is offered now; always without. */
  when?: ReadonlySignal<boolean>;
  /** It is read, and has no axis along the track: the strips are not below it. */
  alone?: boolean;
}

export interface Command {
  id: string;
  title: string;
  /** As in "Ctrl+Enter", "Space", "Shift+ArrowRight", "F"; a letter alone has no effect in a field. */
  keys?: string[];
  act: () => void;
  when?: ReadonlySignal<boolean>;
}

export const panels = signal<Panel[]>([]);
export const commands = signal<Command[]>([]);
/** The panel that is shown in each slot with tabs. */
export const shown = signal<Partial<Record<Slot, string>>>({});

export function addPanel(panel: Panel): void {
  panels.value = [...panels.peek(), panel].sort((a, b) => a.order - b.order);
}

export function addCommand(command: Command): void {
  commands.value = [...commands.peek(), command];
}

/** The panel that stands in a slot with tabs now. */
export function standing(slot: Slot): Panel | undefined {
  const all = panels.value.filter((panel) => panel.slot === slot && (panel.when?.value ?? true));
  return all.find((panel) => panel.id === shown.value[slot]) ?? all[0];
}

/** The part of the window that a phone shows: it has room for one. */
export type Part = "left" | "main" | "right";
export const part = signal<Part>("main");

export function show(id: string): void {
  const panel = raise(id);
  if (panel) part.value = panel.slot === "right" || panel.slot === "left" ? panel.slot : "main";
}

/** Put a panel in front in its slot; a phone goes on to show the part that it shows. */
export function raise(id: string): Panel | undefined {
  const panel = panels.peek().find((one) => one.id === id);
  if (panel) shown.value = { ...shown.peek(), [panel.slot]: id };
  return panel;
}
