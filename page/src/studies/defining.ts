/** A study that is being defined: what is varied and how, which combinations, what comes out. Values as typed. */
import { computed, signal } from "@preact/signals";
import { changes, type Changed, type Changes } from "../state/changes.ts";

export interface VariedField {
  field: string;
  label: string;
  group: string;
  description: string;
  typed: string;
  unit: string;
  value: number;
  offered: [number, number] | null;
  /** In words. */
  limits: string;
}

export interface Fields {
  name: string;
  fields: VariedField[];
  /** Time of the newest stored run in s; null without one. */
  estimate_s: number | null;
  workers: number;
  outputs: OfferedOutput[];
}

/** A key of the assessment, and what it is. */
export interface OfferedOutput {
  key: string;
  label: string;
  unit: string;
}

export type How = "range" | "values" | "normal";

/** A field that is varied; texts as somebody types them. */
export interface Varied {
  field: string;
  name: string;
  unit: string;
  how: How;
  low: string;
  high: string;
  count: number;
  values: string;
  mean: string;
  deviation: string;
}

export type Way = "grid" | "list" | "sample" | "optimise";
/** Which combinations are computed: what it is called, and what it does. */
export const WAYS: Record<Way, [label: string, about: string]> = {
  grid: ["All combinations", "Every value of each field with every value of all others."],
  list: ["One by one", "The first values of all fields together, then the second ones, and so on."],
  sample: ["A sample", "So many variants, spread over the ranges or drawn from the distributions."],
  optimise: ["Search for the best", "Each next variant is chosen by what came out of those before, for the least or greatest output."],
};
export type Sample = "latin-hypercube" | "sobol" | "monte-carlo";
export const SAMPLES: Record<Sample, [label: string, about: string]> = {
  "latin-hypercube": ["Latin hypercube", "Each field takes one value from each of so many equal parts of its range."],
  sobol: ["Sobol sequence", "Fills the space most evenly, best with a power of two."],
  "monte-carlo": ["Monte Carlo", "Independent draws, for statistics."],
};
/** Whether a range is taken as a whole, and a number of variants is asked for. */
export const isCounted = (way: Way): boolean => way === "sample" || way === "optimise";

export const scenario = signal<string | null>(null);
export const fields = signal<Fields | null>(null);
export const name = signal("");
export const varied = signal<Varied[]>([]);
export const way = signal<Way>("grid");
export const sample = signal<Sample>("latin-hypercube");
/** Variants of a sample, or of a search. */
export const size = signal(32);
export const outputs = signal<string[]>(["mean_force_N", "std_force_N", "max_uplift_at_support_mm", "passed"]);
/** What a search does with an output, texts as typed. */
export interface Aim {
  aim: "" | "minimise" | "maximise";
  least: string;
  most: string;
}
export const NO_AIM: Aim = { aim: "", least: "", most: "" };
/** Aims of a search by output. */
export const aims = signal<Record<string, Aim>>({ std_force_N: { ...NO_AIM, aim: "minimise" }, passed: { ...NO_AIM, least: "1" } });
/** Expressions beside the keys above, by name. */
export const expressions = signal<{ name: string; expression: string }[]>([]);

/** Whether all variants have what the run bar changes, too. */
export const withChanges = signal(true);

/** What the run bar changes and no variable takes over. */
export const fixed = computed((): Changes => {
  const taken = new Set(varied.value.map(({ field }) => field));
  return Object.fromEntries(Object.entries(changes.value).filter(([field]) => !taken.has(field)));
});

/** A field with the value that the run bar gives it, where that is in the field's unit: ranges begin around it. */
export function asChanged(own: VariedField, value: Changed | undefined): VariedField {
  if (value === undefined) return own;
  const typed = String(value).trim();
  const number = Number(own.unit && typed.endsWith(own.unit) ? typed.slice(0, -own.unit.length) : typed);
  if (!Number.isFinite(number) || own.value === 0 || (own.unit && !typed.endsWith(own.unit))) return { ...own, typed };
  const scale = (end: number) => Number(((end * number) / own.value).toPrecision(4));
  return { ...own, typed, value: number, offered: own.offered && [scale(own.offered[0]), scale(own.offered[1])] };
}

/** A name for a column: letters, digits and _, and none that is taken. */
export function columnName(label: string, taken: readonly string[]): string {
  const plain = label.toLowerCase().replace(/[^a-z0-9]+/g, "_").replace(/^[_0-9]+|_+$/g, "") || "variable";
  let [found, number] = [plain, 2];
  while (taken.includes(found)) found = `${plain}_${number++}`;
  return found;
}

