/** How what is shown stands to the scenario of the run bar: a verdict of another run, a file that is no part of it. */
import { changesAfter } from "../state/fieldWords.ts";
import { lineOf } from "../state/lineOf.ts";
import { written, type Changes } from "../state/changes.ts";
import type { ModelEntry, RunEntry } from "../state/project.ts";
import type { ScenarioFields } from "./scenarioFields.ts";

/** Fields that change no number. */
const isBeside = (field: string) => field.startsWith("output.") || field.startsWith("certainty");

const own = (changes: Record<string, string>) =>
  Object.entries(changes).filter(([field]) => !isBeside(field)).sort(([a], [b]) => a.localeCompare(b));

/** Name of a run: its scenario, and what it changes of it. */
export const runWords = (run: RunEntry): string =>
  [run.name ?? run.path, changesAfter(own(run.changes))].filter(Boolean).join(", ");

/**
 * What is said beside the verdict of a run that is not of what the run bar would run now; empty where it
 * is, or where that is not known yet: `scenario` is the name of the one in the bar.
 */
export function markOf(run: RunEntry, scenario: string | null, changes: Changes, isCurrent: boolean | null): string {
  if (scenario === null) return "";
  if (run.name !== scenario) return "of another scenario";
  if (isCurrent !== false) return "";
  const asked = Object.fromEntries(Object.entries(changes).map(([field, value]) => [field, written(value)]));
  return JSON.stringify(own(run.changes)) === JSON.stringify(own(asked)) ? "outdated: changed since" : "of another variant";
}

/** Whether a model file is, or is named by, the scenario with its changes; null where that is not known. */
export function isPart(path: string, scenario: string, fields: ScenarioFields | null, changes: Changes, models: readonly ModelEntry[]): boolean | null {
  const parts = new Set<string>();
  const add = (one: string) => {
    if (parts.has(one)) return;
    parts.add(one);
    models.find((model) => model.path === one)?.names?.forEach(add);
  };
  add(scenario);
  if (fields?.path !== scenario) return parts.has(path) || null;
  const named = (typed: string, kind: string) => lineOf(scenario, typed).replace(/^shipped:line\//, `shipped:${kind}/`);
  const line = changes["line"] ?? fields.line;
  if (typeof line === "string") add(named(line, "line"));
  fields.pantographs.forEach((model, place) => add(named(String(changes[`pantographs.${place}.model`] ?? model), "pantograph")));
  if (parts.has(path)) return true;
  // A variant of a shipped scenario has a line that only the server finds.
  return path.startsWith("shipped:line/") && fields.line === null ? null : false;
}
