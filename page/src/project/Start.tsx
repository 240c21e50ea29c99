/** The first screen: an example that runs in one click, and all shipped models to begin with. */
import { useSignal } from "@preact/signals";
import { project, type ModelEntry } from "../state/project.ts";
import { file } from "../state/selection.ts";
import { show } from "../shell/panels.ts";
import { copy } from "./copy.ts";
import { runThis } from "./running.ts";
import { KINDS, matches } from "./words.ts";

/** Plane, one pantograph, a second to compute: what a first run should be. */
const EXAMPLE = "en50318-ac-simple-320-planar";

async function runExample(example: ModelEntry): Promise<void> {
  const path = await copy(example);
  if (path !== null) await runThis(path);
}

function Template({ entry }: { entry: ModelEntry }) {
  return (
    <li class="template">
      <button class="name" onClick={() => void copy(entry)}>
        <strong>{entry.name}</strong>
        <span>{entry.description}</span>
      </button>
      <button
        class="plain"
        aria-label={`Look at ${entry.name} first`}
        onClick={() => {
          file.value = entry.path;
          show("drawing");
        }}
      >
        Look
      </button>
    </li>
  );
}

export function Start() {
  const view = project.value;
  const typed = useSignal("");
  if (!view) return null;
  const example = view.library.find((one) => one.kind === "scenario" && one.name === EXAMPLE);
  const found = view.library.filter((entry) => matches(entry, typed.value));
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
      <input
        type="search"
        class="search"
        aria-label="Search shipped models"
        placeholder="Search by name, country, speed"
        value={typed.value}
        onInput={(event) => (typed.value = event.currentTarget.value)}
      />
      {KINDS.map(([kind, title]) => {
        const all = found.filter((one) => one.kind === kind);
        return (
          all.length > 0 && (
            <section key={kind}>
              <h3>{title}</h3>
              <ul class="templates">
                {all.map((entry) => <Template key={entry.path} entry={entry} />)}
              </ul>
            </section>
          )
        );
      })}
      {found.length === 0 && <p class="soft">No shipped model has these words in its name or description.</p>}
    </div>
  );
}
