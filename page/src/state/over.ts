/**
 * What is chosen and typed and stands in no file, kept over a reload of the page in the same tab:
 * the scenario, the file that is open, and what the next run changes. Texts have their drafts.
 */
import { effect } from "@preact/signals";
import { changes, type Changes } from "./changes.ts";
import { project, type ProjectView } from "./project.ts";
import { file, scenario } from "./selection.ts";

const NAME = "arcless.over";

interface Kept {
  folder: string;
  scenario: string | null;
  file: string | null;
  changes: Changes;
}

function found(): Kept | null {
  try {
    const kept = JSON.parse(sessionStorage.getItem(NAME) ?? "null") as Kept | null;
    return typeof kept?.folder === "string" && typeof kept.changes === "object" ? kept : null;
  } catch {
    return null;
  }
}

function keep(): void {
  const folder = project.peek()?.folder;
  if (folder === undefined) return;
  const kept: Kept = { folder, scenario: scenario.peek(), file: file.peek(), changes: changes.peek() };
  try {
    sessionStorage.setItem(NAME, JSON.stringify(kept));
  } catch {
    // A browser that keeps nothing.
  }
}

function restore(kept: Kept, { folder, models, library }: ProjectView): void {
  const paths = new Set([...models, ...library].map((one) => one.path));
  if (kept.folder !== folder) return;
  if (kept.scenario !== null && paths.has(kept.scenario)) {
    scenario.value = kept.scenario;
    changes.value = kept.changes;
  }
  if (kept.file !== null && paths.has(kept.file)) file.value = kept.file;
}

/** Take back what was kept, once the folder is known to be the same, and keep it when the page is left. */
export function followReload(): void {
  const kept = found();
  const end = effect(() => {
    const view = project.value;
    // After the others that follow the project: they choose a scenario, and drop changes of another one.
    if (view) queueMicrotask(() => (end(), kept && restore(kept, view)));
  });
  addEventListener("pagehide", keep);
}
