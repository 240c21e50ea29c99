/** What the server computes: runs, studies, and all that takes long. */
import { signal } from "@preact/signals";
import { ask } from "../connection/http.ts";
import { hear, whenOpen, type Message } from "../connection/stream.ts";
import type { Complaint } from "../connection/http.ts";

export interface Job {
  id: string;
  kind: "run" | "study" | "report" | "hands on" | "explanation" | "motion";
  title: string;
  state: "waiting" | "running" | "done" | "failed" | "cancelled";
  /** 0 to 1, and what is being done. */
  fraction: number;
  doing: string;
  /** Where its result is, below the folder, once it is there. */
  path: string | null;
  error?: Complaint;
  /** Warnings of the run, whole sentences. */
  notes: string[];
  /** It was ended with the server that computed it: the one that is there now does not know it. */
  lost?: boolean;
}

export const jobs = signal<Job[]>([]);

export const hasEnded = ({ state }: Job): boolean => state !== "waiting" && state !== "running";

/** All jobs of the server that is there now, and what another one before it had not finished. */
function withLost(before: Job[], now: Job[]): Job[] {
  const known = new Set(now.map((one) => one.id));
  const gone = before.filter((one) => !known.has(one.id) && !hasEnded(one));
  return [...gone.map((one): Job => ({ ...one, state: "failed", path: null, lost: true })), ...now];
}

export function followJobs(): void {
  whenOpen(() =>
    void ask<Job[]>("jobs").then(
      (all) => (jobs.value = withLost(jobs.peek(), all)),
      // A server that is gone again; the next one is asked.
      () => undefined,
    ),
  );
  hear("job", (message: Message) => {
    const job = message["job"] as Job;
    jobs.value = [...jobs.peek().filter((one) => one.id !== job.id), job];
  });
}

export function cancel(id: string): Promise<unknown> {
  return ask(`jobs/${id}/cancel`, { method: "POST" });
}
