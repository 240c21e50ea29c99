/**
 * Velocity of the contact wire over position and time, with paths of the pantographs and fronts at
 * the wave speed. A click sets the clock; a box, Ctrl and wheel, or keys zoom.
 */
import { useSignal } from "@preact/signals";
import { useEffect, useMemo, useRef } from "preact/hooks";
import { ScaleKey } from "../charts/ScaleKey.tsx";
import { colour } from "../charts/colours.ts";
import { decimals } from "../charts/numbers.ts";
import { scaleOf } from "./paint.ts";
import { SpaceTimeView } from "./spaceTimeView.ts";
import { NoRun } from "./RunList.tsx";
import { Refusal } from "./State.tsx";
import { MotionOffer } from "./MotionOffer.tsx";
import { shownRun, versionOf } from "./which.ts";
import "../charts/charts.css";
import "./results.css";

export function SpaceTime() {
  const run = shownRun.value;
  if (run === null) return <NoRun then="the motion of its wires is shown over position and time." />;
  return <View key={versionOf([run])} run={run} />;
}

function View({ run }: { run: string }) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const waves = useSignal(true);
  const view = useMemo(() => new SpaceTimeView(run, waves), []);
  useEffect(() => view.start(canvas.current!), []);
  const { shown, complaint, absent, readout, waiting, zoomed } = view;
  const about = shown.value?.about;
  const told = absent.value || complaint.value !== null;
  return (
    <>
    {absent.value && <MotionOffer run={run} />}
    {complaint.value && <Refusal complaint={complaint.value} what={`The motion of ${run} cannot be shown`} />}
    <div class="space-time" hidden={told}>
      <div class="bar">
        {!about && <span role="status">Loading the motion of {run} …</span>}
        <label>
          <input type="checkbox" checked={waves.value} onChange={(event) => (waves.value = event.currentTarget.checked)} /> fronts at
          the wave speed{about?.wave_speed ? `, ${decimals(about.wave_speed, 1)} m/s` : ""}
        </label>
        {zoomed.value && <button onClick={() => view.reset()}>Show all</button>}
        {about?.paths.map((path) => (
          <span key={path.name}>
            <i class="key" style={{ background: colour(path.colour) }} aria-hidden="true" /> {path.name}
          </span>
        ))}
        <span class="soft" role="status">{waiting.value ? (about ? "Loading this part …" : "Loading the recorded motion …") : ""}</span>
      </div>
      <canvas
        ref={canvas}
        role="application"
        tabIndex={0}
        aria-label="Velocity of the contact wire over position and time. Enter sets the clock; plus, minus and arrows change the part; 0 shows all."
        onKeyDown={(event) => view.key(event)}
      />
      <output class="chart-readout" aria-live="polite">
        {readout.value}
      </output>
      {about && (
        <>
          <ScaleKey scale={scaleOf(about.scale_end)} />
          <p class="soft">
            Means over {decimals((about.x[1] - about.x[0]) / about.columns, 2)} m and{" "}
            {decimals((1e3 * (about.t[1] - about.t[0])) / about.rows, 1)} ms; up to {decimals(about.largest, 2)} m/s. 0.5 % of them are
            beyond the scale.
          </p>
        </>
      )}
    </div>
    </>
  );
}
