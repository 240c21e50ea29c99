/** What a measured file does not say: amounts with their units, as typed. The server judges them. */
import { signal } from "@preact/signals";
import { withUnit } from "../project/words.ts";

export interface MeasuredAs {
  speed: string;
  supply: string;
  head_mass: string;
  head_lift: string;
}

export const NOTHING: MeasuredAs = { speed: "", supply: "", head_mass: "", head_lift: "" };
/** The unit of a bare number, by part. */
const UNITS: Partial<Record<keyof MeasuredAs, string>> = { speed: "0 km/h", head_mass: "0 kg", head_lift: "0 N" };

/** What was given of each measured file by its path; kept as long as the window. */
export const measuredAs = signal<Record<string, MeasuredAs>>({});
/** The measured file that was clicked in the tree: its form is open. */
export const chosenMeasured = signal<string | null>(null);

export const givenOf = (path: string): MeasuredAs => measuredAs.value[path] ?? NOTHING;

/** Give what was typed of a file; a bare number has the unit that stands beside its field. */
export function give(path: string, typed: MeasuredAs): void {
  const parts = Object.entries(typed).map(([part, text]) => [part, withUnit(text, UNITS[part as keyof MeasuredAs] ?? "")]);
  measuredAs.value = { ...measuredAs.peek(), [path]: Object.fromEntries(parts) as unknown as MeasuredAs };
}

/** Of the files that are compared, what was given of them. */
export function givenAmong(paths: readonly string[]): Record<string, MeasuredAs> {
  const all = measuredAs.value;
  return Object.fromEntries(paths.flatMap((path) => (all[path] ? [[path, all[path]]] : [])));
}
