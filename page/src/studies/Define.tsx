/** Define a study: tick fields, say how they are varied, which combinations, what comes out. */
import { useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { changes } from "../state/changes.ts";
import { changesInWords } from "../state/fieldWords.ts";
import { subject, told as named } from "../state/subject.ts";
import { anotherName, followDefinition, save, saving, told, toldOf } from "./asking.ts";
import {
  asChanged, change, columnName, definition, estimate, expressions, fields, fileOf, fixed, isCounted, leave, name, outputs, varied, vary, way, withChanges,
  type How, type Varied,
} from "./defining.ts";
import { Combinations } from "./Combinations.tsx";
import { capital } from "./columns.ts";
import { ErrorAt, errorAt } from "./ErrorAt.tsx";
import { face } from "./vary.ts";

function FieldList() {
  const search = useSignal("");
  const given = withChanges.value ? changes.value : {};
  const all = (fields.value?.fields ?? []).map((own) => asChanged(own, given[own.field]));
  const words = search.value.toLowerCase().split(/\s+/).filter(Boolean);
  const found = all.filter((own) => words.every((word) => `${own.group} ${own.label} ${own.field}`.toLowerCase().includes(word)));
  return (
    <fieldset class="fields">
      <legend>What is varied</legend>
      <input type="search" aria-label="Search fields" placeholder={`Search ${all.length} fields: tension, mass, speed …`} value={search.value}
        onInput={(event) => (search.value = event.currentTarget.value)} />
      <ul>
        {found.map((own) => (
          <li key={own.field}>
            <label title={`${own.field}. ${own.description}${own.limits ? ` Limits: ${own.limits}.` : ""}`}>
              <input type="checkbox" checked={varied.value.some(({ field }) => field === own.field)}
                onChange={(event) => (event.currentTarget.checked ? vary(own) : leave(own.field))} />
              <span>{own.group}: {own.label.toLowerCase()}</span>
              <span class="typed">{own.typed}</span>
            </label>
          </li>
        ))}
        {found.length === 0 && <li class="soft">No field has these words.</li>}
      </ul>
    </fieldset>
  );
}

function OneVaried({ own }: { own: Varied }) {
  const isWhole = isCounted(way.value);
  const isWrong = errorAt("variables", own.name) !== null;
  const typed = (part: "low" | "high" | "mean" | "deviation" | "values", label: string) => (
    <label>
      {label}{" "}
      <input value={own[part]} aria-invalid={isWrong} size={part === "values" ? 22 : 8} onInput={(event) => change(own.field, { [part]: event.currentTarget.value })} />
    </label>
  );
  return (
    <li class="varied">
      <span class="title">
        <input class="name" aria-label={`Name of ${own.field}`} value={own.name} size={14}
          onChange={(event) => change(own.field, { name: columnName(event.currentTarget.value, varied.peek().filter((one) => one !== own).map((one) => one.name)) })} />
        <code>{own.field}</code>
        <button aria-label={`Do not vary ${own.name}`} onClick={() => leave(own.field)}>×</button>
      </span>
      <span class="how">
        <select aria-label={`How ${own.name} is varied`} value={own.how} onChange={(event) => change(own.field, { how: event.currentTarget.value as How })}>
          <option value="range">range</option>
          <option value="values">values</option>
          {isWhole && <option value="normal">normal distribution</option>}
        </select>
        {own.how === "values" ? typed("values", "apart by commas") : own.how === "normal" && isWhole ? (
          <>{typed("mean", "mean")}{typed("deviation", "standard deviation")}</>
        ) : (
          <>
            {typed("low", "from")}{typed("high", "to")}
            {!isWhole && (
              <label>
                values{" "}
                <input type="number" min={2} max={1000} value={own.count} onChange={(event) => change(own.field, { count: Math.max(2, Math.round(event.currentTarget.valueAsNumber) || 2) })} />
              </label>
            )}
          </>
        )}
        <span class="unit">{own.unit}</span>
      </span>
      <ErrorAt place={["variables", own.name]} />
    </li>
  );
}

function Outputs() {
  const tick = (key: string, on: boolean) => (outputs.value = on ? [...outputs.peek(), key] : outputs.peek().filter((one) => one !== key));
  const own = useSignal("");
  const add = () => {
    const [, given, expression] = /^\s*(?:(\w+)\s*[:=])?\s*(.+?)\s*$/.exec(own.value) ?? [];
    if (!expression) return;
    expressions.value = [...expressions.peek(), { name: given ?? columnName(expression, expressions.peek().map((one) => one.name)), expression }];
    own.value = "";
  };
  return (
    <fieldset class="outputs">
      <legend>What comes out</legend>
      {(fields.value?.outputs ?? []).map(({ key, label, unit }) => (
        <label key={key} title={key}>
          <input type="checkbox" checked={outputs.value.includes(key)} onChange={(event) => tick(key, event.currentTarget.checked)} />{" "}
          {capital(label)}{unit && `, ${unit}`}
        </label>
      ))}
      {expressions.value.map((one) => (
        <span key={one.name} class="expression">
          <code>{one.name}: {one.expression}</code>
          <button aria-label={`Remove ${one.name}`} onClick={() => (expressions.value = expressions.peek().filter((other) => other !== one))}>×</button>
        </span>
      ))}
      <span class="expression">
        <input aria-label="Expression of an output" placeholder="ratio: std_force_N / mean_force_N" value={own.value} size={30}
          onInput={(event) => (own.value = event.currentTarget.value)} onKeyDown={(event) => event.key === "Enter" && add()} />
        <button onClick={add} disabled={!own.value.trim()}>Add</button>
      </span>
      <ErrorAt place={["outputs"]} />
    </fieldset>
  );
}

function Verdict() {
  const found = told.value;
  const list = fields.value;
  if (!definition.value || !found || !list) return <p class="soft" role="status">Tick at least one field and one output.</p>;
  const [error] = found.errors;
  if (error) {
    return PLACES.some((place) => errorAt(...place) !== null)
      ? <p class="soft" role="status">What is wrong stands above, where it is.</p>
      : <p class="problem" role="status">{error.text}</p>;
  }
  return (
    <p role="status">
      <strong>{found.count} variants</strong>, {estimate(found.count ?? 0, list)}.
      {found.begun === "other" && ` The study ${name.value.trim()} was begun with other values: it stays as it is.`}
      {found.begun === null && found.changes && ` The file ${fileOf(name.value)} is there already, and will be changed.`}
    </p>
  );
}

/** Where the form has a place for errors. */
const PLACES = [["set"], ["variables"], ["design"], ["outputs"], ["name"]];

/** What the buttons do with a name that is taken. */
function words(): [start: string, only: string] {
  const found = told.value;
  if (found?.begun === "other") {
    const free = anotherName(name.value);
    return [`Save as ${free} and start`, `Save as ${free} only`];
  }
  if (found?.begun === "same") return ["Go on with it", "Save only"];
  return found?.changes ? ["Change the file and start", "Change the file only"] : ["Save and start", "Save only"];
}

/** What the run bar changes: a row is that of a run only where the study has it, too. */
function OfRunBar() {
  const all = Object.entries(fixed.value);
  if (all.length === 0) return <ErrorAt place={["set"]} />;
  return (
    <div class="bar">
      <label>
        <input type="checkbox" checked={withChanges.value} onChange={(event) => (withChanges.value = event.currentTarget.checked)} />{" "}
        With the changes of the run bar: {changesInWords(all)}
      </label>
      {!withChanges.value && <span class="soft">All variants have the values of the file here.</span>}
      <ErrorAt place={["set"]} />
    </div>
  );
}

export function Define() {
  useEffect(followDefinition, []);
  if (subject.value === null) return <p class="empty">Choose a scenario on the left: a study varies its fields.</p>;
  if (!fields.value) return <p class="empty">Reading the fields of {named(subject.value)} …</p>;
  // What the buttons say is of what stands there now.
  const isTold = definition.value !== null && toldOf.value === definition.value;
  const ready = isTold && told.value?.errors.length === 0 && !saving.value;
  const start = () => void save(true).then((isSaved) => isSaved && (face.value = "watch"));
  const [begin, only] = words();
  return (
    <div class="define">
      <div class="bar">
        <label>Name <input value={name.value} onInput={(event) => (name.value = event.currentTarget.value)} /></label>
        <ErrorAt place={["name"]} />
        <span class="soft">Scenario: {named(subject.value)}</span>
      </div>
      <OfRunBar />
      <div class="halves">
        <FieldList />
        <div>
          <ul class="chosen">{varied.value.map((own) => <OneVaried key={own.field} own={own} />)}</ul>
          <Combinations />
          <Outputs />
          <Verdict />
          <div class="bar">
            <button class="main" disabled={!ready} onClick={start}>{begin}</button>
            <button disabled={!ready} onClick={() => void save(false)}>{only}</button>
          </div>
          {told.value && (
            <details>
              <summary>The study file</summary>
              <pre>{told.value.text}</pre>
            </details>
          )}
        </div>
      </div>
    </div>
  );
}
