/** The newest run of this window that failed in a step: when, in s, and where the pantographs were, in m. */
import { computed, signal } from "@preact/signals";
import type { Job } from "./jobs.ts";
import { source } from "./selection.ts";

export interface Failure {
  job: string;
  time_s: number;
  /** Position along the track by name of the pantograph. */
  positions_m: Record<string, number>;
}

const newest = signal<Failure | null>(null);

/** The failure of the run that is looked at. */
export const failure = computed(() => {
  const [found, of] = [newest.value, source.value];
  return found && of && "job" in of && of.job === found.job ? found : null;
});

/** Keep where a job failed, if it was in a step. */
export function keepFailure({ id, error }: Job): void {
  if (error?.time_s === undefined) return;
  newest.value = { job: id, time_s: error.time_s, positions_m: error.positions_m ?? {} };
}
