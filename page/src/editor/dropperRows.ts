/**
 * Droppers of a span type as rows: position, and pre-sag or length, which are separate lists in the file.
 * A dropper that is added or taken away changes all lists by one patch. Lengths in m.
 */
import { parts, type FormField } from "./formData.ts";
import type { Value } from "./patch.ts";

const POSITIONS = "positions";
/** Positions are rounded to this, in m: droppers are placed by the centimetre. */
const PLACE = 0.01;
/** Pre-sag and lengths are rounded to this, in m: a tenth of a millimetre, less than is built. */
const FINE = 1e-4;

export type Rows = [FormField, ...FormField[]];

/** Fields in the order of the form; lists of the same droppers stand together. */
export function rowsOf(fields: readonly FormField[]): Rows[] {
  const found: Rows[] = [];
  for (const field of fields) {
    const last = found.at(-1);
    if (field.together && last?.[0].together === field.together) last.push(field);
    else found.push([field]);
  }
  return found;
}

/** Length of the span that droppers are in, in m; null where it is not known. */
export function spanOf(together: string, fields: readonly FormField[]): number | null {
  const length = fields.find(({ field }) => field === together.replace(/\.droppers$/, ".length"))?.value;
  return typeof length === "number" ? length : null;
}

const listOf = (value: Value): Value[] => (Array.isArray(value) ? value : []);
const numbersOf = (own: FormField): number[] => listOf(own.value).map((one) => (typeof one === "number" ? one : NaN));

/** Droppers that the longest list counts: a list that is too short has empty cells. */
export const countOf = (lists: readonly FormField[]): number => Math.max(0, ...lists.map(({ typed }) => listOf(typed).length));

/** Changes that take a dropper out of every list that has it. */
export const without = (lists: readonly FormField[], row: number): Record<string, null> =>
  Object.fromEntries(lists.filter(({ typed }) => row < listOf(typed).length).map(({ field }) => [`${field}.${row}`, null]));

const rounded = (value: number, step: number) => Number((Math.round(value / step) * step).toFixed(6));

/** A length in m in the unit in which a value of the list is typed. */
function like(typed: Value, metres: number): Value {
  const { unit } = parts(typed);
  const factor = unit === "" ? 1 : { m: 1, cm: 1e2, mm: 1e3 }[unit];
  if (unit === "") return metres;
  return factor === undefined ? `${metres} m` : `${Number((metres * factor).toFixed(3))} ${unit}`;
}

export interface Added {
  changes: Record<string, Value>;
  /** What was done, in a sentence. */
  told: string;
}

/**
 * A dropper behind row `after`, counted from 0; -1: before the first. It stands half way to its neighbours, or
 * to the support, and its other values lie between those of its neighbours. Null where there is no place.
 */
export function withOne(lists: readonly FormField[], after: number, span: number | null): Added | null {
  const positions = lists.find(({ field }) => field.endsWith(`.${POSITIONS}`));
  if (!positions) return null;
  const at = numbersOf(positions);
  const count = countOf(lists);
  const ends = [at[after] ?? 0, at[after + 1] ?? span ?? NaN] as const;
  const place = rounded((ends[0] + ends[1]) / 2, PLACE);
  if (!(place > ends[0] && place < ends[1]) || lists.some(({ typed }) => listOf(typed).length !== count)) return null;
  const changes: Record<string, Value> = {};
  const told: string[] = [];
  for (const own of lists) {
    const [typed, numbers] = [listOf(own.typed), numbersOf(own)];
    const beside = [numbers[after], numbers[after + 1]].filter((one) => one !== undefined);
    const value = own === positions ? place : rounded(beside.reduce((sum, one) => sum + one, 0) / (beside.length || 1), FINE);
    if (!Number.isFinite(value)) return null;
    const new_ = like(typed[after] ?? typed[0] ?? 0, value);
    changes[own.field] = [...typed.slice(0, after + 1), new_, ...typed.slice(after + 1)];
    if (own !== positions) told.push(`its ${own.label.toLowerCase().replace("presag", "pre-sag")} is ${new_}${typeof new_ === "number" ? " m" : ""}, ${beside.length > 1 ? "half way between its neighbours" : "as of its neighbour"}`);
  }
  return { changes, told: `Dropper ${after + 2} added at ${place} m${told.length ? `: ${told.join(", ")}` : ""}.` };
}

/** The row behind which the widest gap is, -1 that at the left support. */
export function widestGap(lists: readonly FormField[], span: number | null): number {
  const positions = lists.find(({ field }) => field.endsWith(`.${POSITIONS}`));
  const at = [0, ...(positions ? numbersOf(positions) : []), ...(span === null ? [] : [span])];
  const gaps = at.slice(1).map((one, k) => one - at[k]!);
  return gaps.indexOf(Math.max(...gaps)) - 1;
}
