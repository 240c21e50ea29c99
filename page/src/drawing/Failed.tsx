/** A run that failed in a step: its time and place over the drawing, marked in it, and the way to replay it. */
import { failure } from "../state/failure.ts";
import { clock, range } from "../state/selection.ts";
import { kept } from "./camera.ts";
import { played, showing, shown, whole } from "./scene.ts";

/** So much of the motion before the failure is replayed, s. */
const BEFORE = 2;
/** Half of what is seen around the place, m: about a span on either side. */
const AROUND = 60;

function showPlace(): void {
  const line = shown.peek();
  const all = Object.values(failure.peek()?.positions_m ?? {});
  if (!line || !all.length) return;
  range.value = kept([Math.min(...all) - AROUND, Math.max(...all) + AROUND], whole(line));
}

function replay(): void {
  showing.value = "played";
  clock.live.value = false;
  clock.time_s.value = Math.max(clock.start_s.peek(), clock.end_s.peek() - BEFORE);
  clock.playing.value = true;
}

/** When and where it failed; what was computed until then can be replayed. */
export function Failed() {
  const found = failure.value;
  if (!found) return null;
  return (
    <p class="wrong failed" role="status">
      The run failed at t = {found.time_s.toFixed(3)} s
      {Object.entries(found.positions_m).map(([name, x]) => `, ${name} at ${x.toFixed(2)} m`).join("")}.
      <button onClick={showPlace}>Show the place</button>
      {played.value && <button onClick={replay}>Replay up to t = {clock.end_s.value.toFixed(2)} s</button>}
    </p>
  );
}
