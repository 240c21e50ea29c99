/** What runs and measurements are called, as the tree has them, and the order they stand in there. */
import { differences } from "../project/words.ts";
import type { ProjectView, RunEntry } from "../state/project.ts";

/** Runs as the tree lists them: the newest first. */
export const listed = (runs: readonly RunEntry[]): RunEntry[] =>
  [...runs].sort((a, b) => (b.created ?? "").localeCompare(a.created ?? ""));

/** Path of each run and measurement → its name; of some that are called the same, with the folder. */
export function namesOf(view: Pick<ProjectView, "runs" | "measured">): Map<string, string> {
  const runs = listed(view.runs);
  const told = differences(runs);
  const found = runs.map(({ path }, k): [string, string] => [path, told[k]!.filter(Boolean).join(", ")]);
  for (const { path } of view.measured) found.push([path, `${path.replace(/^.*\/|\.[^.]*$/g, "")} (measured)`]);
  const count = new Map<string, number>();
  for (const [, name] of found) count.set(name, (count.get(name) ?? 0) + 1);
  return new Map(found.map(([path, name]) => [path, count.get(name) === 1 ? name : `${name}, ${path.replace(/^(runs|measured)\//, "")}`]));
}

/** Of runs the one that was computed first: others are compared with it, in whatever order they were ticked. */
export function oldestOf(paths: readonly string[], runs: readonly RunEntry[]): string | null {
  const own = listed(runs.filter((one) => paths.includes(one.path)));
  return own.at(-1)?.path ?? paths[0] ?? null;
}

/** What is compared, the one that others are compared with first, the rest as the tree has them. */
export function ordered(paths: readonly string[], base: string | null, view: Pick<ProjectView, "runs" | "measured">): string[] {
  const tree = [...listed(view.runs), ...view.measured].map((one) => one.path);
  const first = base !== null && paths.includes(base) ? base : oldestOf(paths, view.runs);
  const place = (path: string) => (path === first ? -1 : tree.includes(path) ? tree.indexOf(path) : tree.length);
  return [...paths].sort((a, b) => place(a) - place(b));
}
