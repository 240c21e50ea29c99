/** The bar at the top: scenario, speed, pantographs, run, its progress, the verdict. */
import { useSignal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { change, changes } from "../state/changes.ts";
import { changesInWords } from "../state/fieldWords.ts";
import { cancel } from "../state/jobs.ts";
import { openModel } from "../state/opening.ts";
import { project } from "../state/project.ts";
import { file, scenario, source } from "../state/selection.ts";
import { complain, messages, worstOf } from "../shell/messages.ts";
import { fold, folded } from "../shell/layout.ts";
import { dialog, listed } from "../shell/window.ts";
import { canRun, isWatched, nameOf, obstacle, run, runningJob, saveAsScenario, withCertainty, withMotion } from "./running.ts";
import { fields } from "./scenarioFields.ts";
import { refused, typeSpeed } from "./speed.ts";
import { isPart } from "./standing.ts";
import { Verdict } from "./Verdict.tsx";

function Scenario() {
  const view = project.value;
  const own = view?.models.filter((one) => one.kind === "scenario") ?? [];
  const shipped = view?.library.filter((one) => one.kind === "scenario") ?? [];
  // Just written: the list has it at its next look.
  const isNew = scenario.value !== null && ![...own, ...shipped].some(({ path }) => path === scenario.value);
  return (
    <label class="scenario">
      <span>Scenario</span>
      <select
        title={scenario.value === null ? "" : nameOf(scenario.value)}
        value={scenario.value ?? ""}
        onChange={(event) => {
          if (event.currentTarget.value) openModel(event.currentTarget.value, "scenario");
        }}
      >
        {scenario.value === null && <option value="">Choose one</option>}
        {isNew && <option value={scenario.value!}>{nameOf(scenario.value!)}</option>}
        {own.length > 0 && (
          <optgroup label="In this folder">
            {own.map((one) => <option key={one.path} value={one.path}>{one.name}</option>)}
          </optgroup>
        )}
        <optgroup label="Shipped">
          {shipped.map((one) => <option key={one.path} value={one.path}>{one.name}</option>)}
        </optgroup>
      </select>
    </label>
  );
}

function Speed() {
  const of = fields.value;
  if (of?.speed == null) return null;
  const { path, speed, speedField } = of;
  const now = String(changes.value["speed"] ?? speed);
  const wrong = refused.value;
  return (
    <label>
      <span>Speed</span>
      <input
        class={`speed ${now === speed ? "" : "changed"}`}
        key={path}
        value={wrong?.typed ?? now}
        title={`In the file: ${speed}`}
        spellcheck={false}
        autocomplete="off"
        aria-invalid={wrong !== null}
        aria-describedby={wrong ? "speed-problem" : undefined}
        onChange={(event) => void typeSpeed(event.currentTarget.value, { path, speed, speedField })}
        onKeyDown={(event) => {
          if (event.key !== "Escape") return;
          event.currentTarget.value = now;
          refused.value = null;
        }}
      />
    </label>
  );
}

function Pantographs() {
  const ofFile = fields.value?.pantographs ?? [];
  const view = project.value;
  if (ofFile.length === 0 || !view) return null;
  const known = [...view.models, ...view.library].filter((one) => one.kind === "pantograph");
  const value = (path: string, name: string) => (path.startsWith("shipped:") ? name : path);
  return (
    <>
      {ofFile.map((model, place) => {
        const field = `pantographs.${place}.model`;
        const now = String(changes.value[field] ?? model);
        const options = new Map(known.map((one) => [value(one.path, one.name), one.name]));
        if (!options.has(model)) options.set(model, model.replace(/\.[a-z]+$/, ""));
        return (
          <label key={field}>
            <span>{ofFile.length > 1 ? `Pantograph ${place + 1}` : "Pantograph"}</span>
            <select class={now === model ? "" : "changed"} title={options.get(now)} value={now} onChange={(event) => change(field, event.currentTarget.value, model)}>
              {[...options].map(([path, name]) => <option key={path} value={path}>{name}</option>)}
            </select>
          </label>
        );
      })}
    </>
  );
}

function Options() {
  const box = useRef<HTMLDetailsElement>(null);
  const close = () => void (box.current && (box.current.open = false));
  useEffect(() => {
    // It lies over other controls: a press beside it takes it away.
    const press = (event: Event) => {
      if (!box.current?.contains(event.target as Node)) close();
    };
    document.addEventListener("pointerdown", press);
    return () => document.removeEventListener("pointerdown", press);
  }, []);
  return (
    <details class="options" ref={box} onKeyDown={(event) => event.key === "Escape" && close()}>
      <summary>Options</summary>
      <div class="pop">
        <label>
          <input type="checkbox" checked={withMotion.value} onChange={(event) => (withMotion.value = event.currentTarget.checked)} />
          <span>Record the motion of the wires, to play the run again</span>
        </label>
        <label>
          <input type="checkbox" checked={withCertainty.value} onChange={(event) => (withCertainty.value = event.currentTarget.checked)} />
          <span>Certainty: find the ± of the numbers by further runs</span>
        </label>
      </div>
    </details>
  );
}

function Changed() {
  const all = Object.entries(changes.value);
  const naming = useSignal(false);
  const base = scenario.value;
  if (all.length === 0 || base === null) return null;
  const save = async (event: SubmitEvent) => {
    event.preventDefault();
    const name = new FormData(event.currentTarget as HTMLFormElement).get("name");
    if (await saveAsScenario(String(name).trim())) naming.value = false;
  };
  return (
    <div class="variant" role="group" aria-label="Variant">
      <span>
        Variant of {nameOf(base)}: {changesInWords(all)}
      </span>
      {naming.value ? (
        <form onSubmit={(event) => void save(event)}>
          <input name="name" aria-label="Name of the new scenario" placeholder="Name of the new scenario" required autofocus />
          <button type="submit">Save</button>
          <button type="button" onClick={() => (naming.value = false)}>Cancel</button>
        </form>
      ) : (
        <>
          <button onClick={() => (naming.value = true)}>Save as scenario</button>
          <button onClick={() => (changes.value = {})}>Take back</button>
        </>
      )}
    </div>
  );
}

/** The file that is open, where what is changed in it changes nothing of the scenario that is run. */
function Beside() {
  const [path, chosen, view] = [file.value, scenario.value, project.value];
  const entry = [...(view?.models ?? []), ...(view?.library ?? [])].find((one) => one.path === path);
  if (!entry || chosen === null || entry.kind === "study") return null;
  if (isPart(entry.path, chosen, fields.value, changes.value, view!.models) !== false) return null;
  return (
    <p class="beside" role="status">
      The {entry.kind} that is open, {entry.name}, is no part of the scenario that is run, {nameOf(chosen)}.{" "}
      <button onClick={() => openModel(chosen, "scenario")}>Open the scenario</button>
    </p>
  );
}

function Running() {
  const job = runningJob.value;
  if (!job) return <Verdict />;
  const percent = Math.round(100 * job.fraction);
  return (
    <div class="running">
      <progress max={1} value={job.fraction} aria-label={`Progress of ${job.title}`} />
      <span class="numbers">{job.state === "waiting" ? "waiting" : `${percent} %`}</span>
      <span class="doing" title={job.doing}>{job.doing}</span>
      {!isWatched(job) && <button onClick={() => (source.value = { job: job.id })}>Watch</button>}
      <button onClick={() => void cancel(job.id).catch(complain)}>Cancel</button>
    </div>
  );
}

function Tools() {
  const count = messages.value.length;
  const level = worstOf(messages.value);
  return (
    <div class="tools">
      {(count > 0 || listed.value) && (
        <button class={level ? `counted ${level}` : ""} aria-expanded={listed.value} onClick={() => (listed.value = !listed.value)}>
          Messages {count}
        </button>
      )}
      <button onClick={() => (dialog.value = "commands")} title="All commands (Ctrl+K)">Commands</button>
      <button class="fold" aria-pressed={!folded.value.left} title="Project (Ctrl+B goes there)" onClick={() => fold("left")}>
        <span aria-hidden="true">◧</span><span class="unseen">Project</span>
      </button>
      <button class="fold" aria-pressed={!folded.value.right} title="Inspector (Ctrl+I)" onClick={() => fold("right")}>
        <span aria-hidden="true">◨</span><span class="unseen">Inspector</span>
      </button>
    </div>
  );
}

export function RunBar() {
  const isVariant = Object.keys(changes.value).length > 0;
  return (
    <>
      <div class="run-bar">
        <Scenario />
        <Speed />
        <Pantographs />
        {/* Not `disabled`, which would take the focus away from who pressed it. */}
        <button class="run" aria-disabled={!canRun.value} title={obstacle.value ?? "Ctrl+Enter"} onClick={() => canRun.peek() && void run()}>
          <span aria-hidden="true">▶</span> {isVariant ? "Run as variant" : "Run"}
        </button>
        <Options />
        <Running />
        <Tools />
      </div>
      {refused.value && (
        <div class="speed-problem">
          <span id="speed-problem" role="alert">{refused.value.why}</span>
          <button onClick={() => (refused.value = null)}>Back to the speed before</button>
        </div>
      )}
      <Changed />
      <Beside />
    </>
  );
}
