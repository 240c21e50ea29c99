/** Droppers of a span, and supports, with what changed against the file. Numbers are in SI but mm. */
import { computed, signal } from "@preact/signals";
import { cursor, selected } from "../state/selection.ts";
import { now, ofFile, type DropperRow } from "./asking.ts";

/** The dropper that is nearest to the cursor, whichever view it is moved in. */
const atCursor = computed(() => {
  const [at, droppers] = [cursor.value, now.value?.droppers ?? []];
  if (at === null || !droppers.length) return null;
  return droppers.reduce((best, one) => (Math.abs(one.x_m - at) < Math.abs(best.x_m - at) ? one : best));
});

function choose({ name, x_m }: DropperRow): void {
  selected.value = { kind: "dropper", name, x_m };
  cursor.value = x_m;
}

/** A difference with its sign; nothing where there is none to the last digit shown. */
export function difference(value: number | null | undefined, before: number | null | undefined, digits: number): string {
  if (value === null || value === undefined || before === null || before === undefined) return "";
  const text = (value - before).toFixed(digits);
  if (Number(text) === 0) return "";
  return Number(text) > 0 ? `+${text}` : text.replace("-", "−");
}

/** Length that the fittings of a dropper take beyond its unstretched length, as typed; bare numbers are mm. */
export const allowance = signal("0");

/** What is typed in mm; null where it is no such number, or has another unit: the schedule has it alone. */
export function millimetres(typed: string): number | null {
  const [, text] = /^\s*(\d+\.?\d*|\.\d+)?\s*(?:mm)?\s*$/.exec(typed) ?? [];
  return text === undefined ? (typed.trim() === "" ? 0 : null) : Number(text);
}

const number = (value: number | null | undefined, digits: number) =>
  value === null || value === undefined ? "–" : value.toFixed(digits).replace("-", "−");

export function DropperTable() {
  const [found, before] = [now.value, ofFile.value];
  if (!found?.droppers?.length) return <p class="empty">This line has no droppers.</p>;
  const spans = [...new Set(found.droppers.map((one) => one.span))];
  const span = atCursor.value?.span ?? found.middle_span;
  const list = (wanted: number) => {
    const first = found.droppers?.find((one) => one.span === wanted);
    if (first) cursor.value = first.x_m;
  };
  const own = found.droppers.filter((one) => one.span === span);
  const old = new Map((before?.droppers ?? []).map((one): [string, DropperRow] => [one.name, one]));
  const changed = before !== found && before !== null;
  const fittings = millimetres(allowance.value);
  return (
    <section aria-label="Droppers">
      <label>
        Droppers of span{" "}
        <select value={String(span)} onChange={(event) => list(Number(event.currentTarget.value))}>
          {spans.map((one) => (
            <option key={one} value={String(one)}>
              {one}
            </option>
          ))}
        </select>
      </label>
      <div class="scroll" tabIndex={0} role="region" aria-label={`Droppers of span ${span}`}>
        <table>
          <thead>
            <tr>
              <th scope="col">Dropper</th>
              <th scope="col">Position m</th>
              <th scope="col">Length between clamps m</th>
              {changed && <th scope="col">Change mm</th>}
              <th scope="col">Unstretched length m</th>
              {fittings !== null && <th scope="col">Cut length m</th>}
              <th scope="col">Force at rest N</th>
              {changed && <th scope="col">Change N</th>}
            </tr>
          </thead>
          <tbody>
            {own.map((one) => {
              const was = old.get(one.name);
              const isIt = selected.value?.kind === "dropper" && selected.value.name === one.name;
              return (
                <tr key={one.name} aria-selected={isIt} class={`${one.force_N === 0 ? "slack" : ""} ${atCursor.value?.name === one.name ? "at-cursor" : ""}`}>
                  <th scope="row">
                    <button class="plain" onClick={() => choose(one)}>
                      {one.name}
                    </button>
                  </th>
                  <td>{number(one.x_m, 2)}</td>
                  <td>{number(one.length_m, 4)}</td>
                  {changed && <td>{difference(1e3 * one.length_m, was && 1e3 * was.length_m, 1)}</td>}
                  <td>{number(one.unstretched_length_m, 4)}</td>
                  {fittings !== null && <td>{number(one.unstretched_length_m + 1e-3 * fittings, 4)}</td>}
                  <td>{one.force_N === 0 ? "slack" : number(one.force_N, 1)}</td>
                  {changed && <td>{difference(one.force_N, was?.force_N, 1)}</td>}
                </tr>
              );
            })}
          </tbody>
        </table>
      </div>
    </section>
  );
}

export function SupportTable() {
  const [found, before] = [now.value, ofFile.value];
  if (!found?.supports?.length) return null;
  const old = new Map((before?.supports ?? []).map((one) => [one.name, one]));
  const changed = before !== found && before !== null;
  const spatial = found.supports.some((one) => one.contact_wire_lateral_force_N !== null);
  return (
    <section aria-label="Supports">
      <h3>Supports</h3>
      <div class="scroll" tabIndex={0} role="region" aria-label="Table of supports">
        <table>
          <thead>
            <tr>
              <th scope="col">Support</th>
              <th scope="col">Position m</th>
              <th scope="col">Height of contact wire m</th>
              <th scope="col">Vertical load N</th>
              {spatial && <th scope="col">Steady-arm force N</th>}
              {spatial && changed && <th scope="col">Change N</th>}
              {spatial && <th scope="col">Lateral force of contact wire N</th>}
            </tr>
          </thead>
          <tbody>
            {found.supports.map((one) => (
              <tr key={one.name}>
                <th scope="row">{one.name}</th>
                <td>{number(one.x_m, 2)}</td>
                <td>{number(one.contact_wire_height_m, 4)}</td>
                <td>{number(one.messenger_force_N ?? one.contact_support_force_N, 1)}</td>
                {spatial && <td>{number(one.steady_arm_force_N, 1)}</td>}
                {spatial && changed && (
                  <td>{difference(one.steady_arm_force_N, old.get(one.name)?.steady_arm_force_N, 1)}</td>
                )}
                {spatial && <td>{number(one.contact_wire_lateral_force_N, 1)}</td>}
              </tr>
            ))}
          </tbody>
        </table>
      </div>
    </section>
  );
}
