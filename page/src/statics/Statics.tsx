/** The line at rest in numbers, which follow sliders; the file changes when that is asked for. */
import { signal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import type { Complaint } from "../connection/http.ts";
import { wrong } from "../drawing/scene.ts";
import { kind, opened, writable } from "../editor/documents.ts";
import { followForm, form } from "../editor/formData.ts";
import { patch } from "../editor/patch.ts";
import { canRun, nameOf } from "../project/running.ts";
import { complain, say } from "../shell/messages.ts";
import { file, scenario } from "../state/selection.ts";
import { told } from "../state/subject.ts";
import { askPart, frequencies, isAsking, isTrying, now, ofFile, tried, wanted, type AtRest } from "./asking.ts";
import { Chart } from "./Chart.tsx";
import { fieldsOf, firstSliders, numbersOf, PRESAG, presagScale, sliderBy, written, type Slider } from "./sliders.ts";
import "./statics.css";
import { DropperTable, difference, SupportTable } from "./Tables.tsx";
import { isOfScenario, lineOfScenario, runTried } from "./variant.ts";

/** Sliders by file, in their order; without an entry the first ones. */
const chosen = signal<Record<string, string[]>>({});
/** Where sliders stand, by identity. */
const standing = signal<Record<string, number>>({});
const allowance = signal("0 mm");

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

async function download(): Promise<void> {
  try {
    const found = await askPart<{ schedule: string; errors: Complaint[] }>("schedule", {
      allowance: allowance.peek().trim() || "0 mm",
    });
    const [refused] = found.errors;
    if (refused) return say("error", refused.text);
    const { schedule } = found;
    const address = URL.createObjectURL(new Blob([schedule], { type: "text/csv" }));
    // What is tried is not in the file: a schedule of it must not pass for that of the line.
    const download = `${now.peek()?.name ?? "line"}-droppers${isTrying.peek() ? "-tried" : ""}.csv`;
    const link = Object.assign(document.createElement("a"), { href: address, download });
    link.click();
    URL.revokeObjectURL(address);
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
      {wrong.value && <p class="problem" role="alert">{wrong.value.text}</p>}
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
          This scenario names its line, whose tensions, pre-sag and droppers are moved there.{" "}
          {lineOfScenario.value !== null && (
            <button onClick={() => (file.value = lineOfScenario.peek())}>Open the line {told(lineOfScenario.value)}</button>
          )}
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
        {isOfScenario.value && (
          <button
            onClick={() => void runTried()}
            disabled={!isChanged || !canRun.value}
            title={`Run ${nameOf(scenario.value!)} with these values; no file is changed`}
          >
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
    <p class="acts">
      <label>
        Allowance for fittings{" "}
        <input size={8} value={allowance.value} onInput={(event) => (allowance.value = event.currentTarget.value)} />
      </label>
      <button onClick={() => void download()}>Dropper schedule as CSV</button>
    </p>
  );
}
