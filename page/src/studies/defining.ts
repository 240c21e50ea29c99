/** A study that is being defined: what is varied and how, which combinations, what comes out. Values as typed. */
import { computed, signal } from "@preact/signals";

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

export type Design = "grid" | "list" | "latin-hypercube" | "sobol" | "monte-carlo";
export const DESIGNS: Record<Design, string> = {
  grid: "grid: all combinations",
  list: "list: first with first, second with second",
  "latin-hypercube": "sample: Latin hypercube",
  sobol: "sample: Sobol sequence",
  "monte-carlo": "sample: Monte Carlo",
};
export const isSample = (design: Design): boolean => design !== "grid" && design !== "list";

/** Outputs that are offered: keys of the assessment, and what they are. */
export const OUTPUTS: [key: string, label: string][] = [
  ["mean_force_N", "Mean force, N"],
  ["std_force_N", "Standard deviation σ, N"],
  ["max_force_N", "Maximum force, N"],
  ["min_force_N", "Minimum force, N"],
  ["statistical_max_N", "Statistical maximum F_m + 3σ, N"],
  ["contact_loss_percent", "Contact loss, %"],
  ["NQ_percent", "Percentage of arcing NQ, %"],
  ["max_uplift_at_support_mm", "Maximum uplift at a support, mm"],
  ["slack_droppers_max", "Slack droppers at once"],
  ["passed", "All limits met (1) or not (0)"],
];

export const scenario = signal<string | null>(null);
export const fields = signal<Fields | null>(null);
export const name = signal("");
export const varied = signal<Varied[]>([]);
export const design = signal<Design>("grid");
/** Of a sample. */
export const size = signal(32);
export const outputs = signal<string[]>(["mean_force_N", "std_force_N", "max_uplift_at_support_mm"]);
/** Expressions beside the keys above, by name. */
export const expressions = signal<{ name: string; expression: string }[]>([]);

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

function variable(one: Varied, sample: boolean): Record<string, unknown> {
  const { field, unit, how } = one;
  if (how === "values") return { field, values: one.values.split(/[;,]/).filter((text) => text.trim()).map((text) => amount(text, unit)) };
  if (how === "normal" && sample) {
    return { field, distribution: { kind: "normal", mean: amount(one.mean, unit), standard_deviation: amount(one.deviation, unit) } };
  }
  const range = [amount(one.low, unit), amount(one.high, unit)];
  return sample ? { field, range } : { field, range, count: one.count };
}

/** The study as its file has it; null while it says nothing yet. */
export const definition = computed(() => {
  const chosen = scenario.value;
  const all = [...outputs.value.map((key) => [key, key] as const), ...expressions.value.map((one) => [one.name, one.expression] as const)];
  if (chosen === null || !name.value.trim() || !varied.value.length || !all.length) return null;
  const sample = isSample(design.value);
  return {
    name: name.value.trim(),
    scenario: chosen,
    variables: Object.fromEntries(varied.value.map((one) => [one.name, variable(one, sample)])),
    design: sample ? { kind: design.value, count: size.value } : { kind: design.value },
    // A key of its own name needs a name without dots; others are told by their expression.
    outputs: Object.fromEntries(all.map(([key, expression]) => [key.replace(/_(N|percent|mm)$/, ""), expression])),
  };
});

/** Name of the study's file. */
export const fileOf = (study: string): string => `${study.trim().replace(/[^\p{L}\p{N}._-]+/gu, "-")}.yaml`;

/** About how long it takes, in words; an estimate. */
export function estimate(count: number, found: Fields): string {
  if (found.estimate_s === null) return "no run of this scenario is stored: run it once for an estimate of the time";
  const time = (found.estimate_s * count) / found.workers;
  const words = time < 90 ? `${Math.max(1, Math.round(time))} s` : time < 5400 ? `${Math.round(time / 60)} min` : `${(time / 3600).toFixed(1)} h`;
  return `about ${words} on ${found.workers} cores, an estimate from the newest stored run`;
}
