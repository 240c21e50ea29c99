/** The scenario that studies and sessions begin with: the one that is run, else the file that is open. */
import { computed } from "@preact/signals";
import { project } from "./project.ts";
import { file, scenario } from "./selection.ts";

/** Path of the scenario; null where none is chosen. */
export const subject = computed(() => {
  if (scenario.value !== null) return scenario.value;
  const view = project.value;
  const open = [...(view?.models ?? []), ...(view?.library ?? [])].find(({ path }) => path === file.value);
  return open?.kind === "scenario" ? open.path : null;
});

/** A path as it is told: shipped models by their name. */
export const told = (path: string): string => path.replace(/^shipped:\w+\//, "");
