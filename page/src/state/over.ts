/**
 * What is chosen and typed and stands in no file, kept over a reload of the page in the same tab:
 * the scenario, the file that is open, what the next run changes, the runs that are ticked, and the one
 * that is played. Texts have their drafts.
 */
import { effect } from "@preact/signals";
import { changes, type Changes } from "./changes.ts";
import { project, type ProjectView } from "./project.ts";
import { file, scenario, source, ticked } from "./selection.ts";
import { keepInTab, keptInTab } from "./tab.ts";

const NAME = "arcless.over";

interface Kept {
  folder: string;
  scenario: string | null;
  file: string | null;
  changes: Changes;
  /** Runs and measured files. */
  ticked: string[];
  /** The run that is played; null of one that is computed. */
  run: string | null;
}

function isRight({ folder, changes, ticked }: Kept): boolean {
  return typeof folder === "string" && typeof changes === "object" && Array.isArray(ticked);
}

function keep(): void {
  const folder = project.peek()?.folder;
  if (folder === undefined) return;
  const played = source.peek();
  const run = played && "run" in played ? played.run : null;
  const kept: Kept = { folder, scenario: scenario.peek(), file: file.peek(), changes: changes.peek(), ticked: ticked.peek(), run };
  keepInTab(NAME, kept);
}

function restore(kept: Kept, { folder, models, library, runs, measured }: ProjectView): void {
  const paths = new Set([...models, ...library].map((one) => one.path));
  if (kept.folder !== folder) return;
  if (kept.scenario !== null && paths.has(kept.scenario)) {
    scenario.value = kept.scenario;
    changes.value = kept.changes;
  }
  if (kept.file !== null && paths.has(kept.file)) file.value = kept.file;
  const there = new Set([...runs, ...measured].map((one) => one.path));
  ticked.value = kept.ticked.filter((path) => there.has(path));
  if (kept.run !== null && there.has(kept.run)) source.value = { run: kept.run };
}

/** Take back what was kept, once the folder is known to be the same, and keep it when the page is left. */
export function followReload(): void {
  const kept = keptInTab(NAME, isRight);
  const end = effect(() => {
    const view = project.value;
    // After the others that follow the project: they choose a scenario, and drop changes of another one.
    if (view) queueMicrotask(() => (end(), kept && restore(kept, view)));
  });
  addEventListener("pagehide", keep);
}
