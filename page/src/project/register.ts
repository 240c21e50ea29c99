/** The folder: its tree, the bar that runs a scenario, the first screen. */
import { computed } from "@preact/signals";
import { addCommand, addPanel } from "../shell/panels.ts";
import { cancel } from "../state/jobs.ts";
import { followOpening } from "../state/opening.ts";
import { complain } from "../shell/messages.ts";
import { isOffered, showLibrary } from "./library.ts";
import { canRun, followRuns, run, runningJob } from "./running.ts";
import { followScenario } from "./scenarioFields.ts";

export function register(): void {
  addPanel({ id: "run bar", slot: "top", title: "Run", order: 0, load: async () => (await import("./RunBar.tsx")).RunBar });
  addPanel({ id: "project", slot: "left", title: "Project", order: 0, load: async () => (await import("./ProjectTree.tsx")).ProjectTree });
  addPanel({
    id: "start",
    slot: "main", alone: true,
    title: "Start",
    order: -10,
    when: isOffered,
    load: async () => (await import("./Start.tsx")).Start,
  });
  addCommand({
    id: "start",
    title: "New model from the library",
    act: showLibrary,
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
