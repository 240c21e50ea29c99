/** What sliders try, as fields that the next run of the chosen scenario changes. */
import { computed } from "@preact/signals";
import { kind, opened } from "../editor/documents.ts";
import { run } from "../project/running.ts";
import { fields } from "../project/scenarioFields.ts";
import { changes, type Changes, type Typed } from "../state/changes.ts";
import { scenario } from "../state/selection.ts";
import { tried, type Changes as Tried } from "./asking.ts";

/** Path of the line that a scenario names: a file beside it, or a shipped one. */
export function linePath(scenarioPath: string, typed: string): string {
  if (!/\.(ya?ml|json)$/i.test(typed)) return `shipped:line/${typed}`;
  const parts: string[] = [];
  for (const part of [...scenarioPath.split("/").slice(0, -1), ...typed.split("/")]) {
    if (part === "..") parts.pop();
    else if (part !== ".") parts.push(part);
  }
  return parts.join("/");
}

/** Path of the line that the chosen scenario names; null where it holds its own. */
export const lineOfScenario = computed<string | null>(() => {
  const of = fields.value;
  return of?.line && of.path === scenario.value ? linePath(of.path, of.line) : null;
});

/** Fields of a scenario; those of its line stand below `line`. */
export function ofScenario(found: Tried, isLine: boolean): Changes {
  const named = Object.entries(found).map(([field, value]) => [isLine ? `line.${field}` : field, value as Typed]);
  return Object.fromEntries(named) as Changes;
}

/** Whether the file whose values are tried is the chosen scenario, or the line that it names. */
export const isOfScenario = computed(() => {
  const path = opened.value?.path;
  if (path === undefined || scenario.value === null) return false;
  return kind.value === "line" ? path === lineOfScenario.value : path === scenario.value;
});

/** Run the scenario with what is tried; nothing is written. */
export async function runTried(): Promise<void> {
  changes.value = { ...changes.peek(), ...ofScenario(tried.peek(), kind.peek() === "line") };
  await run();
}
