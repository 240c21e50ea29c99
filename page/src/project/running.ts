/** A run of the chosen scenario: started, followed to its end, kept as a scenario of its own. */
import { computed, effect, signal, untracked } from "@preact/signals";
import { ask } from "../connection/http.ts";
import { isSmall } from "../shell/layout.ts";
import { complain, say } from "../shell/messages.ts";
import { part } from "../shell/panels.ts";
import { changes } from "../state/changes.ts";
import { keepFailure } from "../state/failure.ts";
import { hasEnded, jobs, type Job } from "../state/jobs.ts";
import { openModel } from "../state/opening.ts";
import { settled } from "../state/pending.ts";
import { below, project, readProject, type ProjectView, type RunEntry } from "../state/project.ts";
import { refused } from "./speed.ts";
import { scenario, source, ticked } from "../state/selection.ts";

export const withMotion = signal(true);
export const withCertainty = signal(false);
/** What was ordered from this window and is not over, by its job. */
const started = new Map<string, object>();
/** Lost jobs of which it was said. */
const mourned = new Set<string>();

/** Of the newest run that is being computed; of one that is over nothing. */
export const runningJob = computed<Job | null>(
  () => jobs.value.findLast((one) => one.kind === "run" && (one.state === "running" || one.state === "waiting")) ?? null,
);

/** Why nothing can be run, in words; null where a run can begin. */
export const obstacle = computed(() =>
  scenario.value === null ? "Choose a scenario first." : runningJob.value !== null ? "A run is being computed." : (refused.value?.why ?? null));

export const canRun = computed(() => obstacle.value === null);

/** A run is ordered, and the server has not answered. */
let isOrdered = false;

/** Run the chosen scenario with what is changed; the player follows it. */
export async function run(): Promise<void> {
  const path = scenario.peek();
  if (path === null || runningJob.peek() || isOrdered) return;
  isOrdered = true;
  const field = document.activeElement;
  await settled();
  // Who ran it from a field goes on there.
  if (field instanceof HTMLInputElement && field.isConnected) field.focus();
  // The speed may just have been typed.
  if (refused.peek() !== null) {
    isOrdered = false;
    return;
  }
  await order({
    scenario: path,
    changes: changes.peek(),
    record_motion: withMotion.peek(),
    certainty: withCertainty.peek(),
    // The line may have changed since the run of that name: both are wanted, to compare them.
    keep_both: true,
  });
}

async function order(body: object): Promise<void> {
  isOrdered = true;
  try {
    const { job } = await ask<{ job: Job }>("runs", { body });
    started.set(job.id, body);
    source.value = { job: job.id };
    // A short run may be over before its answer is here.
    const known = jobs.peek().find((one) => one.id === job.id);
    if (known) endedIf(known);
  } catch (error) {
    complain(error);
  } finally {
    isOrdered = false;
  }
}

/** Run a scenario at once. */
export async function runThis(path: string): Promise<void> {
  openModel(path, "scenario");
  part.value = "main";
  await run();
}

/** Keep what is changed as a scenario that holds only the difference. */
export async function saveAsScenario(name: string): Promise<boolean> {
  const base = scenario.peek();
  if (base === null) return false;
  try {
    const body = { scenario: base, name, changes: changes.peek() };
    const { path } = await ask<{ path: string }>("variant", { body });
    await readProject();
    openModel(path, "scenario");
    say("note", `${path} holds what differs from ${nameOf(base)}.`);
    return true;
  } catch (error) {
    complain(error);
    return false;
  }
}

export const nameOf = (path: string): string => {
  const found = project.peek();
  const entry = [...(found?.models ?? []), ...(found?.library ?? [])].find((one) => one.path === path);
  return entry?.name ?? path;
};

function ended(job: Job): void {
  started.delete(job.id);
  if (job.state === "failed") {
    keepFailure(job);
    return say("error", job.error ? below(job.error.text) : `${job.title} failed.`);
  }
  if (job.state !== "done" || job.path === null) return;
  for (const note of job.notes) say("warning", note);
  const path = job.path;
  void readProject();
  // Whoever looks at something else by now keeps it.
  if (isWatched(job)) source.value = { run: path };
  if (!ticked.peek().includes(path)) ticked.value = [...ticked.peek(), path];
}

/** Of a run that ended with its server, whoever began it: nothing of it was written. */
function lost(job: Job): void {
  if (mourned.has(job.id) || job.kind !== "run") return;
  mourned.add(job.id);
  const body = started.get(job.id);
  started.delete(job.id);
  const text = `The run ${job.title} was ended with the server that computed it.`;
  say("error", text, body && { label: "Run again", act: () => void order(body) });
}

function endedIf(job: Job): void {
  if (job.lost) return lost(job);
  if (!hasEnded(job)) return;
  if (started.has(job.id)) ended(job);
  else if (isWatched(job)) watched(job);
}

/** Whether the player shows a run that is or was computed. */
export function isWatched(job: Job): boolean {
  const played = source.value;
  return job.kind === "run" && played !== null && "job" in played && played.job === job.id;
}

/** The end of a run that another window began, and this one watches. */
function watched(job: Job): void {
  if (job.state === "done" && job.path !== null) source.value = { run: job.path };
  if (job.state === "failed") keepFailure(job);
}

/** The newest run that can be read; null without one. */
export const newestRun = (runs: readonly RunEntry[]): string | null =>
  [...runs].filter((one) => one.verdict !== "unreadable").sort((a, b) => (a.created ?? "").localeCompare(b.created ?? "")).at(-1)?.path ?? null;

/** Where the tree is out of sight the newest run is shown at first. */
function openNewest(view: ProjectView): void {
  const nothing = source.peek() === null && ticked.peek().length === 0;
  const path = newestRun(view.runs);
  if (nothing && path !== null && isSmall()) source.value = { run: path };
}

export function followRuns(): void {
  let isFirst = true;
  effect(() => {
    const view = project.value;
    if (!view || !isFirst) return;
    isFirst = false;
    openNewest(view);
  });
  effect(() => {
    const all = jobs.value;
    untracked(() => all.forEach(endedIf));
  });
}
