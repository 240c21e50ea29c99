/** Worst places of the run that is played, and the one that somebody went to. m, N. */
import { signal } from "@preact/signals";

export interface WorstPlace {
  position_m: number;
  /** Contact force there; `null` where it is not told. */
  force_N: number | null;
}

/** In the order of the line; empty before they are known. */
export const worst = signal<WorstPlace[]>([]);
/** The place that is marked in the drawing. */
export const wentTo = signal<WorstPlace | null>(null);

/** Its number among all worst places, and the force: "2 of 10: 210 N". */
export function inWords({ position_m, force_N }: WorstPlace): string {
  const all = worst.value;
  const at = all.findIndex((one) => one.position_m === position_m);
  const parts = [at < 0 ? "" : `${at + 1} of ${all.length}`, force_N === null ? "" : `${Math.round(force_N)} N`];
  return parts.filter(Boolean).join(": ");
}
