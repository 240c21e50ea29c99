/** The first screen: an example that runs in one click, and all shipped models to begin with. */
import { openModel } from "../state/opening.ts";
import { project, type ModelEntry } from "../state/project.ts";
import { show } from "../shell/panels.ts";
import { copy, nameFor } from "./copy.ts";
import { CopyForm, copying } from "./CopyForm.tsx";
import { LibraryList } from "./LibraryList.tsx";
import { runThis } from "./running.ts";

/** Plane, one pantograph, a second to compute: what a first run should be. */
const EXAMPLE = "en50318-ac-simple-320-planar";

async function runExample(example: ModelEntry): Promise<void> {
  const path = await copy(example, nameFor(example));
  if (path !== null) await runThis(path);
}

function Template({ entry }: { entry: ModelEntry }) {
  const isAsked = copying.value?.path === entry.path && copying.value.at === "start";
  return (
    <li class="template">
      <button class="name" aria-expanded={isAsked} onClick={() => (copying.value = { path: entry.path, at: "start" })}>
        <strong>{entry.name}</strong>
        <span>{entry.description}</span>
      </button>
      <button
        class="plain"
        aria-label={`Look at ${entry.name} first`}
        onClick={() => {
          openModel(entry.path, entry.kind);
          show("drawing");
        }}
      >
        Look
      </button>
      {isAsked && <CopyForm entry={entry} />}
    </li>
  );
}

export function Start() {
  const view = project.value;
  if (!view) return null;
  const example = view.library.find((one) => one.kind === "scenario" && one.name === EXAMPLE);
  return (
    <div class="start">
      <h1>{view.models.length === 0 ? "This folder has no models yet" : "New model from the library"}</h1>
      <p class="soft">{view.folder}</p>
      {example && (
        <section class="example">
          <div>
            <h2>Try an example</h2>
            <p>{example.description}.</p>
          </div>
          <button class="run" onClick={() => void runExample(example)}>
            <span aria-hidden="true">▶</span> Copy and run it
          </button>
        </section>
      )}
      <h2>Begin with a shipped model</h2>
      <p>It is copied into the folder with its comments and sources; a scenario brings its line and pantographs.</p>
      <LibraryList library={view.library} label="Search shipped models" hint="Search by name, country, speed" lists="templates">
        {(entry) => <Template key={entry.path} entry={entry} />}
      </LibraryList>
    </div>
  );
}
