/** Fields of a scenario by their dotted paths in words, as the studies name them, counted from 1: "Pantograph 1: static force". */
import { written, type Changed } from "./changes.ts";

/** Words of parts of a path that are not these parts themselves; empty: it is left out. */
const TITLES: Record<string, string> = { pantographs: "pantograph", model: "", set: "" };

const words = (parts: readonly string[]): string =>
  parts
    .map((part) => (/^\d+$/.test(part) ? String(Number(part) + 1) : (TITLES[part] ?? part).replaceAll("_", " ")))
    .filter(Boolean)
    .join(" ");

const capital = (text: string) => text.charAt(0).toUpperCase() + text.slice(1);

function plain(path: string): string {
  const parts = path.split(".");
  const [group, label] = [words(parts.slice(0, -1)), words(parts.slice(-1))];
  return group && label ? `${group}: ${label}` : group || label;
}

/** The words of a field. */
export const fieldWords = (path: string): string => capital(plain(path));

function oneChange([path, value]: readonly [string, Changed]): string {
  const told = written(value);
  return path.endsWith(".model") ? `${plain(path)}: ${told.replace(/\.(ya?ml|json)$/i, "")}` : `${plain(path)} ${told}`;
}

/** Fields and their values after other words: "pantograph 1: dsa-250, speed 260 km/h". */
export const changesAfter = (all: readonly (readonly [string, Changed])[]): string => all.map(oneChange).join(", ");

/** Fields and their values by themselves: "Line contact wire: tension 17 kN, speed 260 km/h". */
export const changesInWords = (all: readonly (readonly [string, Changed])[]): string => capital(changesAfter(all));
