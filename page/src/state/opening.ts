/** Opening a model: a scenario that is opened is the one that is run, and one that is chosen stays until its file is gone. */
import { batch, effect } from "@preact/signals";
import { project, type ModelEntry, type ModelKind, type ProjectView } from "./project.ts";
import { file, scenario } from "./selection.ts";

/** Open a model. A scenario is the one that is run from now on, also where its file is open already. */
export function openModel(path: string, kind: ModelKind | null): void {
  batch(() => {
    file.value = path;
    if (kind === "scenario") scenario.value = path;
  });
}

const all = (view: ProjectView | null): ModelEntry[] => [...(view?.models ?? []), ...(view?.library ?? [])];

/** Follow the files that are opened, and those that go; the returned function ends it. */
export function followOpening(): () => void {
  // A file that was just written is in no list yet, and not gone.
  const seen = new Set<string>();
  const ends = [
    effect(() => {
      const view = project.value;
      if (!view) return;
      const paths = all(view).filter((one) => one.kind === "scenario").map((one) => one.path);
      const chosen = scenario.peek();
      const isThere = chosen !== null && (paths.includes(chosen) || !seen.has(chosen));
      for (const path of paths) seen.add(path);
      if (isThere) return;
      scenario.value = view.models.find((one) => one.kind === "scenario" && !one.error)?.path ?? null;
      if (file.peek() === null) file.value = scenario.peek();
    }),
    followFile(),
  ];
  return () => ends.forEach((end) => end());
}

/** Of a file that was just written its kind is known at a later look. */
function followFile(): () => void {
  let known: string | null = null;
  return effect(() => {
    const path = file.value;
    const entry = all(project.value).find((one) => one.path === path);
    if (path === known || !entry) return;
    known = path;
    if (entry.kind === "scenario") scenario.value = entry.path;
  });
}
