/** Words for runs and models: verdicts, numbers, what differs. */
import { changesInWords } from "../state/fieldWords.ts";
import type { Criterion } from "../results/told.ts";
import type { ModelEntry, ModelKind, RunEntry } from "../state/project.ts";

/** Verdict by word, shape, and class of its colour. */
export interface Shown {
  sign: string;
  word: string;
  state: "met" | "not-met" | "open";
}

const VERDICTS: Record<RunEntry["verdict"], Shown> = {
  met: { sign: "✔", word: "met", state: "met" },
  "not met": { sign: "✖", word: "not met", state: "not-met" },
  "not judged": { sign: "○", word: "not judged", state: "open" },
  "stopped early": { sign: "■", word: "stopped early", state: "not-met" },
  unreadable: { sign: "?", word: "unreadable", state: "open" },
};

export const verdictOf = (verdict: RunEntry["verdict"]): Shown => VERDICTS[verdict];

/** A criterion in the few words of the run bar. */
export interface Lead {
  verdict: string;
  title: string;
  /** The title is a sign: it has room always. */
  isSign: boolean;
  value: string;
  limit: string;
  /** How many others have the same verdict. */
  more: number;
}

/** σ is known by its sign; the other criteria have the titles of reports. */
const SIGNS: Record<string, string> = { standard_deviation: "σ", statistical_max: "F_m + 3σ", statistical_min: "F_m − 3σ" };

export function leadingWords(lead: Criterion, all: readonly Criterion[], several: boolean): Lead {
  const unit = lead.unit && ` ${lead.unit}`;
  const same = all.filter((one) => one.verdict === lead.verdict).length;
  return {
    verdict: lead.verdict,
    title: (SIGNS[lead.name] ?? lead.title) + (several && lead.pantograph ? ` of ${lead.pantograph}` : ""),
    isSign: lead.name in SIGNS,
    value: `${lead.value}${unit}`,
    limit: lead.limit === "–" ? "" : `${lead.limit}${unit}`,
    more: lead.verdict === "met" || lead.verdict === "not judged" ? 0 : same - 1,
  };
}

export const KINDS: [ModelKind, string][] = [
  ["scenario", "Scenarios"],
  ["line", "Lines"],
  ["pantograph", "Pantographs"],
  ["study", "Studies"],
];

/** What is typed over "275 km/h": a bare number has the unit that stood there, not m/s. */
export function withUnit(typed: string, before: string): string {
  const text = typed.trim();
  const unit = /[^\d.,eE+\-\s].*$/.exec(before)?.[0];
  return unit && /^[\d.eE+-]+$/.test(text) ? `${text} ${unit}` : text;
}

export const kmh = (speed_m_s: number): string => `${(3.6 * speed_m_s).toFixed(0)} km/h`;

/** Main numbers of a run in one line: the largest σ of its pantographs, and the uplift. */
export function numbers(run: RunEntry): [string, string, string][] {
  const worst = run.pantographs.reduce<number | null>(
    (most, one) => (one.std_force_N === null ? most : Math.max(most ?? 0, one.std_force_N)),
    null,
  );
  return [
    ...(run.speed_m_s === null ? [] : [["", (3.6 * run.speed_m_s).toFixed(0), "km/h"] as [string, string, string]]),
    ...(worst === null ? [] : [["σ", worst.toFixed(1), "N"] as [string, string, string]]),
    ...(run.max_uplift_at_support_mm === null
      ? []
      : [["uplift", run.max_uplift_at_support_mm.toFixed(0), "mm"] as [string, string, string]]),
  ];
}

/** The line of a run; of lines of one name that differ, which version it is, the oldest first. */
function lineOf(run: RunEntry, others: readonly RunEntry[]): string {
  const oldest = [...others].sort((a, b) => (a.created ?? "").localeCompare(b.created ?? ""));
  const versions = [...new Set(oldest.filter((one) => one.line === run.line).map((one) => one.line_digest))];
  const which = versions.length > 1 ? `, version ${versions.indexOf(run.line_digest) + 1} of ${versions.length}` : "";
  return `line ${run.line}${which}`;
}

/**
 * Name of each run and what tells it from the others. Fields that all runs set to the same value are left
 * out, and what is recorded: it changes no number. Of runs that no field tells apart the line is told,
 * where it differs, and else which one of them it is, the oldest first.
 */
export function differences(runs: readonly RunEntry[]): [string, string][] {
  const fields = [...new Set(runs.flatMap((run) => Object.keys(run.changes)))].filter((field) => !field.startsWith("output."));
  const differs = runs.length < 2 ? fields : fields.filter((field) => new Set(runs.map((run) => run.changes[field])).size > 1);
  return runs.map((run) => {
    const own = differs.filter((field) => field in run.changes).map((field) => [field, run.changes[field]!] as const);
    const told = own.length ? [changesInWords(own)] : [];
    const alike = runs.filter((one) => one.name === run.name && differs.every((field) => one.changes[field] === run.changes[field]));
    if (run.line !== null && alike.some((one) => one.line_digest !== run.line_digest)) told.push(lineOf(run, alike));
    const same = alike.filter((one) => one.line_digest === run.line_digest).sort((a, b) => (a.created ?? "").localeCompare(b.created ?? ""));
    if (same.length > 1) told.push(`run ${same.indexOf(run) + 1} of ${same.length}`);
    const asInFile = runs.some((one) => one !== run && one.name === run.name && !alike.includes(one));
    return [run.name ?? run.path, told.join(", ") || (asInFile ? "as in the file" : "")];
  });
}

/** Whether name and description of a model have all words in them. */
export function matches(entry: ModelEntry, typed: string): boolean {
  const text = `${entry.name} ${entry.description}`.toLowerCase();
  return typed.toLowerCase().split(/\s+/).every((word) => text.includes(word));
}
