/** A list of the form as a small table: values in a row each, or columns for the fields of its items. */
import { useSignal } from "@preact/signals";
import { selectedField } from "../drawing/scene.ts";
import { selected } from "../state/selection.ts";
import { writable } from "./documents.ts";
import { amount, parts, type FormField } from "./formData.ts";
import type { Value } from "./patch.ts";
import { VaryButton } from "../studies/VaryButton.tsx";
import { About, canVary, change, problemsOf } from "./ValueField.tsx";

type Item = { [key: string]: Value };
const isItem = (value: Value): value is Item => typeof value === "object" && value !== null && !Array.isArray(value);

/** Numbers of the items of a list can be varied; spans by their hundreds, and values that are the list itself, cannot. */
const isVaried = (own: FormField, value: Value, field: string) =>
  Array.isArray(own.typed) && own.typed.some(isItem) && !own.field.endsWith("spans") && field.split(".").length > own.field.split(".").length + 1 && /^[-+.\d]/.test(String(value ?? ""));

export function ListField({ own }: { own: FormField }) {
  const rows = Array.isArray(own.typed) ? own.typed : [];
  const columns = [...new Set(rows.flatMap((one) => (isItem(one) ? Object.keys(one) : [])))];
  const disabled = !writable.value;
  // A new row is like the last one: its numbers are changed then.
  const add = () => change(`${own.field}.${rows.length}`, rows.at(-1) ?? 0);
  const cell = (field: string, value: Value, label: string) => (
    <Cell key={field} field={field} value={value} label={label} disabled={disabled} canVary={canVary.value && isVaried(own, value, field)} />
  );
  return (
    <fieldset class="list">
      <legend>
        {own.label}
        {own.unit && own.unit !== "1" ? ` (${own.unit} unless typed)` : ""}
      </legend>
      <table>
        {columns.length > 0 && (
          <thead>
            <tr>
              <th scope="col">Number</th>
              {columns.map((one) => (
                <th scope="col" key={one}>{one.replaceAll("_", " ")}</th>
              ))}
              <th scope="col">
                <span class="visually-hidden">Remove</span>
              </th>
            </tr>
          </thead>
        )}
        <tbody>
          {rows.map((value, index) => {
            const field = `${own.field}.${index}`;
            const label = `${own.label} ${index + 1}`;
            return (
              <tr key={index}>
                <th scope="row">{index + 1}</th>
                {isItem(value)
                  ? columns.map((one) => <td key={one}>{cell(`${field}.${one}`, value[one] ?? null, `${label}, ${one}`)}</td>)
                  : <td>{cell(field, value, label)}</td>}
                <td>
                  <button disabled={disabled} aria-label={`Remove ${label}`} onClick={() => change(field, null)}>
                    ×
                  </button>
                </td>
              </tr>
            );
          })}
        </tbody>
      </table>
      <button disabled={disabled} onClick={add}>
        Add {rows.length ? "another" : "one"}
      </button>
      <About own={own} problems={problemsOf(own.field)} />
    </fieldset>
  );
}

interface CellProps {
  field: string;
  value: Value;
  label: string;
  disabled: boolean;
  canVary: boolean;
}

export function Cell({ field, value, label, disabled, canVary }: CellProps) {
  const typing = useSignal<string | null>(null);
  const shown = isItem(value) || Array.isArray(value) ? JSON.stringify(value) : String(value ?? "");
  const problems = problemsOf(field);
  const commit = () => {
    const now = typing.value?.trim();
    typing.value = null;
    if (now === undefined || now === shown) return;
    const { number, unit } = parts(now);
    change(field, now === "" ? null : amount(number, unit));
  };
  // In a table a button for each number would hide the numbers: the one that is selected has it.
  const isSelected = selected.value?.kind === "field" && selected.value.field === field;
  return (
    <>
      <input
        aria-label={label}
        aria-invalid={problems.length > 0}
        title={problems.join(" ")}
        value={typing.value ?? shown}
        disabled={disabled || isItem(value) || Array.isArray(value)}
        class={selectedField.value === field ? "here" : ""}
        onFocus={() => (selected.value = { kind: "field", field })}
        onInput={(event) => (typing.value = event.currentTarget.value)}
        onBlur={commit}
        onKeyDown={(event) => {
          if (event.key === "Enter") commit();
          if (event.key === "Escape") typing.value = null;
        }}
      />
      {canVary && isSelected && <VaryButton field={field} label={label} />}
    </>
  );
}
