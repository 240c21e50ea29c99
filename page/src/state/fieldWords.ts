/** A field of a scenario by its dotted path in words, as the studies name it, people count from 1: "Pantograph 1: static force". */
import { written, type Changed } from "./changes.ts";

/** Words of parts of a path that are not these parts themselves; empty: it is left out. */
const TITLES: Record<string, string> = { pantographs: "pantograph", model: "", set: "" };

const words = (parts: readonly string[]): string =>
  parts
    .map((part) => (/^\d+$/.test(part) ? String(Number(part) + 1) : (TITLES[part] ?? part).replaceAll("_", " ")))
    .filter(Boolean)
    .join(" ");

/** The words of a field. */
export function fieldWords(path: string): string {
  const parts = path.split(".");
  const [group, label] = [words(parts.slice(0, -1)), words(parts.slice(-1))];
  const text = group && label ? `${group}: ${label}` : group || label;
  return text.charAt(0).toUpperCase() + text.slice(1);
}

/** A field and its value: "Pantograph 1: dsa-250", "Line contact wire: tension 17 kN". */
export function changeWords(path: string, value: Changed): string {
  const isModel = path.endsWith(".model");
  const told = written(value);
  return isModel ? `${fieldWords(path)}: ${told.replace(/\.(ya?ml|json)$/i, "")}` : `${fieldWords(path)} ${told}`;
}
