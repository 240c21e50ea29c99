/** The folder: models by kind, runs to tick, studies, measured data, and the shipped library. */
import type { ComponentChildren } from "preact";
import { showStudy } from "../studies/vary.ts";
import { openModel } from "../state/opening.ts";
import { project, type ModelEntry, type ProjectView } from "../state/project.ts";
import { showing } from "../drawing/scene.ts";
import { file, source, ticked } from "../state/selection.ts";
import { part, show } from "../shell/panels.ts";
import { CopyForm, copying } from "./CopyForm.tsx";
import { LibraryList } from "./LibraryList.tsx";
import { showLibrary } from "./library.ts";
import { openMeasured } from "../results/measured.ts";
import { Runs } from "./Runs.tsx";
import { runThis } from "./running.ts";
import { treeKey } from "./treeKeys.ts";
import { KINDS } from "./words.ts";

export function Section({ title, count, open = true, children }: { title: string; count: number; open?: boolean; children: ComponentChildren }) {
  return (
    <details class="section" open={open}>
      <summary>
        {title}
        <span class="count">{count}</span>
      </summary>
      {children}
    </details>
  );
}

function open(entry: ModelEntry): void {
  openModel(entry.path, entry.kind);
  part.value = "main";
  if (entry.kind === "study") show("studies");
}

function Model({ entry, act }: { entry: ModelEntry; act?: [string, () => void] }) {
  const isOpen = file.value === entry.path;
  return (
    <li class={isOpen ? "entry here" : "entry"}>
      <button class="name" aria-current={isOpen} title={entry.error ?? entry.description} onClick={() => open(entry)}>
        {entry.error && <span class="sign not-met" aria-hidden="true">✖</span>}
        {entry.name}
        {entry.error && <span class="unseen">: cannot be read</span>}
      </button>
      {act && (
        <button class="act" aria-label={`${act[0]}: ${entry.name}`} title={act[0]} onClick={act[1]}>
          {act[0] === "Run" ? "▶" : "⧉"}
        </button>
      )}
      {entry.error && <p class="broken" title={entry.error}>{isOpen ? "An error, told below its fields" : entry.error}</p>}
      {copying.value?.path === entry.path && copying.value.at === "tree" && <CopyForm entry={entry} />}
    </li>
  );
}

function Models({ view }: { view: ProjectView }) {
  return (
    <>
      {KINDS.map(([kind, title]) => {
        const all = view.models.filter((one) => one.kind === kind);
        if (all.length === 0) return null;
        return (
          <Section key={kind} title={title} count={all.length}>
            <ul>
              {all.map((entry) =>
                kind === "scenario" && !entry.error ? (
                  <Model key={entry.path} entry={entry} act={["Run", () => void runThis(entry.path)]} />
                ) : (
                  <Model key={entry.path} entry={entry} />
                ),
              )}
            </ul>
          </Section>
        );
      })}
    </>
  );
}

function Measured({ view }: { view: ProjectView }) {
  if (view.measured.length === 0) return null;
  return (
    <Section title="Measured" count={view.measured.length}>
      <ul>
        {view.measured.map(({ path }) => (
          <li key={path} class="entry">
            <input
              type="checkbox"
              aria-label={`Compare ${path}`}
              checked={ticked.value.includes(path)}
              onChange={(event) => {
                const others = ticked.value.filter((one) => one !== path);
                ticked.value = event.currentTarget.checked ? [...others, path] : others;
              }}
            />
            <button class="name" title={`${path}: speed, supply and mass above the sensors`} onClick={() => openMeasured(path)}>
              {path.replace(/^.*\//, "")}
            </button>
          </li>
        ))}
      </ul>
    </Section>
  );
}

function KeptStudies({ view }: { view: ProjectView }) {
  if (view.studies.length === 0) return null;
  return (
    <Section title="Results of studies" count={view.studies.length}>
      <ul>
        {view.studies.map(({ path, name, done, planned }) => (
          <li key={path} class="entry">
            <button class="name" onClick={() => showStudy(path)}>{name}</button>
            <span class="numbers soft">{planned === null ? done : `${done} of ${planned}`}</span>
          </li>
        ))}
      </ul>
    </Section>
  );
}

function Library({ view }: { view: ProjectView }) {
  return (
    <Section title="Library" count={view.library.length} open={false}>
      <LibraryList library={view.library} label="Search the library" hint="Search">
        {(entry) => <Model key={entry.path} entry={entry} act={["Copy to my folder", () => (copying.value = { path: entry.path, at: "tree" })]} />}
      </LibraryList>
    </Section>
  );
}

/** Play a run; the one that is played goes on where it is, and is seen again. */
function play(path: string): void {
  const played = source.peek();
  part.value = "main";
  if (played && "run" in played && played.run === path) showing.value = "played";
  else source.value = { run: path };
}

export function ProjectTree() {
  const view = project.value;
  if (!view) return <p class="soft tree-head">Reading the folder</p>;
  return (
    <div class="tree" onKeyDown={treeKey}>
      <div class="tree-top">
        <h2 class="tree-head" title={view.folder}>{view.name}</h2>
        <button title="New line, scenario or pantograph, from a shipped one" onClick={showLibrary}>New …</button>
      </div>
      <Models view={view} />
      <Runs view={view} play={play} />
      <KeptStudies view={view} />
      <Measured view={view} />
      <Library view={view} />
    </div>
  );
}
