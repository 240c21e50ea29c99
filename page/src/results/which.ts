/** The run that panels of results show: the one in the player, else the one that was ticked last. */
import { computed, signal } from "@preact/signals";
import { project, type RunEntry } from "../state/project.ts";
import { source, ticked } from "../state/selection.ts";

/** Path of the run, below the folder; null for none. */
export const shownRun = computed<string | null>(() => {
  const played = source.value;
  if (played && "run" in played) return played.run;
  const runs = new Set(project.value?.runs.map((one) => one.path));
  return ticked.value.filter((path) => runs.has(path)).at(-1) ?? null;
});

/** The run that others are compared with; null: the oldest of those that are ticked. */
export const baseline = signal<string | null>(null);

/** What the list of runs says of it. */
export const entryOf = (path: string | null): RunEntry | undefined =>
  project.value?.runs.find((one) => one.path === path);

/** Changes when a run of the same path was computed anew. */
export const versionOf = (paths: string[]): string =>
  paths.map((path) => `${path} ${entryOf(path)?.created ?? ""}`).join("\n");
