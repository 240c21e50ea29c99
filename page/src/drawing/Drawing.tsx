/** The line: side view and plan, one below the other, and what is drawn. */
import { part } from "../shell/panels.ts";
import { exaggeration, selected } from "../state/selection.ts";
import { isListed } from "../editor/checking.ts";
import { EXAGGERATIONS } from "./camera.ts";
import "./drawing.css";
import { Failed } from "./Failed.tsx";
import { fit } from "./fit.ts";
import type { Geometry } from "./geometry.ts";
import { indexOf } from "./lineIndex.ts";
import { LineView } from "./LineView.tsx";
import { edited, isDraft, isPlayed, isTried, played, showing, shown, wrong } from "./scene.ts";

export function Drawing() {
  const geometry = shown.value;
  return (
    <div class="drawing">
      <div class="toolbar">
        {played.value && edited.value && (
          <label>
            Line{" "}
            <select
              value={showing.value}
              onChange={(event) => (showing.value = event.currentTarget.value as "edited" | "played")}
            >
              <option value="edited">of the file: {edited.value.name}</option>
              <option value="played">of the run: {played.value.name}</option>
            </select>
          </label>
        )}
        <button onClick={fit} title="F" disabled={!geometry}>
          Show all
        </button>
        <label title="E">
          Heights{" "}
          <select
            value={String(exaggeration.value)}
            onChange={(event) => (exaggeration.value = Number(event.currentTarget.value))}
          >
            {[...new Set([...EXAGGERATIONS, exaggeration.value])]
              .sort((a, b) => a - b)
              .map((one) => (
                <option key={one} value={String(one)}>{`× ${one}`}</option>
              ))}
          </select>
        </label>
        {geometry && <Twins geometry={geometry} />}
        {isDraft.value && !isPlayed.value && <span class="draft">coarse elements while it changes</span>}
        {isTried.value && !isPlayed.value && <span class="draft">with values that are tried, not in the file</span>}
      </div>
      {wrong.value && !isPlayed.value && <Wrong />}
      <Failed />
      {geometry ? (
        <>
          <LineView view="side" />
          {geometry.spatial && <LineView view="plan" />}
        </>
      ) : (
        <p class="empty">{wrong.value ? "There is no line to draw yet." : "Choose a line or a scenario to draw its line."}</p>
      )}
    </div>
  );
}

/** Which wires are the second ones of twins, and how these are drawn. */
function Twins({ geometry }: { geometry: Geometry }) {
  const second = indexOf(geometry).wires.filter((wire) => wire.isSecond);
  if (!second.length) return null;
  return (
    <span class="twins">
      {second.map(({ name, kind }) => (
        <span key={name}>
          <i class={kind} aria-hidden="true" /> {name}
        </span>
      ))}{" "}
      drawn hollow, from the side mostly behind the first{geometry.spatial ? ": the plan shows both" : ""}
    </span>
  );
}

/** What is wrong with the text, and the way to its place. */
function Wrong() {
  const { text, field } = wrong.value!;
  // The list of the file that is edited has its errors in full; what only the drawing finds is told here.
  const isTold = isListed(text);
  const go = field ? () => ((selected.value = { kind: "field", field: field.join(".") }), (part.value = "right")) : null;
  return (
    <p class="wrong" role="status">
      {edited.value ? "Drawn is the last valid line. " : ""}
      {isTold ? "The file has an error." : text}
      {go && <button onClick={go}>Show the field</button>}
    </p>
  );
}
