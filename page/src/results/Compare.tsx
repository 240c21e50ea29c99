/** Ticked runs and measurements side by side: what differs, verdicts, numbers, overlays. */
import { colour, scheme } from "../charts/colours.ts";
import { fieldWords } from "../state/fieldWords.ts";
import { project } from "../state/project.ts";
import { ticked } from "../state/selection.ts";
import { Acceptance, Bands, Placement } from "./MeasuredTables.tsx";
import { useAnswer } from "./answer.ts";
import { askComparison, askOverlay, type Compares } from "./asking.ts";
import { FigureSections } from "./FigureSections.tsx";
import { held, take } from "./measured.ts";
import { givenAmong } from "./measuredAs.ts";
import { MeasuredForm } from "./MeasuredForm.tsx";
import { namesOf, ordered } from "./named.ts";
import { RowHead } from "./RowHead.tsx";
import { RunList } from "./RunList.tsx";
import { Nothing, Refusal, Waiting } from "./State.tsx";
import type { Compared, Comparison } from "./told.ts";
import { baseline, versionOf } from "./which.ts";
import "./results.css";

function AddMeasured() {
  return (
    <p class={held.value ? "drop held" : "drop"}>
      <label>
        Add a measurement, or drop a CSV file anywhere:{" "}
        <input
          type="file"
          accept=".csv,.tsv,.txt,.dat,.asc"
          multiple
          onChange={(event) => void take(event.currentTarget.files ?? [])}
        />
      </label>
    </p>
  );
}

/** A column for each run, its colour above it. */
function Heads({ of, first }: { of: Comparison; first: string }) {
  void scheme.value;
  return (
    <thead>
      <tr>
        <th scope="col">{first}</th>
        {of.names.map((name, k) => (
          <th key={k} scope="col" class="number">
            <span class="swatch" style={{ background: colour(of.colours[k] ?? "ink") }} />
            {name}
          </th>
        ))}
      </tr>
    </thead>
  );
}

/** What differs between the runs, and nothing else. */
function Differences({ of }: { of: Comparison }) {
  if (of.simulated < 2) return null;
  if (!of.fields.length) return <p>{of.same}</p>;
  return (
    <div class="wide" tabIndex={0} role="region" aria-label="What differs">
      <table>
        <caption>What differs</caption>
        <Heads of={of} first="field" />
        <tbody>
          {of.fields.map((one) => (
            <tr key={one.path}>
              <th scope="row" title={one.path}>{fieldWords(one.path)}</th>
              {one.values.map((value, k) => (
                <td key={k} class="number">
                  {value ?? "–"}
                </td>
              ))}
            </tr>
          ))}
        </tbody>
      </table>
      <p class="soft">{of.left_out}</p>
    </div>
  );
}

function Numbers({ of, rows, title }: { of: Comparison; rows: Compared[]; title: string }) {
  return (
    <div class="wide" tabIndex={0} role="region" aria-label={title}>
      <table>
        <caption>{title}</caption>
        <Heads of={of} first="quantity" />
        <tbody>
          {rows.map((one, row) => (
            <tr key={row}>
              <RowHead of={of} row={one} label={one.label} />
              {one.cells.map(([value, difference], k) => (
                <td key={k} class="number">
                  {value}
                  {difference && <span class="difference">{difference}</span>}
                </td>
              ))}
            </tr>
          ))}
        </tbody>
      </table>
    </div>
  );
}

function Verdicts({ of }: { of: Comparison }) {
  return (
    <div class="wide" tabIndex={0} role="region" aria-label="Criteria">
      <table>
        <caption>Criteria</caption>
        <Heads of={of} first="criterion" />
        <tbody>
          {of.verdicts.map((one, row) => (
            <tr key={row}>
              <RowHead of={of} row={one} label={one.title} />
              {one.cells.map(([word, state, limit], k) => (
                <td key={k} class="number">
                  <span class={`state ${state.replaceAll(" ", "-")}`}>{word}</span>
                  <span class="difference">{limit}</span>
                </td>
              ))}
            </tr>
          ))}
        </tbody>
      </table>
    </div>
  );
}

/** Whether a difference has an uncertainty beside it. */
const isSure = ({ main }: Comparison): boolean => main.some(({ cells }) => cells.some((texts) => texts.some((text) => text.includes("±"))));
/** Which run the others are compared with. */
function Baseline({ what }: { what: Compares }) {
  return (
    <p>
      <label>
        Compared with{" "}
        <select value={what.subjects[0]} onChange={(event) => (baseline.value = event.currentTarget.value)}>
          {what.subjects.map((path, k) => (
            <option key={path} value={path}>
              {what.names[k]}
            </option>
          ))}
        </select>
      </label>
    </p>
  );
}

/** A form for each measurement that is ticked. */
function Measurements({ what }: { what: Compares }) {
  const measured = new Set(project.value?.measured.map((one) => one.path));
  return (
    <>
      {what.subjects.map((path, k) => measured.has(path) && <MeasuredForm key={path} path={path} name={what.names[k] ?? path} />)}
    </>
  );
}

function asked(paths: string[]): Compares {
  const view = project.value ?? { runs: [], measured: [] };
  const subjects = ordered(paths, baseline.value, view);
  const names = namesOf(view);
  return { subjects, names: subjects.map((path) => names.get(path) ?? path), measured: givenAmong(subjects) };
}

export function Compare() {
  const what = asked(ticked.value);
  const { subjects } = what;
  const version = `${versionOf(subjects)}\n${JSON.stringify(what)}`;
  const enough = subjects.length > 1;
  const { value, waiting, complaint } = useAnswer(enough ? version : null, (signal) => askComparison(what, signal)).value;
  if (!enough) {
    return (
      <Nothing>
        <p>{subjects.length ? "One run or measurement is ticked." : "Nothing is ticked."} Tick at least two; they are compared with the oldest run, or with another one that you choose.</p>
        <RunList measured />
        <AddMeasured />
        <Measurements what={what} />
      </Nothing>
    );
  }
  if (complaint) {
    return (
      <>
        <Refusal complaint={complaint} what="What is ticked cannot be compared" />
        <Measurements what={what} />
        <AddMeasured />
      </>
    );
  }
  if (waiting || !value) return <Waiting what={`${subjects.length} runs`} />;
  return (
    <article class="results">
      <h2>
        {value.title}, compared with {value.names[0]}
      </h2>
      <Baseline what={what} />
      <AddMeasured />
      <Measurements what={what} />
      {value.changes.map((text) => (
        <p key={text} class="change">
          {text}
        </p>
      ))}
      {value.warnings.length > 0 && (
        <ul class="remarks" aria-label="Remarks">
          {value.warnings.map((text) => (
            <li key={text}>{text}</li>
          ))}
        </ul>
      )}
      <Differences of={value} />
      <Placement of={value} />
      <Numbers of={value} rows={value.main} title="Main numbers" />
      <p class="soft">{value.differences_read}{isSure(value) && " Smaller than their ± they are too close to tell."}</p>
      <Verdicts of={value} />
      <Acceptance of={value} />
      <FigureSections
        sections={value.sections}
        version={version}
        opens={value.section_m}
        ask={(key, shown, signal) => askOverlay(what, key, shown, signal)}
      />
      <Bands of={value} />
      <details>
        <summary>All numbers</summary>
        <Numbers of={value} rows={value.numbers} title="All numbers" />
      </details>
    </article>
  );
}
