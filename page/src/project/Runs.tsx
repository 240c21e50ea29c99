/** Runs of the folder: a tick to overlay, the verdict by word and shape, main numbers, what differs. */
import { verdictOf, differences, numbers } from "./words.ts";
import type { ProjectView, RunEntry } from "../state/project.ts";
import { ticked } from "../state/selection.ts";
import { shownRun } from "../results/which.ts";
import { show } from "../shell/panels.ts";
import { Section } from "./ProjectTree.tsx";

function tick(path: string, on: boolean): void {
  const others = ticked.peek().filter((one) => one !== path);
  ticked.value = on ? [...others, path] : others;
}

function Run({ run, title, differs, play }: { run: RunEntry; title: string; differs: string; play: (path: string) => void }) {
  const { sign, word, state } = verdictOf(run.verdict);
  const isShown = shownRun.value === run.path;
  const isReadable = run.verdict !== "unreadable";
  return (
    <li class={isShown ? "entry run-entry here" : "entry run-entry"}>
      <input
        type="checkbox"
        aria-label={`Overlay ${[title, differs, word, ...numbers(run).map((one) => one.filter(Boolean).join(" "))].filter(Boolean).join(", ")}`}
        checked={ticked.value.includes(run.path)}
        disabled={!isReadable}
        onChange={(event) => tick(run.path, event.currentTarget.checked)}
      />
      <button class="name" aria-current={isShown} title={`${run.path}\n${run.reason ?? ""}`} disabled={!isReadable} onClick={() => play(run.path)}>
        <span class="run-title">{title}</span>
        {differs && <span class="differs">{differs}</span>}
        <span class="run-numbers">
          <span class={`verdict-word ${state}`}>
            <span aria-hidden="true">{sign}</span> {word}
          </span>
          {numbers(run).map(([label, value, unit]) => (
            <span key={unit} class="numbers">
              {label && <span class="soft">{label} </span>}
              {value} <span class="soft">{unit}</span>
            </span>
          ))}
        </span>
      </button>
    </li>
  );
}

export function Runs({ view, play }: { view: ProjectView; play: (path: string) => void }) {
  const runs = [...view.runs].sort((a, b) => (b.created ?? "").localeCompare(a.created ?? ""));
  if (runs.length === 0) return null;
  const named = differences(runs);
  const chosen = ticked.value.length;
  return (
    <Section title="Runs" count={runs.length}>
      <ul>
        {runs.map((run, place) => (
          <Run key={run.path} run={run} title={named[place]![0]} differs={named[place]![1]} play={play} />
        ))}
      </ul>
      {chosen > 1 && (
        <p class="row">
          <button class="plain" onClick={() => show("compare")}>Compare {chosen}</button>
          <button class="plain" onClick={() => (ticked.value = [])}>Untick all</button>
        </p>
      )}
    </Section>
  );
}
