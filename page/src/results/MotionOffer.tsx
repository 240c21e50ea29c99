/** A run without recorded motion: the offer to compute it again, with its motion. */
import { useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { hear, tell } from "../connection/stream.ts";
import { jobs } from "../state/jobs.ts";
import { Nothing } from "./State.tsx";

/**
 * @param again asks for the motion once more
 */
export function MotionOffer({ run, again }: { run: string; again: () => void }) {
  const job = useSignal<string | null>(null);
  useEffect(
    () =>
      hear("computing", (message) => {
        const source = message["source"] as { run?: string };
        if (source.run === run) job.value = message["job"] as string;
      }),
    [run],
  );
  const found = jobs.value.find((one) => one.id === job.value);
  useEffect(() => {
    if (found?.state === "done") again();
  }, [found?.state]);
  return (
    <Nothing>
      <p>The motion of the wires was not recorded in this run. Its forces and uplifts are under Results.</p>
      {found && found.state !== "done" ? (
        <p role="status">
          {found.error ? found.error.text : `Computing the motion, ${Math.round(100 * found.fraction)} %`}
        </p>
      ) : (
        <button onClick={() => tell({ topic: "compute motion", source: { run } })}>Compute the motion</button>
      )}
    </Nothing>
  );
}
