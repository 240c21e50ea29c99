/** Runs of the folder to tick, where a panel has none to show. */
import { project } from "../state/project.ts";
import { ticked } from "../state/selection.ts";
import { listed, namesOf } from "./named.ts";
import { Nothing } from "./State.tsx";

function toggle(path: string): void {
  const before = ticked.peek();
  ticked.value = before.includes(path) ? before.filter((one) => one !== path) : [...before, path];
}

/** In place of what a run would show: what to do next. */
export function NoRun({ then }: { then: string }) {
  const some = (project.value?.runs.length ?? 0) > 0;
  return (
    <Nothing>
      {some ? (
        <p>No run is chosen. Click one in the project, or tick it here: {then}</p>
      ) : (
        <p>There is no run yet. Choose a scenario at the top and press Run (Ctrl+Enter): {then}</p>
      )}
      <RunList />
    </Nothing>
  );
}

export function RunList({ measured = false }: { measured?: boolean }) {
  const view = project.value;
  if (!view) return null;
  const names = namesOf(view);
  const paths = [...listed(view.runs), ...(measured ? view.measured : [])].map((one) => one.path);
  if (!paths.length) return null;
  return (
    <ul class="run-list" aria-label={measured ? "Runs and measurements" : "Runs"}>
      {paths.map((path) => (
        <li key={path}>
          <label>
            <input type="checkbox" checked={ticked.value.includes(path)} onChange={() => toggle(path)} /> <span title={path}>{names.get(path)}</span>
          </label>
        </li>
      ))}
    </ul>
  );
}
