/** One value of the form: as typed, its unit, and what the field is. */
import { computed, useSignal } from "@preact/signals";
import { complain } from "../shell/messages.ts";
import { selected } from "../state/selection.ts";
import { VaryButton } from "../studies/VaryButton.tsx";
import { findings } from "./checking.ts";
import { kind, writable } from "./documents.ts";
import { amount, inUnit, parts, type FormField } from "./formData.ts";
import { patch, type Value } from "./patch.ts";

/** Change a field; what is refused is told. */
export function change(field: string, value: Value): void {
  patch({ [field]: value }).catch(complain);
}

/** Errors of a field and of what is below it. */
export function problemsOf(field: string): string[] {
  return findings.value
    .filter(({ finding }) => finding.field && `${finding.field.join(".")}.`.startsWith(`${field}.`))
    .map(({ finding }) => finding.text);
}

export function limitsOf({ minimum, maximum, unit }: FormField): string {
  const told = [
    minimum === null || minimum === undefined ? "" : `from ${minimum}`,
    maximum === null || maximum === undefined ? "" : `up to ${maximum}`,
  ].filter(Boolean);
  return told.length ? `${told.join(" ")}${unit ? ` ${unit}` : ""}` : "";
}

/** Studies vary scenarios, and what is in them. */
export const canVary = computed(() => kind.value !== "study");

export function ValueField({ own }: { own: FormField }) {
  const typing = useSignal<string | null>(null);
  const { number, unit: typedUnit } = parts(own.typed);
  // A number over one of the base has its unit.
  const below = parts(own.inherited ?? null);
  const unit = typedUnit || below.unit;
  const id = `field-${own.field}`;
  const problems = problemsOf(own.field);
  const commit = () => {
    const now = typing.value;
    typing.value = null;
    if (now === null || now.trim() === number) return;
    const given = parts(now);
    // A unit that is typed with the number counts; otherwise the one that stands there stays.
    if (now.trim() === "") change(own.field, null);
    else change(own.field, amount(given.number, given.unit || unit));
  };
  const disabled = !writable.value;
  return (
    <>
      <label for={id}>
        {own.label}
        {own.required && <abbr title="required"> *</abbr>}
      </label>
      <span class="value">
        {typeof own.typed === "boolean" ? (
          <input
            id={id}
            type="checkbox"
            checked={own.typed}
            disabled={disabled}
            onChange={(event) => change(own.field, event.currentTarget.checked)}
          />
        ) : own.choices?.length ? (
          <select
            id={id}
            value={String(own.typed ?? "")}
            disabled={disabled}
            onChange={(event) => change(own.field, event.currentTarget.value || null)}
          >
            {!own.required && <option value="" />}
            {own.choices.map((one) => (
              <option key={one}>{one}</option>
            ))}
          </select>
        ) : (
          <input
            id={id}
            value={typing.value ?? number}
            placeholder={below.number}
            title={below.number ? `As in the base: ${String(own.inherited)}` : undefined}
            disabled={disabled}
            aria-invalid={problems.length > 0}
            aria-describedby={`about-${own.field}`}
            inputMode={own.unit ? "decimal" : "text"}
            onInput={(event) => (typing.value = event.currentTarget.value)}
            onFocus={() => (selected.value = { kind: "field", field: own.field })}
            onBlur={commit}
            onKeyDown={(event) => {
              if (event.key === "Enter") commit();
              if (event.key === "Escape") typing.value = null;
            }}
          />
        )}
        <Unit own={own} unit={unit} disabled={disabled || number === ""} />
        {typeof own.value === "number" && canVary.value && <VaryButton field={own.field} label={own.label} />}
      </span>
      <About own={own} problems={problems} />
    </>
  );
}

/** The unit: chosen anew, the same value is written in it. */
function Unit({ own, unit, disabled }: { own: FormField; unit: string; disabled: boolean }) {
  if (!own.unit || own.unit === "1") return null;
  const all = [...new Set([unit || own.unit, own.unit, ...own.units])];
  if (all.length < 2 || typeof own.value !== "number") return <span class="unit">{unit || own.unit}</span>;
  return (
    <select
      class="unit"
      aria-label={`Unit of ${own.label}`}
      value={unit || own.unit}
      disabled={disabled}
      onChange={(event) => {
        const chosen = event.currentTarget.value;
        inUnit(own, chosen).then((value) => value !== null && change(own.field, value), complain);
      }}
    >
      {all.map((one) => (
        <option key={one}>{one}</option>
      ))}
    </select>
  );
}

/** What a field is, where it is selected. What is wrong with it stands once, in the list below the form. */
export function About({ own, problems }: { own: FormField; problems: string[] }) {
  const here = selected.value?.kind === "field" && selected.value.field === own.field;
  const limits = limitsOf(own);
  if (!here && !problems.length) return <p id={`about-${own.field}`} class="about" hidden>{own.description}</p>;
  return (
    <p id={`about-${own.field}`} class="about">
      {problems.length > 0 && <span class="error">{problems.length > 1 ? `${problems.length} errors` : "An error"}, told below the form. </span>}
      {here && `${own.description}${limits ? ` Limits: ${limits}.` : ""}${own.line ? ` Line ${own.line}.` : ""}`}
    </p>
  );
}
