/** Sliders for fields of the form: what a value becomes when one is moved. */
import { parts, type FormField, type FormGroup } from "../editor/formData.ts";
import type { Value } from "../editor/patch.ts";
import type { Changes } from "./asking.ts";

/** A slider reaches so far from the value in the file, as a share of it. */
const REACH = 0.3;
/** Steps from end to end. */
const STEPS = 120;
/** A slider moves one field, or a scale all lists of pre-sag. */
export interface Slider {
  id: string;
  label: string;
  unit: string;
  /** In the unit that is typed. */
  start: number;
  low: number;
  high: number;
  step: number;
  /** Values as typed of the fields that it moves, when it stands at a number. */
  changes(value: number): Changes;
}

export const PRESAG = "pre-sag";

/** Fields of all groups; a label says its group too, since every wire has a tension. */
export function fieldsOf(groups: readonly FormGroup[]): FormField[] {
  return groups.flatMap(({ title, fields }) => fields.map((one) => ({ ...one, label: `${title}: ${one.label}` })));
}

/** A plain step of 1, 2 or 5 with about so many in a length. */
export function stepOf(length: number): number {
  const power = 10 ** Math.floor(Math.log10(length / STEPS));
  const found = [1, 2, 5].find((one) => one * power * STEPS >= length) ?? 10;
  return Number((found * power).toPrecision(3));
}

/** Values of lists one by one: a list is moved item by item. */
export function numbersOf(field: FormField): FormField[] {
  const { typed, value } = field;
  if (!Array.isArray(typed)) return Number.isFinite(numberOf(typed)) && typed !== null ? [field] : [];
  return typed.flatMap((one, index) =>
    Number.isFinite(numberOf(one)) && one !== null
      ? [
          {
            ...field,
            field: `${field.field}.${index}`,
            label: `${field.label} ${index + 1}`,
            typed: one,
            value: Array.isArray(value) ? (value[index] ?? null) : null,
          },
        ]
      : [],
  );
}

function numberOf(typed: Value): number {
  if (typeof typed === "number") return typed;
  return typeof typed === "string" ? Number(parts(typed).number || NaN) : NaN;
}

/** A number written with no more digits than its step has. */
export function written(value: number, step: number): string {
  return String(Number(value.toFixed(Math.max(0, Math.ceil(-Math.log10(step) + 1e-9)))));
}

export function sliderOf(field: FormField): Slider | null {
  const start = numberOf(field.typed);
  if (field.typed === null || !Number.isFinite(start)) return null;
  const { unit } = parts(field.typed);
  const reach = REACH * (Math.abs(start) || 1);
  const step = stepOf(2 * reach);
  // Limits are in SI, the slider is in the unit that is typed.
  const worth = typeof field.value === "number" && start !== 0 ? field.value / start : 1;
  const within = (value: number) =>
    Math.min(Math.max(value, (field.minimum ?? -Infinity) / worth), (field.maximum ?? Infinity) / worth);
  return {
    id: field.field,
    label: field.label,
    unit: unit || field.unit || "",
    start,
    low: within(start - reach),
    high: within(start + reach),
    step,
    changes: (value) => ({ [field.field]: unit ? `${written(value, step)} ${unit}` : Number(written(value, step)) }),
  };
}

const SCALE_STEP = 0.01;
/** Digits of a scaled pre-sag: a hundredth of a millimetre. */
const SCALED = 5;

/** One slider that scales all pre-sags together; null of a line without any. */
export function presagScale(groups: readonly FormGroup[]): Slider | null {
  const lists = fieldsOf(groups).filter((one) => /(^|\.)presag$/.test(one.field) && Array.isArray(one.typed));
  if (!lists.length) return null;
  const scaled = (typed: Value, factor: number): Value => {
    const { unit } = parts(typed);
    const value = Number((numberOf(typed) * factor).toFixed(SCALED));
    return unit ? `${value} ${unit}` : value;
  };
  return {
    id: PRESAG,
    label: "Pre-sag, all together",
    unit: "×",
    start: 1,
    low: 0,
    high: 2,
    step: SCALE_STEP,
    changes: (factor) =>
      Object.fromEntries(lists.map((one) => [one.field, (one.typed as Value[]).map((typed) => scaled(typed, factor))])),
  };
}

const FIRST = [/contact_wire\.tension$/, /messenger_wire\.tension$/];

/** Sliders that are there before any is chosen: tensions and pre-sag. */
export function firstSliders(groups: readonly FormGroup[]): string[] {
  const fields = fieldsOf(groups).map((one) => one.field);
  const found = FIRST.map((pattern) => fields.find((field) => pattern.test(field))).filter((one) => one !== undefined);
  return presagScale(groups) ? [...found, PRESAG] : found;
}

/** The slider with an identity. */
export function sliderBy(id: string, groups: readonly FormGroup[]): Slider | null {
  if (id === PRESAG) return presagScale(groups);
  const field = fieldsOf(groups).flatMap(numbersOf).find((one) => one.field === id);
  return field ? sliderOf(field) : null;
}
