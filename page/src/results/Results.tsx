/** Results of a run: verdict with certainty, criteria, numbers, and all figures of its report. */
import { FigureSections } from "./FigureSections.tsx";
import { useAnswer } from "./answer.ts";
import { askFigure, askRun } from "./asking.ts";
import { NoRun } from "./RunList.tsx";
import { Refusal, Waiting } from "./State.tsx";
import type { Assessed, Criterion, NumberRow } from "./told.ts";
import { shownRun, versionOf } from "./which.ts";
import "./results.css";

const file = (run: string, as: string) => `api/export?${new URLSearchParams({ run, as })}`;
const report = (run: string) => `api/run/report?${new URLSearchParams({ path: run })}`;

function Verdict({ of }: { of: Assessed }) {
  const { verdict } = of;
  return (
    <section class={`result-verdict ${verdict.state}`} aria-label="Verdict">
      <p class="result-headline">
        <span aria-hidden="true">{verdict.sign}</span> {verdict.text}
      </p>
      {verdict.rest && <p>{verdict.rest}</p>}
      <p>{of.judged_on}</p>
      {verdict.items.length > 0 && (
        <ul>
          {verdict.items.map((item) => (
            <li key={item}>{item}</li>
          ))}
        </ul>
      )}
      <p class="soft">
        {of.certainty ? "± is the certainty of a number, found by further runs." : "Uncertainty was not computed; tick Certainty in the options of the run to compute it."}
      </p>
    </section>
  );
}

export function CriterionRow({ one }: { one: Criterion }) {
  return (
    <tr>
      <th scope="row">{one.title}</th>
      <td>{one.pantograph || "run"}</td>
      <td class="number">{one.value}</td>
      <td class="number">{one.limit}</td>
      <td>{one.unit}</td>
      <td class={`state ${one.state.replaceAll(" ", "-")}`}>
        {one.verdict}
        {one.reason && <small> {one.reason}</small>}
      </td>
      <td>
        {one.source} <abbr title={`mark ${one.mark}`}>({one.mark})</abbr>
        {one.note && <small> {one.note}</small>}
      </td>
    </tr>
  );
}

function Criteria({ of }: { of: Assessed }) {
  return (
    <section aria-labelledby="criteria">
      <h3 id="criteria">Criteria</h3>
      <div class="wide" tabIndex={0} role="region" aria-label="Table of criteria">
        <table>
          <thead>
            <tr>
              {["criterion", "of", "value", "limit", "unit", "verdict", "source (mark)"].map((title) => (
                <th key={title} scope="col" class={title === "value" || title === "limit" ? "number" : ""}>
                  {title}
                </th>
              ))}
            </tr>
          </thead>
          <tbody>
            {of.criteria.map((one, k) => (
              <CriterionRow key={k} one={one} />
            ))}
          </tbody>
        </table>
      </div>
      <p class="soft">
        {of.marks_mean} {Object.entries(of.marks).map(([mark, meaning]) => `${mark}: ${meaning}`).join("; ")}.
      </p>
    </section>
  );
}

export function Numbers({ rows, names, title }: { rows: NumberRow[]; names: string[]; title: string }) {
  const id = `numbers-${title.replaceAll(" ", "-")}`;
  return (
    <div class="wide" tabIndex={0} role="region" aria-labelledby={id}>
      <table>
        <caption id={id}>{title}</caption>
        <thead>
          <tr>
            <th scope="col">quantity</th>
            {names.map((name) => (
              <th key={name} scope="col" class="number">
                {name}
              </th>
            ))}
            <th scope="col">unit</th>
          </tr>
        </thead>
        <tbody>
          {rows.map(([label, unit, values]) => (
            <tr key={label}>
              <th scope="row">{label}</th>
              {values.length === names.length ? (
                values.map((value, k) => (
                  <td key={k} class="number">
                    {value}
                  </td>
                ))
              ) : (
                <td class="number" colSpan={names.length}>
                  {values[0]}
                </td>
              )}
              <td>{unit}</td>
            </tr>
          ))}
        </tbody>
      </table>
    </div>
  );
}

function Remarks({ of }: { of: Assessed }) {
  const all = [
    ...(of.stopped_m === null ? [] : [`The run stopped early, at ${of.stopped_m.toFixed(1)} m: the numbers are of the part before it.`]),
    ...(of.other_version ? [`The run was computed by Arcless ${of.version}, which is another version than this one.`] : []),
    ...of.notes,
    ...of.warnings,
  ];
  if (!all.length) return null;
  return (
    <ul class="remarks" aria-label="Remarks">
      {all.map((text) => (
        <li key={text}>{text}</li>
      ))}
    </ul>
  );
}

export function Results() {
  const run = shownRun.value;
  const version = run === null ? "" : versionOf([run]);
  const { value, waiting, complaint } = useAnswer(run === null ? null : version, (signal) => askRun(run!, signal)).value;
  if (run === null) return <NoRun then="its verdict, criteria, numbers and figures stand here." />;
  if (complaint) return <Refusal complaint={complaint} what={`The run ${run} cannot be shown`} />;
  if (waiting || !value) return <Waiting what={run} />;
  return (
    <article class="results">
      <header>
        <h2>{value.title}</h2>
        <p class="identity">{value.identity.map(([label, text]) => `${label}: ${text}`).join(" · ")}</p>
        <nav aria-label="Files of this run">
          {value.report && (
            <a href={report(run)} target="_blank" rel="noopener">
              Open report
            </a>
          )}
          <a href={file(run, "pdf")}>Report as PDF</a>
          <a href={file(run, "csv")}>Channels as CSV</a>
          <a href={file(run, "xlsx")}>Tables as Excel</a>
        </nav>
      </header>
      <Verdict of={value} />
      <p>{value.worst.charAt(0).toUpperCase() + value.worst.slice(1)}</p>
      <Remarks of={value} />
      <Criteria of={value} />
      <section aria-labelledby="numbers">
        <h3 id="numbers">Numbers</h3>
        <Numbers rows={value.numbers[0]} names={value.pantographs} title="Contact forces" />
        <Numbers rows={value.numbers[1]} names={value.pantographs} title="Other quantities" />
        <p class="soft">{value.numbers_of}</p>
      </section>
      <FigureSections sections={value.sections} version={version} ask={(key, shown, signal) => askFigure(run, key, shown, signal)} />
    </article>
  );
}
