/** Which combinations are computed: all, a sample, or a search for the best with its aims. */
import { capital } from "./columns.ts";
import { ErrorAt } from "./ErrorAt.tsx";
import { aimAt, aims, expressions, isCounted, fields, NO_AIM, outputs, sample, SAMPLES, size, way, WAYS, type Aim, type Sample, type Way } from "./defining.ts";

export function Combinations() {
  return (
    <fieldset class="ways">
      <legend>Which combinations</legend>
      {Object.entries(WAYS).map(([kind, [label, about]]) => (
        <label key={kind}>
          <input type="radio" name="way" checked={way.value === kind} onChange={() => (way.value = kind as Way)} />{" "}
          {label}<span class="soft">: {about}</span>
        </label>
      ))}
      <div class="bar">
        {way.value === "sample" && (
          <label>
            Kind{" "}
            <select value={sample.value} title={SAMPLES[sample.value][1]} onChange={(event) => (sample.value = event.currentTarget.value as Sample)}>
              {Object.entries(SAMPLES).map(([kind, [label]]) => <option key={kind} value={kind}>{label}</option>)}
            </select>
          </label>
        )}
        {isCounted(way.value) && (
          <label>
            Variants{" "}
            <input type="number" min={1} max={1_000_000} value={size.value} onChange={(event) => (size.value = Math.max(1, Math.round(event.currentTarget.valueAsNumber) || 1))} />
          </label>
        )}
        {way.value === "sample" && <span class="soft">{SAMPLES[sample.value][1]}</span>}
      </div>
      {way.value === "optimise" && <Aims />}
      <ErrorAt place={["design"]} />
    </fieldset>
  );
}

/** What a search does with each output. */
function Aims() {
  const own = [
    ...(fields.value?.outputs ?? []).filter(({ key }) => outputs.value.includes(key)).map(({ key, label, unit }) => [key, capital(label) + (unit && `, ${unit}`)] as const),
    ...expressions.value.map(({ name }) => [name, name] as const),
  ];
  return (
    <ul class="aims" aria-label="Aims of the search">
      {own.map(([output, label]) => {
        const aim = aims.value[output] ?? NO_AIM;
        if (output === "passed") {
          return (
            <li key={output}>
              <label>
                <input type="checkbox" checked={aim.least !== ""} onChange={(event) => aimAt(output, { least: event.currentTarget.checked ? "1" : "" })} />{" "}
                Only variants that meet all limits count
              </label>
            </li>
          );
        }
        const typed = (part: "least" | "most", words: string) => (
          <label>
            {words} <input inputMode="decimal" size={6} value={aim[part]} aria-label={`${label}, ${words}`} onInput={(event) => aimAt(output, { [part]: event.currentTarget.value })} />
          </label>
        );
        return (
          <li key={output}>
            <span>{label}</span>
            <select aria-label={`Aim for ${label}`} value={aim.aim} onChange={(event) => aimAt(output, { aim: event.currentTarget.value as Aim["aim"] })}>
              <option value="">no aim</option>
              <option value="minimise">as low as possible</option>
              <option value="maximise">as high as possible</option>
            </select>
            {typed("least", "at least")}{typed("most", "at most")}
          </li>
        );
      })}
    </ul>
  );
}