export function vary(own: VariedField): void {
  if (varied.peek().some(({ field }) => field === own.field)) return;
  const [low, high] = own.offered ?? [own.value, own.value];
  const word = own.label.length > 2 ? own.label : own.field;
  varied.value = [
    ...varied.peek(),
    {
      field: own.field, name: columnName(word, varied.peek().map((one) => one.name)), unit: own.unit, how: "range",
      low: String(low), high: String(high), count: 5, values: String(own.value),
      mean: String(own.value), deviation: String(Number((Math.abs(own.value) * 0.05).toPrecision(3))),
    },
  ];
}

export function aimAt(output: string, parts: Partial<Aim>): void {
  aims.value = { ...aims.peek(), [output]: { ...(aims.peek()[output] ?? NO_AIM), ...parts } };
}

export function leave(field: string): void {
  varied.value = varied.peek().filter((one) => one.field !== field);
}

export function change(field: string, parts: Partial<Varied>): void {
  varied.value = varied.peek().map((one) => (one.field === field ? { ...one, ...parts } : one));
}

type Value = string | number;

/** An amount as it stands in a file: with the unit of the field unless one was typed, a bare number where it has none. */
export function amount(text: string, unit: string): Value {
  const plain = text.trim();
  if (plain === "" || Number.isNaN(Number(plain))) return plain;
  return unit ? `${plain} ${unit}` : Number(plain);
}

function variable(one: Varied, isWhole: boolean): Record<string, unknown> {
  const { field, unit, how } = one;
  if (how === "values") return { field, values: one.values.split(/[;,]/).filter((text) => text.trim()).map((text) => amount(text, unit)) };
  if (how === "normal" && isWhole) {
    return { field, distribution: { kind: "normal", mean: amount(one.mean, unit), standard_deviation: amount(one.deviation, unit) } };
  }
  const range = [amount(one.low, unit), amount(one.high, unit)];
  return isWhole ? { field, range } : { field, range, count: one.count };
}

type Part = Record<string, unknown>;

function bound(output: string, { least, most }: Aim): Part[] {
  const ends = { ...(least.trim() && { at_least: amount(least, "") }), ...(most.trim() && { at_most: amount(most, "") }) };
  return Object.keys(ends).length ? [{ output, ...ends }] : [];
}

function design(all: readonly string[]): Part {
  if (way.value === "sample") return { kind: sample.value, count: size.value };
  if (way.value !== "optimise") return { kind: way.value };
  const own = all.flatMap((output) => (aims.value[output] ? [[output, aims.value[output]] as const] : []));
  const constraints = own.flatMap(([output, aim]) => bound(output, aim));
  return {
    kind: "optimise",
    trials: size.value,
    objectives: Object.fromEntries(own.flatMap(([output, { aim }]) => (aim ? [[output, aim]] : []))),
    ...(constraints.length && { constraints }),
  };
}

/** The study as its file has it; null while it says nothing yet. */
export const definition = computed(() => {
  const chosen = scenario.value;
  const own = expressions.value;
  const all = [...outputs.value, ...own.map((one) => one.name)];
  if (chosen === null || !name.value.trim() || !varied.value.length || !all.length) return null;
  return {
    name: name.value.trim(),
    scenario: chosen,
    // null takes away what a file of that name has.
    set: withChanges.value && Object.keys(fixed.value).length ? fixed.value : null,
    variables: Object.fromEntries(varied.value.map((one) => [one.name, variable(one, isCounted(way.value))])),
    design: design(all),
    // A key is its own name: it is headed by what the quantity is called.
    outputs: own.length
      ? Object.fromEntries([...outputs.value.map((key) => [key, key]), ...own.map((one) => [one.name, one.expression])])
      : outputs.value,
  };
});

/** A name that no study has: the one that is wanted, or the next one with a number. */
export function freeName(wanted: string, taken: readonly string[]): string {
  const stem = wanted.trim().replace(/-\d+$/, "");
  let [found, number] = [wanted.trim(), 2];
  while (taken.includes(found)) found = `${stem}-${number++}`;
  return found;
}

/** Name of the study's file. */
export const fileOf = (study: string): string => `${study.trim().replace(/[^\p{L}\p{N}._-]+/gu, "-")}.yaml`;

/** About how long it takes, in words; an estimate. */
export function estimate(count: number, found: Fields): string {
  if (found.estimate_s === null) return "no run of this scenario is stored: run it once for an estimate of the time";
  const time = (found.estimate_s * count) / found.workers;
  const words = time < 90 ? `${Math.max(1, Math.round(time))} s` : time < 5400 ? `${Math.round(time / 60)} min` : `${(time / 3600).toFixed(1)} h`;
  return `about ${words} on ${found.workers} cores, an estimate from the newest stored run`;
}
