/** A number written as the one that stands in the text: with its unit, or without one. */
import type { Value } from "./patch.ts";

const AMOUNT = /^\s*[-+]?[\d.]+(?:[eE][-+]?\d+)?\s*([^\d\s].*?)\s*$/;
const LENGTHS: Record<string, number> = { mm: 1e3, cm: 1e2, m: 1 };
/** Digits that a value keeps: no more than the tenth of a millimetre that is dragged. */
const DIGITS = 6;

/** What stands at a path, with the source of its value if it has one; undefined where nothing does. */
async function nodeAt(content: string, path: readonly (string | number)[]): Promise<unknown> {
  const { parseDocument } = await import("yaml");
  const document = parseDocument(content, { logLevel: "silent" });
  let here: unknown = document.toJS({ maxAliasCount: 100 });
  for (const part of path) {
    if (isMap(here) && "value" in here && !(part in here)) here = here["value"];
    here = isMap(here) || Array.isArray(here) ? (here as Record<string, unknown>)[part] : undefined;
  }
  return here;
}

/** The value of a field as typed; undefined where there is none, or the text is no YAML. */
export async function typedAt(content: string, field: string): Promise<unknown> {
  const here = await nodeAt(content, field.split("."));
  return isMap(here) && "value" in here ? here["value"] : here;
}

/** Where the value at a path is from: confidence mark, source and note, as they are typed. */
export async function sourceAt(content: string, path: readonly (string | number)[]): Promise<string[]> {
  const here = await nodeAt(content, path).catch(() => undefined);
  if (!isMap(here) || !("value" in here)) return [];
  return ["mark", "source", "note"]
    .filter((name) => typeof here[name] === "string")
    .map((name) => `${name[0]!.toUpperCase()}${name.slice(1)}: ${String(here[name])}`);
}

const isMap = (value: unknown): value is Record<string, unknown> =>
  typeof value === "object" && value !== null && !Array.isArray(value);

/** A length in m, written like the value that a field of the text has. */
export async function typedLike(content: string, field: string, metres: number): Promise<Value> {
  const typed = await typedAt(content, field).catch(() => undefined);
  if (typeof typed === "number") return metres;
  const unit = typeof typed === "string" ? AMOUNT.exec(typed)?.[1] : undefined;
  const factor = unit === undefined ? undefined : LENGTHS[unit];
  return factor === undefined ? `${metres} m` : `${Number((metres * factor).toPrecision(DIGITS))} ${unit}`;
}
