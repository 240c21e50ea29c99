/** The common fields of the file, as the server finds them in its text. */
import { effect, signal } from "@preact/signals";
import { ask, newest } from "../connection/http.ts";
import { opened, text } from "./documents.ts";
import type { Value } from "./patch.ts";

export interface FormField {
  /** Dotted path. */
  field: string;
  label: string;
  /** As it stands in the text: a number, a text with its unit, a list; null where it is not given. */
  typed: Value;
  /** Of a variant: what its base has, where nothing is typed. */
  inherited?: Value;
  /** In SI. */
  value: Value;
  unit: string | null;
  units: string[];
  minimum: number | null;
  maximum: number | null;
  description: string;
  line: number | null;
  required: boolean;
  /** Words that may stand there. */
  choices?: string[] | null;
  /** Path of the droppers that this list has one value each for; null of other fields. */
  together?: string | null;
}

export interface FormGroup {
  title: string;
  fields: FormField[];
}

export interface Form {
  groups: FormGroup[];
}

/** Of the last text that could be read. */
export const form = signal<{ path: string; groups: FormGroup[] } | null>(null);

/** After the last key in the text, in ms. A change in the form is seen at once in the field itself. */
const ASK_AFTER = 120;

const question = newest((signal, path: string, content: string) =>
  ask<Form>("form", { body: { path, text: content }, signal }),
);

/** Follow the text while the form is seen; the returned function ends it. */
export function followForm(): () => void {
  let timer: ReturnType<typeof setTimeout> | undefined;
  return effect(() => {
    const [path, content] = [opened.value?.path, text.value];
    clearTimeout(timer);
    if (path === undefined) return;
    const act = () =>
      question(path, content).then(
        (found) => {
          // A text that cannot be read keeps the form as it was: what is wrong stands in the list.
          if (found?.groups.length || form.peek()?.path !== path) form.value = { path, groups: found?.groups ?? [] };
        },
        () => undefined, // as well without a server
      );
    timer = setTimeout(() => void act(), form.peek()?.path === path ? ASK_AFTER : 0);
  });
}

const AMOUNT = /^\s*([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)\s*(.*?)\s*$/;

/** Number and unit of a value as typed; the number as text, so that no digit is lost. */
export function parts(typed: Value): { number: string; unit: string } {
  if (typed === null) return { number: "", unit: "" };
  const found = AMOUNT.exec(String(typed));
  return found ? { number: found[1]!, unit: found[2]! } : { number: String(typed), unit: "" };
}

/** The value to type for a number and a unit; a number without a unit stays a number. */
export function amount(number: string, unit: string): Value {
  const content = number.trim();
  if (unit) return `${content} ${unit}`;
  return content !== "" && Number.isFinite(Number(content)) ? Number(content) : content;
}

// Digits of a converted number: those that a double keeps, without its last ones.
const DIGITS = 12;

/** The same value in another unit; the server knows what a unit is worth. */
export async function inUnit(own: FormField, unit: string): Promise<Value | null> {
  const [path, content] = [opened.peek()?.path, text.peek()];
  if (path === undefined || typeof own.value !== "number") return null;
  const changes = { [own.field]: `1 ${unit}` };
  const one = await ask<{ text: string }>("patch", { body: { path, text: content, changes } });
  const found = await ask<Form>("form", { body: { path, text: one.text } });
  const worth = found.groups.flatMap((group) => group.fields).find((field) => field.field === own.field)?.value;
  if (typeof worth !== "number" || worth === 0) return null;
  return `${Number((own.value / worth).toPrecision(DIGITS))} ${unit}`;
}
