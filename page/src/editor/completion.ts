/** What may be typed at a place: fields, words, names of models, units behind a number. */
import type { ProjectView } from "../state/project.ts";
import type { ModelKind } from "./documents.ts";
import { about, aboutPlace, at, choices, fields, type Schema } from "./schema.ts";
import type { YamlPlace } from "./yamlPlace.ts";

export interface Offer {
  label: string;
  /** Typed in its place. */
  apply: string;
  /** Of the right side: a unit, or what kind of thing it is. */
  detail: string;
  info: string;
  kind: "field" | "word" | "model" | "unit";
  /** Larger ones first. */
  rank: number;
}

const NUMBER = /^([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)(\s*)([^\d\s]\S*)?$/;
/** Fields that name a model, and of which kind. */
const NAMED: Record<string, ModelKind> = { line: "line", model: "pantograph", scenario: "scenario", base: "scenario" };

/** Offers at a place, and where the word that they replace begins. */
export function offers(
  place: YamlPlace,
  root: Schema,
  top: Schema,
  models: Pick<ProjectView, "models" | "library"> | null,
): { from: number; offers: Offer[] } {
  if (place.typing === "field") return { from: place.from, offers: fieldOffers(place, root, top) };
  const schemas = at(place.path, root, top);
  const told = aboutPlace(place.path, root, top);
  const number = NUMBER.exec(place.word);
  if (number && told.units.length) {
    const from = place.from + number[1]!.length + number[2]!.length;
    const space = number[2] ? "" : " ";
    return { from, offers: told.units.map((unit, order) => offerOf(unit, space + unit, "unit", 50 - order, "", "")) };
  }
  const words = told.words.map((word, order) => offerOf(word, word, "word", 50 - order, "", ""));
  return { from: place.from, offers: [...words, ...modelOffers(place, schemas, top, models)] };
}

function offerOf(label: string, apply: string, kind: Offer["kind"], rank: number, detail: string, info: string): Offer {
  return { label, apply, kind, rank, detail, info };
}

function fieldOffers(place: YamlPlace, root: Schema, top: Schema): Offer[] {
  const found: Offer[] = [];
  for (const [name, { schema, required }] of fields(place.path, root, top)) {
    if (place.siblings.includes(name)) continue;
    const told = about([schema], top);
    const detail = [required ? "required" : "", told.unit ?? ""].filter(Boolean).join(", ");
    const info = [told.description, told.limits && `${told.limits}.`].filter(Boolean).join(" ");
    found.push(offerOf(name, `${name}: `, "field", required ? 60 : 40, detail, info));
  }
  return found;
}

/** Shipped models by their names, those of the folder by their files. */
function modelOffers(
  { path }: YamlPlace,
  schemas: readonly Schema[],
  top: Schema,
  models: Pick<ProjectView, "models" | "library"> | null,
): Offer[] {
  const kind = NAMED[String(path.at(-1))];
  const isText = schemas.some((one) => choices(one, top).some((choice) => choice.type === "string"));
  if (!kind || !models || (schemas.length > 0 && !isText)) return [];
  const own = models.models
    .filter((one) => one.kind === kind)
    .map((one) => offerOf(one.path, one.path, "model", 30, "of this folder", one.description));
  const shipped = models.library
    .filter((one) => one.kind === kind)
    .map((one) => offerOf(one.name, one.name, "model", 20, "shipped", one.description));
  return [...own, ...shipped];
}

/** What a place is, for reading: description, unit, limits, what holds without it. */
export function inWords(place: YamlPlace, root: Schema, top: Schema): string[] {
  if (!at(place.path, root, top).length) return [];
  const told = aboutPlace(place.path, root, top);
  const unit = told.unit && told.unit !== "1" ? `Unit: ${told.unit}` : "";
  const others = told.units.length > 1 ? ` (or ${told.units.slice(1).join(", ")})` : "";
  const words = told.words.length ? `One of ${told.words.join(", ")}.` : "";
  const without =
    told.default === undefined || told.default === null ? "" : `Without it: ${JSON.stringify(told.default)}.`;
  return [told.description, unit && `${unit}${others}.`, told.limits && `Limits: ${told.limits}.`, words, without].filter(
    Boolean,
  );
}
