/** The folder: its tree, the bar that runs a scenario, the first screen. */
import { computed, signal } from "@preact/signals";
import { addCommand, addPanel, show } from "../shell/panels.ts";
import { cancel } from "../state/jobs.ts";
import { followOpening } from "../state/opening.ts";
import { project } from "../state/project.ts";
import { complain } from "../shell/messages.ts";
import { canRun, followRuns, run, runningJob } from "./running.ts";
import { followScenario } from "./scenarioFields.ts";

/** The first screen is asked for although the folder is not empty. */
const asked = signal(false);
const isEmpty = computed(() => project.value !== null && project.value.models.length === 0);

export function register(): void {
  addPanel({ id: "run bar", slot: "top", title: "Run", order: 0, load: async () => (await import("./RunBar.tsx")).RunBar });
  addPanel({ id: "project", slot: "left", title: "Project", order: 0, load: async () => (await import("./ProjectTree.tsx")).ProjectTree });
  addPanel({
    id: "start",
    slot: "main", alone: true,
    title: "Start",
    order: -10,
    when: computed(() => isEmpty.value || asked.value),
    load: async () => (await import("./Start.tsx")).Start,
  });
  addCommand({
    id: "start",
    title: "New model from the library",
    act: () => {
      asked.value = true;
      show("start");
    },
  });
  addCommand({ id: "run", title: "Run the scenario", keys: ["Ctrl+Enter"], act: () => void run(), when: canRun });
  addCommand({
    id: "cancel",
    title: "Cancel the run",
    act: () => void cancel(runningJob.peek()!.id).catch(complain),
    when: computed(() => runningJob.value !== null),
  });
  followScenario();
  followOpening();
  followRuns();
}
