/** Watch a study: how far it is, its rows as table, parallel coordinates and scatter, and what to do with a row. */
import { useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { ask } from "../connection/http.ts";
import { complain, say } from "../shell/messages.ts";
import { show } from "../shell/panels.ts";
import { openModel } from "../state/opening.ts";
import { project, readProject } from "../state/project.ts";
import { source } from "../state/selection.ts";
import { run } from "./asking.ts";
import { errorOf, statusOf, variantOf } from "./columns.ts";
import { about, count, current, follow, openStudy, picked, progress, rows } from "./open.ts";
import { Parallel } from "./Parallel.tsx";
import { Scatter } from "./Scatter.tsx";
import { axes, brushes, colouredBy, columns, isJudged, onlyMet, places, search } from "./selection.ts";
import { Table, Verdict } from "./Table.tsx";
import { verdictOf } from "./verdicts.ts";
import { opening } from "./vary.ts";

/** The file of the study that is open, where it is in this folder. */
const fileNow = () => project.value?.models.find((model) => model.kind === "study" && model.name === about.value?.name)?.path ?? null;

const act = (what: Promise<unknown>) => void what.catch(complain);

/** Seconds in words. */
const time = (s: number) => (s < 90 ? `${Math.round(s)} s` : s < 5400 ? `${Math.round(s / 60)} min` : `${(s / 3600).toFixed(1)} h`);

function State() {
  const now = progress.value;
  const path = current.value!;
  const from = fileNow();
  if (!now) return <p role="status">Reading the study …</p>;
  const counts = Object.entries(now.counts).map(([state, number]) => `${number} ${state}`).join(", ");
  const left = now.running && now.there > 0 && now.missing ? (now.wall_time_s / now.there) * now.missing / (navigator.hardwareConcurrency || 1) : null;
  return (
    <div class="bar state">
      <progress aria-label="Variants that are there" max={now.total ?? 1} value={now.total ? now.there : 0} />
      <span role="status">
        {now.total === null ? "Starting" : `${now.there} of ${now.total} variants`}
        {counts && ` (${counts})`}
        {now.running ? ", being computed" : ""}
        {left !== null && `, about ${time(left)} more, an estimate`}
      </span>
      {now.running && now.own && <button onClick={() => act(ask("studies/stop", { body: { path } }))}>Stop</button>}
      {!now.running && now.total !== null && now.there < now.total && from && (
        <button onClick={() => act(run(from, { resume: true }))}>Go on</button>
      )}
      {!now.running && (now.counts["failed"] ?? 0) > 0 && from && (
        <button onClick={() => act(run(from, { resume: true, retry_failed: true }))}>Compute failed ones again</button>
      )}
      {now.there > 0 && <a href={`api/studies/report?path=${encodeURIComponent(path)}`} target="_blank" rel="noopener">Report</a>}
      {now.error && <p class="problem">{now.error}</p>}
    </div>
  );
}

function Picked() {
  // Read before the rows, which may be none at first: what is picked later is seen then, too.
  const chosen = count.value > 0 ? picked.value : null;
  const row = rows.find((one) => variantOf(one) === chosen);
  const path = current.value!;
  if (!row) return <p class="soft">Click a line, a point or a row: it is picked everywhere. In the table, ↑ and ↓ pick.</p>;
  const number = variantOf(row);
  const written = async () => {
    const answer = await ask<{ path: string }>("studies/scenario", { body: { path, variant: number, name: `${about.peek()!.name}-${number}` } });
    await readProject();
    return answer.path;
  };
  const open = async () => {
    const made = await written();
    openModel(made, "scenario");
    say("note", `Variant ${number} is the scenario ${made}.`);
  };
  const start = async () => {
    const made = await written();
    openModel(made, "scenario");
    const { job } = await ask<{ job: { id: string } }>("runs", { body: { scenario: made, changes: {}, record_motion: true, certainty: false, keep_both: true } });
    source.value = { job: job.id };
    show("drawing");
  };
  return (
    <div class="bar picked" role="group" aria-label="Picked variant">
      <strong>Variant {number}</strong>
      {isJudged.value && <Verdict word={verdictOf(row)} isWord />}
      {columns.value.map((column) => (
        <span key={column.name}>{column.label} <b>{column.text(row) || "–"}</b> {column.unit}</span>
      ))}
      {statusOf(row) !== "done" && <span class="problem">{statusOf(row)}: {errorOf(row)}</span>}
      {statusOf(row) !== "invalid" && (
        <>
          <button onClick={() => act(open())}>Open as scenario</button>
          <button onClick={() => act(start())}>Run with motion</button>
        </>
      )}
    </div>
  );
}

function Failed() {
  void count.value;
  const bad = rows.filter((row) => errorOf(row) !== "");
  if (!bad.length) return null;
  return (
    <details class="failed">
      <summary>{bad.length} variants with a value missing, and why</summary>
      <ul>
        {bad.slice(0, MOST_TOLD).map((row) => (
          <li key={variantOf(row)}>
            <button class="plain" onClick={() => (picked.value = variantOf(row))}>Variant {variantOf(row)}, {statusOf(row)}</button>: {errorOf(row)}
          </li>
        ))}
        {bad.length > MOST_TOLD && <li>and {bad.length - MOST_TOLD} more, in the table</li>}
      </ul>
    </details>
  );
}

/** Sentences that are listed; more are read in the table. */
const MOST_TOLD = 50;

function Views() {
  const scatter = useSignal(false);
  const unknown = progress.value?.not_judged ?? [];
  const isFiltered = Object.keys(brushes.value).length > 0 || search.value !== "" || onlyMet.value;
  return (
    <>
      <div class="bar">
        <label>
          Colour by{" "}
          <select value={colouredBy.value ?? ""} onChange={(event) => (colouredBy.value = event.currentTarget.value || null)}>
            <option value="">one colour</option>
            {axes.value.map(({ name, label }) => <option key={name} value={name}>{label}</option>)}
          </select>
        </label>
        <label>
          <input type="checkbox" checked={scatter.value} onChange={(event) => (scatter.value = event.currentTarget.checked)} /> Two columns
        </label>
        {isJudged.value && (
          <label>
            <input type="checkbox" checked={onlyMet.value} onChange={(event) => (onlyMet.value = event.currentTarget.checked)} /> Only met
          </label>
        )}
        <input type="search" aria-label="Filter rows" placeholder="Variant, state, or words of an error" value={search.value}
          onInput={(event) => (search.value = event.currentTarget.value)} />
        <span class="soft" role="status">{places.value.length} of {count.value} rows</span>
        {isFiltered && <button onClick={() => ((brushes.value = {}), (search.value = ""), (onlyMet.value = false))}>Show all</button>}
      </div>
      <Picked />
      {scatter.value ? <Scatter /> : <Parallel />}
      <Table />
      {isJudged.value && unknown.length > 0 && (
        <p class="soft">Not judged, as no output of this study has them: {unknown.join("; ")}. Add the output “All limits met” to judge all.</p>
      )}
      <Failed />
    </>
  );
}

function Choice() {
  const files = project.value?.models.filter(({ kind }) => kind === "study") ?? [];
  const begun = project.value?.studies ?? [];
  return (
    <div class="choice">
      {begun.length > 0 && <h3>Studies that were begun</h3>}
      <ul>
        {begun.map((one) => (
          <li key={one.path}>
            <button onClick={() => openStudy(one.path)}>{one.name}</button>{" "}
            <span class="soft">{one.done}{one.planned === null ? "" : ` of ${one.planned}`} variants</span>
          </li>
        ))}
      </ul>
      {files.length > 0 && <h3>Study files</h3>}
      <ul>
        {files.map((one) => (
          <li key={one.path}>
            {one.name} <button onClick={() => act(run(one.path))}>Start</button>{" "}
            <button onClick={() => act(run(one.path, { resume: true }))}>Go on</button> <span class="soft">{one.description}</span>
          </li>
        ))}
      </ul>
      {!files.length && !begun.length && <p class="empty">There is no study yet. Define one.</p>}
    </div>
  );
}

export function Watch() {
  useEffect(() => {
    const end = opening.subscribe((path) => {
      if (path === null) return;
      opening.value = null;
      openStudy(path);
    });
    const last = follow();
    return () => (end(), last());
  }, []);
  if (current.value === null) return <Choice />;
  return (
    <div class="watch">
      <div class="bar">
        <button onClick={() => openStudy(null)}>All studies</button>
        <strong>{about.value?.name ?? current.value}</strong>
        {about.value?.description && <span class="soft">{about.value.description}</span>}
      </div>
      <State />
      {about.value && <Views />}
    </div>
  );
}
