/** Models, runs and studies of the folder, and the shipped library. */
import { project } from "../state/project.ts";
import { file } from "../state/selection.ts";

export function ProjectTree() {
  const view = project.value;
  if (!view) return <p>Reading the folder</p>;
  return (
    <ul>
      {[...view.models, ...view.library].map((model) => (
        <li key={model.path}>
          <button onClick={() => (file.value = model.path)}>{model.name}</button>
        </li>
      ))}
    </ul>
  );
}
