/** A run without recorded motion: the offer to run its scenario again, with its motion recorded. */
import { useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { ask } from "../connection/http.ts";
import { complain } from "../shell/messages.ts";
import { jobs, type Job } from "../state/jobs.ts";
import { project, type ProjectView } from "../state/project.ts";
import { source } from "../state/selection.ts";
import { told } from "../state/subject.ts";
import { Nothing } from "./State.tsx";
import { entryOf } from "./which.ts";

/** What is ordered: the scenario with the changes of the run, and its motion. */
export function order(path: string, changes: Record<string, string>) {
  return { scenario: path, changes: { ...changes, "output.motion": true }, record_motion: true, keep_both: true };
}

/** Path of the scenario of a name, in the folder or else in the library; `null` where it is gone. */
export function scenarioNamed(name: string | null | undefined, view: ProjectView | null): string | null {
  const all = [...(view?.models ?? []), ...(view?.library ?? [])];
  return all.find((one) => one.kind === "scenario" && one.name === name)?.path ?? null;
}

export function MotionOffer({ run }: { run: string }) {
  const job = useSignal<string | null>(null);
  const found = jobs.value.find((one) => one.id === job.value);
  const entry = entryOf(run);
  const path = scenarioNamed(entry?.name, project.value);
  const begin = async (): Promise<void> => {
    if (path === null) return;
    try {
      const body = order(path, entry?.changes ?? {});
      job.value = (await ask<{ job: Job }>("runs", { body })).job.id;
    } catch (error) {
      complain(error);
    }
  };
  useEffect(() => {
    if (found?.state === "done" && found.path !== null) source.value = { run: found.path };
  }, [found?.state]);
  return (
    <Nothing>
      <p>The motion of the wires was not recorded in this run. Its forces and uplifts are under Results.</p>
      {found && found.state !== "failed" ? (
        <p role="status">Running with its motion recorded, {Math.round(100 * found.fraction)} %</p>
      ) : (
        <p>
          <button disabled={path === null} onClick={() => void begin()}>
            Run again with its motion
          </button>{" "}
          {path === null
            ? `The scenario ${entry?.name ?? "of this run"} is no longer in this folder.`
            : `${told(path)} as it is now, with the changes of this run; this run stays.`}
        </p>
      )}
      {found?.error && <p role="alert">{found.error.text}</p>}
    </Nothing>
  );
}
