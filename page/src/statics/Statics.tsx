/** The line at rest in numbers, which follow sliders; the file changes when that is asked for. */
import { computed, signal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import type { Complaint } from "../connection/http.ts";
import { isListed } from "../editor/checking.ts";
import { wrong } from "../drawing/scene.ts";
import { kind, opened, writable } from "../editor/documents.ts";
import { followForm, form } from "../editor/formData.ts";
import { patch } from "../editor/patch.ts";
import { canRun, run } from "../project/running.ts";
import { fields as scenarioFields } from "../project/scenarioFields.ts";
import { withUnit } from "../project/words.ts";
import { complain, say } from "../shell/messages.ts";
import { show } from "../shell/panels.ts";
import { changes } from "../state/changes.ts";
import { lineOf } from "../state/lineOf.ts";
import { file, scenario } from "../state/selection.ts";
import { askPart, frequencies, isAsking, isTrying, now, ofFile, tried, wanted, type AtRest } from "./asking.ts";
import { Chart } from "./Chart.tsx";
import { fieldsOf, firstSliders, numbersOf, PRESAG, presagScale, sliderBy, written, type Slider } from "./sliders.ts";
import "./statics.css";
import { allowance, DropperTable, difference, SupportTable } from "./Tables.tsx";

/** Sliders by file, in their order; without an entry the first ones. */
const chosen = signal<Record<string, string[]>>({});
/** Where sliders stand, by identity. */
const standing = signal<Record<string, number>>({});
/** Why the last schedule could not be written. */
const refused = signal("");

const groups = () => (form.value?.path === opened.value?.path ? (form.value?.groups ?? []) : []);
const ids = () => chosen.value[opened.value?.path ?? ""] ?? firstSliders(groups());

function choose(all: string[]): void {
  chosen.value = { ...chosen.peek(), [opened.peek()?.path ?? ""]: all };
}

function reset(): void {
  standing.value = {};
  tried.value = {};
}

/** Move a slider: all that stand elsewhere than in the file are tried together. */
function move(slider: Slider, value: number): void {
  standing.value = { ...standing.peek(), [slider.id]: value };
  const found = Object.entries(standing.peek()).map(([id, at]) => {
    const own = sliderBy(id, groups());
    return own && at !== own.start ? own.changes(at) : {};
  });
  tried.value = Object.assign({}, ...found) as Record<string, never>;
}

async function write(): Promise<void> {
  try {
    await patch(tried.peek());
    reset();
  } catch (error) {
    complain(error);
  }
}

/** What is tried, as changes of the scenario that is run; null where that has another line. */
const asChanges = computed(() => {
  const [path, base] = [opened.value?.path, scenario.value];
  if (path === undefined || base === null) return null;
  const own = Object.entries(tried.value);
  if (kind.value === "scenario") return path === base ? Object.fromEntries(own.map(([field, value]) => [field.replace(/^set\./, ""), value])) : null;
  const line = scenarioFields.value?.path === base ? scenarioFields.value.line : null;
  return line !== null && lineOf(base, line) === path ? Object.fromEntries(own.map(([field, value]) => [`line.${field}`, value])) : null;
});

/** Run the scenario with what is tried; no file is changed. */
async function runVariant(): Promise<void> {
  changes.value = { ...changes.peek(), ...asChanges.peek() };
  show("drawing");
  await run();
}

/** The line of the scenario that is edited; null where it does not name one. */
const named = computed(() => {
  const path = opened.value?.path;
  const typed = groups().flatMap(({ fields }) => fields).find(({ field }) => field === "line")?.typed;
  return path !== undefined && typeof typed === "string" ? lineOf(path, typed) : null;
});

async function download(): Promise<void> {
  refused.value = "";
  try {
    const found = await askPart<{ schedule: string; errors: Complaint[] }>("schedule", {
      allowance: withUnit(allowance.peek() || "0", "0 mm"),
    });
    const [complaint] = found.errors;
    if (complaint) return void (refused.value = complaint.text);
    const { schedule } = found;
    const address = URL.createObjectURL(new Blob([schedule], { type: "text/csv" }));
    // What is tried is not in the file: a schedule of it must not pass for that of the line.
    const download = `${now.peek()?.name ?? "line"}-droppers${isTrying.peek() ? "-tried" : ""}.csv`;
    const link = Object.assign(document.createElement("a"), { href: address, download });
    link.click();
    URL.revokeObjectURL(address);
    say("note", `Dropper schedule written: ${download}, among the downloads of the browser.`);
  } catch (error) {
    complain(error);
  }
}

export function Statics() {
  useEffect(() => {
    wanted.value = true;
    return () => void (wanted.value = false);
  }, []);
  useEffect(followForm, []);
  useEffect(() => void (standing.value = {}), [opened.value?.path]);
  if (kind.value !== "line" && kind.value !== "scenario") {
    return <p class="empty">Choose a line or a scenario to see it at rest.</p>;
  }
  const found = now.value;
  const before = isTrying.value ? ofFile.value : null;
  return (
    <div class="statics" aria-busy={isAsking.value}>
      <Sliders />
      {wrong.value && <p class="problem" role="alert">{isListed(wrong.value.text) ? "The file has an error, told below its fields." : wrong.value.text}</p>}
      {found ? (
        <>
          <p class="draft" role="status">
            {found.draft ? "Coarse elements while the slider moves: forces within about 0.1 N. Refined when it rests." : ""}
          </p>
          <Numbers found={found} before={before} />
          {found.elasticity && (
            <Chart
              title={`Elasticity in span ${found.middle_span}`}
              unit="mm/N"
              now={{ x: found.elasticity.x_m, y: found.elasticity.mm_per_N }}
              before={before?.elasticity ? { x: before.elasticity.x_m, y: before.elasticity.mm_per_N } : null}
            />
          )}
          {!!found.droppers?.length && (
            <Chart
              title="Dropper forces at rest"
              unit="N"
              marks
              now={{ x: found.droppers.map((one) => one.x_m), y: found.droppers.map((one) => one.force_N) }}
              before={
                before?.droppers
                  ? { x: before.droppers.map((one) => one.x_m), y: before.droppers.map((one) => one.force_N) }
                  : null
              }
            />
          )}
          <Schedule />
          <DropperTable />
          <SupportTable />
        </>
      ) : (
        !wrong.value && <p class="empty">Finding the line at rest</p>
      )}
    </div>
  );
}

function Sliders() {
  const sliders = ids().map((id) => sliderBy(id, groups())).filter((one) => one !== null);
  const offered = fieldsOf(groups()).flatMap(numbersOf).filter((one) => !ids().includes(one.field));
  const isChanged = isTrying.value;
  return (
    <section aria-label="Values to try" class="sliders">
      {sliders.map((slider) => {
        const at = standing.value[slider.id] ?? slider.start;
        const set = (text: string) => text !== "" && Number.isFinite(Number(text)) && move(slider, Number(text));
        return (
          <div class="slider" key={slider.id}>
            <label for={`slider-${slider.id}`}>{slider.label}</label>
            <input
              id={`slider-${slider.id}`}
              type="range"
              min={slider.low}
              max={slider.high}
              step={slider.step}
              value={at}
              onInput={(event) => set(event.currentTarget.value)}
            />
            <input
              type="number"
              aria-label={`${slider.label}, number`}
              step={slider.step}
              value={written(at, slider.step)}
              onChange={(event) => set(event.currentTarget.value)}
            />
            <span class="unit">{slider.unit}</span>
            <button aria-label={`Remove the slider ${slider.label}`} onClick={() => choose(ids().filter((id) => id !== slider.id))}>
              ×
            </button>
          </div>
        );
      })}
      {!sliders.length && kind.value === "scenario" && (
        <p class="empty">
          This scenario names its line, which has the tensions, pre-sag and droppers.{" "}
          {named.value !== null && <button onClick={() => (file.value = named.value)}>Open the line</button>}
        </p>
      )}
      <p class="acts">
        <label>
          Add a slider{" "}
          <select value="" onChange={(event) => choose([...ids(), event.currentTarget.value])}>
            <option value="">for the field …</option>
            {!ids().includes(PRESAG) && presagScale(groups()) && <option value={PRESAG}>Pre-sag, all together</option>}
            {offered.map((one) => (
              <option key={one.field} value={one.field}>{`${one.label} (${one.field})`}</option>
            ))}
          </select>
        </label>
        <button onClick={() => void write()} disabled={!isChanged || !writable.value}>
          Write to file
        </button>
        {asChanges.value !== null && (
          <button onClick={() => void runVariant()} disabled={!isChanged || !canRun.value} title="The scenario with these values; no file is changed">
            Run as variant
          </button>
        )}
        <button onClick={reset} disabled={!isChanged}>
          Reset
        </button>
      </p>
    </section>
  );
}

function Numbers({ found, before }: { found: AtRest; before: AtRest | null }) {
  const rows: [string, string, string][] = [
    ["Contact wire sag", `${(1e3 * found.sag_m).toFixed(1)} mm`, difference(1e3 * found.sag_m, before && 1e3 * before.sag_m, 1)],
    [
      "Non-uniformity of elasticity",
      found.nonuniformity === undefined ? "–" : `${(100 * found.nonuniformity).toFixed(1)} %`,
      difference(100 * (found.nonuniformity ?? 0), before && 100 * (before.nonuniformity ?? 0), 1),
    ],
    [
      "Wave speed of the contact wire",
      found.wave_speed_m_s === null ? "–" : `${found.wave_speed_m_s.toFixed(1)} m/s (${(3.6 * found.wave_speed_m_s).toFixed(0)} km/h)`,
      difference(found.wave_speed_m_s, before?.wave_speed_m_s, 1),
    ],
  ];
  const natural = frequencies.value;
  return (
    <dl class="numbers">
      {rows.map(([name, value, change]) => (
        <div key={name}>
          <dt>{name}</dt>
          <dd>
            {value} {change && <span class="change">{change}</span>}
          </dd>
        </div>
      ))}
      <div>
        <dt>Lowest natural frequencies</dt>
        <dd>{natural ? `${natural.slice(0, 4).map((one) => one.toFixed(3)).join(", ")} Hz` : "when the slider rests"}</dd>
      </div>
    </dl>
  );
}

function Schedule() {
  if (!now.value?.droppers?.length) return null;
  return (
    <>
      <p class="acts">
        <label>
          Allowance for fittings, mm{" "}
          <input size={8} value={allowance.value} onInput={(event) => (allowance.value = event.currentTarget.value)} />
        </label>
        <button onClick={() => void download()}>Dropper schedule as CSV</button>
      </p>
      {refused.value && <p class="problem" role="alert">{refused.value}</p>}
    </>
  );
}
