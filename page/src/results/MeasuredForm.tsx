/** What a measured file does not say, in a small form, and its numbers alone as `arcless assess` has them. */
import { useSignal } from "@preact/signals";
import type { Complaint } from "../connection/http.ts";
import { below } from "../state/project.ts";
import { useAnswer } from "./answer.ts";
import { askMeasurement } from "./asking.ts";
import { chosenMeasured, give, givenOf, type MeasuredAs } from "./measuredAs.ts";
import { CriterionRow, Numbers } from "./Results.tsx";
import type { Criterion, NumberRow } from "./told.ts";

export interface Alone {
  supplies: string[];
  /** Why it cannot be read as it is; then there is nothing else but the supplies. */
  refused?: Complaint;
  name: string;
  about: string;
  pantographs: string[];
  numbers: NumberRow[];
  criteria: Criterion[];
  notes: string[];
}

const FIELDS: [keyof MeasuredAs, string, string][] = [
  ["speed", "Speed, where the file has none", "250 km/h"],
  ["head_mass", "Mass above the force sensors", "5.2 kg"],
  ["head_lift", "Lift of the air above them", "8 N, or 0.002 N/(m/s)2"],
];

function Assessed({ of }: { of: Alone }) {
  return (
    <details>
      <summary>Assessed alone</summary>
      <p class="soft">{of.about}</p>
      <Numbers rows={of.numbers} names={of.pantographs} title={`Numbers of ${of.name}`} />
      <div class="wide" tabIndex={0} role="region" aria-label={`Criteria of ${of.name}`}>
        <table>
          <caption>Criteria of {of.name}</caption>
          <thead>
            <tr>
              {["criterion", "of", "value", "limit", "unit", "verdict", "source (mark)"].map((title) => (
                <th key={title} scope="col">{title}</th>
              ))}
            </tr>
          </thead>
          <tbody>{of.criteria.map((one, k) => <CriterionRow key={k} one={one} />)}</tbody>
        </table>
      </div>
      <ul>{of.notes.map((text) => <li key={text}>{text}</li>)}</ul>
    </details>
  );
}

export function MeasuredForm({ path, name }: { path: string; name: string }) {
  const given = givenOf(path);
  const typed = useSignal<MeasuredAs>(given);
  const { value } = useAnswer(`${path} ${JSON.stringify(given)}`, (signal) => askMeasurement(path, given, signal)).value;
  const put = (part: keyof MeasuredAs) => (event: { currentTarget: { value: string } }) =>
    void (typed.value = { ...typed.peek(), [part]: event.currentTarget.value });
  const isOpen = chosenMeasured.value === path || value?.refused !== undefined;
  return (
    <details class="measured-form" open={isOpen}>
      <summary>How {name} was measured</summary>
      <form
        onSubmit={(event) => {
          event.preventDefault();
          chosenMeasured.value = path;
          give(path, typed.peek());
        }}
      >
        {FIELDS.map(([part, label, such]) => (
          <label key={part}>
            {label} <input size={14} value={typed.value[part]} placeholder={such} onInput={put(part)} />
          </label>
        ))}
        <label>
          Supply{" "}
          <select value={typed.value.supply} onChange={put("supply")}>
            <option value="">not given</option>
            {(value?.supplies ?? []).map((one) => (
              <option key={one} value={one}>{one}</option>
            ))}
          </select>
        </label>
        <button type="submit">Apply</button>
      </form>
      {value?.refused && <p class="problem" role="alert">{below(value.refused.text)}</p>}
      <p class="soft">
        Bare numbers are km/h, kg and N. The mass takes the inertia of what is above the sensors off their force. The
        supply decides limits of the measurement alone; in a comparison they are those of the run's line.
      </p>
      {value && !value.refused && <Assessed of={value} />}
    </details>
  );
}
