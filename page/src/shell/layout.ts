/** Sizes of the window's sides in px, and which are folded. */
import { effect, signal } from "@preact/signals";
import { keep, kept } from "./kept.ts";
import { part, shown, type Slot } from "./panels.ts";

export type Side = "left" | "right" | "below";

/** Size at first, and the least and most that a side may have. */
export const LIMITS: Record<Side, { first: number; least: number; most: number }> = {
  left: { first: 270, least: 170, most: 560 },
  right: { first: 330, least: 220, most: 720 },
  below: { first: 250, least: 70, most: 700 },
};

const isSizes = (found: unknown) =>
  typeof found === "object" && found !== null && Object.values(found).every((one) => Number.isFinite(one));
const isFolded = (found: unknown) =>
  typeof found === "object" && found !== null && Object.values(found).every((one) => typeof one === "boolean");

export const sizes = signal<Partial<Record<Side, number>>>(kept("sizes", {}, isSizes));
export const folded = signal<Partial<Record<Side, boolean>>>(kept("folded", {}, isFolded));

export const sizeOf = (side: Side): number => within(side, sizes.value[side] ?? LIMITS[side].first);

export function within(side: Side, size: number): number {
  return Math.round(Math.min(LIMITS[side].most, Math.max(LIMITS[side].least, size)));
}

export function resize(side: Side, size: number): void {
  sizes.value = { ...sizes.peek(), [side]: within(side, size) };
}

/** The window is that of a phone, which shows one part; base.css has the same width. */
export const isSmall = (): boolean => matchMedia("(max-width: 700px)").matches;

export function fold(side: Side): void {
  if (side !== "below" && isSmall()) return void (part.value = part.peek() === side ? "main" : side);
  folded.value = { ...folded.peek(), [side]: !folded.peek()[side] };
}

/** Remember the layout from now on, and show the tabs that were shown. */
export function remember(): void {
  const tabs = kept<Partial<Record<Slot, string>>>("tabs", {}, (found) => typeof found === "object" && found !== null);
  shown.value = { ...tabs, ...shown.peek() };
  effect(() => keep("sizes", sizes.value));
  effect(() => keep("folded", folded.value));
  effect(() => keep("tabs", shown.value));
}
