/** What is shown of a motion: the range follows, velocity as colour, the line at rest, exaggeration. */
import { EXAGGERATIONS } from "../drawing/camera.ts";
import { ghost, isPlayed, redraw } from "../drawing/scene.ts";
import { exaggeration } from "../state/selection.ts";
import { NoMotion } from "./NoMotion.tsx";
import { scene, wake } from "./player.ts";
import { following, startFollowing } from "./views/camera.ts";
import { byVelocity } from "./views/velocity.ts";

/** Exaggerations by the slider: the offered ones, so that the number is a plain one. */
function Exaggeration() {
  const nearest = EXAGGERATIONS.findLastIndex((one) => one <= exaggeration.value);
  return (
    <label>
      Exaggeration
      <input
        type="range"
        min={0}
        max={EXAGGERATIONS.length - 1}
        step={1}
        value={Math.max(nearest, 0)}
        aria-valuetext={`${exaggeration.value} times`}
        onInput={(event) => (exaggeration.value = EXAGGERATIONS[Number(event.currentTarget.value)] ?? 1)}
      />
      <output>× {exaggeration.value}</output>
    </label>
  );
}

export function MotionTools() {
  if (!scene.value || !isPlayed.value) return null;
  return (
    <div class="motion-tools" role="group" aria-label="Motion">
      <Exaggeration />
      <label>
        <input
          type="checkbox"
          checked={following.value}
          onChange={(event) => {
            if (event.currentTarget.checked) startFollowing();
            else following.value = false;
            wake();
          }}
        />
        Follow the first pantograph
      </label>
      <label>
        <input type="checkbox" checked={ghost.value} onChange={(event) => ((ghost.value = event.currentTarget.checked), redraw())} />
        Line at rest
      </label>
      <label>
        <input type="checkbox" checked={byVelocity.value} onChange={(event) => ((byVelocity.value = event.currentTarget.checked), redraw())} />
        Velocity as colour
      </label>
      {!scene.value.wires && <NoMotion />}
    </div>
  );
}
