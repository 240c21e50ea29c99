/** A run without recorded motion: what still moves, and how to have its wires move. */
import { useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { hear, tell } from "../connection/stream.ts";
import { jobs } from "../state/jobs.ts";
import { source } from "../state/selection.ts";

/** The job that computes the motion of a run; the server has the wires move when it has ended. */
function useComputing(run: string) {
  const name = useSignal<string | null>(null);
  useEffect(() => {
    name.value = null;
    return hear("computing", (message) => {
      const of = message["source"] as { run?: string };
      if (of.run === run) name.value = message["job"] as string;
    });
  }, [run]);
  return jobs.value.find((one) => one.id === name.value);
}

function Compute({ run }: { run: string }) {
  const job = useComputing(run);
  if (job?.state === "waiting" || job?.state === "running") {
    return <>Its motion is being computed, {Math.round(100 * job.fraction)} %.</>;
  }
  return (
    <>
      {job?.error && <span role="alert">{job.error.text} </span>}
      <button
        title="Computes the run again, shows its line, and changes no file"
        onClick={() => tell({ topic: "compute motion", source: { run } })}
      >
        Compute motion
      </button>
    </>
  );
}

export function NoMotion() {
  const of = source.value;
  return (
    <span role="status">
      This run has no recorded motion of wires: only pantographs, droppers and supports change.{" "}
      {of && "run" in of && <Compute run={of.run} />}
    </span>
  );
}
