/** The JSON Schema of model files: which fields a place has, their units, limits and choices. */
import { ask } from "../connection/http.ts";
import type { ModelKind } from "./documents.ts";

export interface Schema {
  $ref?: string;
  $defs?: Record<string, Schema>;
  description?: string;
  title?: string;
  unit?: string;
  default?: unknown;
  const?: unknown;
  enum?: unknown[];
  type?: string | string[];
  properties?: Record<string, Schema>;
  additionalProperties?: boolean | Schema;
  required?: string[];
  items?: Schema | boolean;
  anyOf?: Schema[];
  oneOf?: Schema[];
  allOf?: Schema[];
  minimum?: number;
  maximum?: number;
  exclusiveMinimum?: number;
  exclusiveMaximum?: number;
  pattern?: string;
}

const loaded = new Map<string, Promise<Schema>>();

/** The schema of a kind; asked for once. */
export function schemaOf(kind: ModelKind): Promise<Schema> {
  const known = loaded.get(kind);
  if (known) return known;
  const asked = ask<Schema>("schema", { query: { kind } });
  loaded.set(kind, asked);
  asked.catch(() => loaded.delete(kind)); // asked again when the server is there
  return asked;
}

/** The part of the schema that a kind of file begins with. */
export function rootOf(schema: Schema, kind: ModelKind): Schema {
  return schema.$defs?.[kind[0]!.toUpperCase() + kind.slice(1)] ?? schema;
}

// Schemas nest by a dozen; a circle of references ends here.
const DEEPEST = 20;

/** Everything that a schema may be: references followed, choices spread out. */
export function choices(schema: Schema, top: Schema, depth = 0): Schema[] {
  if (depth > DEEPEST) return [];
  const referred = schema.$ref ? top.$defs?.[schema.$ref.split("/").at(-1)!] : undefined;
  const others = [...(schema.anyOf ?? []), ...(schema.oneOf ?? []), ...(schema.allOf ?? [])];
  return [
    schema,
    ...(referred ? choices(referred, top, depth + 1) : []),
    ...others.flatMap((one) => choices(one, top, depth + 1)),
  ];
}

/** The schemas of the place that a path leads to; numbers are items of lists. */
export function at(path: readonly (string | number)[], root: Schema, top: Schema): Schema[] {
  let here = [root];
  for (const part of path) {
    here = here.flatMap((schema) => choices(schema, top).flatMap((one) => inside(one, part)));
  }
  return here;
}

function inside(schema: Schema, part: string | number): Schema[] {
  if (typeof part === "number") return typeof schema.items === "object" ? [schema.items] : [];
  const own = schema.properties?.[part];
  if (own) return [own];
  return typeof schema.additionalProperties === "object" ? [schema.additionalProperties] : [];
}

const WRAPPER = new Set(["value", "mark", "source", "note"]);

/** Fields of the place; those that carry the source of a value come last. */
export function fields(path: readonly (string | number)[], root: Schema, top: Schema) {
  const found = new Map<string, { schema: Schema; required: boolean }>();
  const late = new Map<string, { schema: Schema; required: boolean }>();
  for (const schema of at(path, root, top).flatMap((one) => choices(one, top))) {
    const names = Object.keys(schema.properties ?? {});
    const isWrapper = names.length > 0 && names.every((name) => WRAPPER.has(name));
    for (const [name, own] of Object.entries(schema.properties ?? {})) {
      const to = isWrapper ? late : found;
      if (!to.has(name)) to.set(name, { schema: own, required: !isWrapper && !!schema.required?.includes(name) });
    }
  }
  for (const [name, own] of late) if (!found.has(name)) found.set(name, own);
  return found;
}

export interface About {
  description: string;
  /** SI unit; null of what has none. */
  unit: string | null;
  /** Units that may be typed, the SI unit first. */
  units: string[];
  /** Such as "at least 0, at most 20"; empty without limits. */
  limits: string;
  /** Words that may stand there. */
  words: string[];
  default: unknown;
}

const IN_BRACKETS = /\(([^)]*)\)\s*$/;

/** What can be said about the place of a path; the value in a list, or one with a source, has the unit of its field. */
export function aboutPlace(path: readonly (string | number)[], root: Schema, top: Schema): About {
  const told = about(at(path, root, top), top);
  const last = path.at(-1);
  if (told.unit !== null || path.length < 2 || (last !== "value" && typeof last !== "number")) return told;
  const around = aboutPlace(path.slice(0, -1), root, top);
  const units = [...new Set([...(around.unit ? [around.unit] : []), ...around.units])];
  return { ...told, unit: around.unit, units, description: told.description || around.description };
}

/** What can be said about schemas of one place. */
export function about(schemas: readonly Schema[], top: Schema): About {
  const all = schemas.flatMap((one) => choices(one, top));
  const first = <Key extends keyof Schema>(key: Key) => schemas.find((one) => one[key] !== undefined)?.[key];
  const unit = all.find((one) => one.unit !== undefined)?.unit ?? null;
  const amount = unit === null ? undefined : all.find((one) => one.pattern && one.description);
  const offered = IN_BRACKETS.exec(amount?.description ?? "")?.[1]?.split(",").map((one) => one.trim()) ?? [];
  const words = all.flatMap((one) => [...(one.enum ?? []), ...(one.const === undefined ? [] : [one.const])]);
  if (all.some((one) => one.type === "boolean")) words.push(true, false);
  return {
    description: first("description") ?? all.find((one) => one.description && !one.pattern)?.description ?? "",
    unit,
    units: unit === null ? [] : [...new Set([unit, ...offered])].filter(Boolean),
    limits: limitsOf(all, unit),
    words: [...new Set(words.map(String))],
    default: first("default"),
  };
}

function limitsOf(all: readonly Schema[], unit: string | null): string {
  const told = (value: number | undefined, words: string) =>
    value === undefined ? [] : [`${words} ${value}${unit ? ` ${unit}` : ""}`];
  const number = all.find((one) => one.type === "number" || one.type === "integer");
  if (!number) return "";
  return [
    ...told(number.minimum, "at least"),
    ...told(number.exclusiveMinimum, "above"),
    ...told(number.maximum, "at most"),
    ...told(number.exclusiveMaximum, "below"),
  ].join(", ");
}
