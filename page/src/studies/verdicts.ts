/** Verdicts on rows, and limits of columns, as the server found them; by word and shape, never by colour alone. */
import { shown, type Column } from "./columns.ts";
import type { Criterion, Judgement, Row } from "./open.ts";

export interface Shape {
  sign: string;
  /** Token of the colour. */
  colour: "met" | "not_met" | "open";
  /** Class of the colour. */
  state: "met" | "not-met" | "open";
  drawn: "circle" | "up" | "down" | "diamond";
}

export const NOT_JUDGED = "not judged";
/** The worst first. */
export const SHAPES: Record<string, Shape> = {
  "not met": { sign: "✘", colour: "not_met", state: "not-met", drawn: "up" },
  "too close to tell": { sign: "≈", colour: "open", state: "open", drawn: "diamond" },
  "not met, unverified": { sign: "?", colour: "open", state: "open", drawn: "down" },
  met: { sign: "✔", colour: "met", state: "met", drawn: "circle" },
};
const WORST_FIRST = Object.keys(SHAPES);

export const verdictOf = (row: Row): string => String(row.at(-4) ?? NOT_JUDGED);
export const judgementsOf = (row: Row): Judgement[] => (Array.isArray(row.at(-3)) ? (row.at(-3) as Judgement[]) : []);

/** What is said of an output in a row: the worst of its criteria; null where it is not judged. */
export function verdictOn(column: Column, row: Row, criteria: readonly Criterion[]): string | null {
  const own = judgementsOf(row).filter(([number]) => criteria[number]?.output === column.name);
  const words = own.map(([, word]) => word);
  return WORST_FIRST.find((word) => words.includes(word)) ?? null;
}

export interface Limit {
  /** "≤", "≥" or ">". */
  sign: string;
  low: number;
  high: number;
  source: string;
}

const SIGNS: Record<string, string> = { "<=": "≤", ">=": "≥", ">": ">" };
/** Digits of a limit. */
const DIGITS = 4;

/** Limits of a column over rows: of criteria, and bounds that a search keeps. */
export function limitsOf(column: Column, rows: readonly Row[], criteria: readonly Criterion[]): Limit[] {
  const found: Limit[] = [];
  criteria.forEach((criterion, number) => {
    if (criterion.output !== column.name || !criterion.relation) return;
    let [low, high] = [Infinity, -Infinity];
    for (const row of rows) {
      const limit = judgementsOf(row).find(([at]) => at === number)?.[2];
      if (limit === null || limit === undefined) continue;
      if (limit < low) low = limit;
      if (limit > high) high = limit;
    }
    if (low <= high) found.push({ sign: SIGNS[criterion.relation] ?? criterion.relation, low, high, source: `${criterion.title}, ${criterion.source}` });
  });
  const { at_least = null, at_most = null } = column.output?.bounds ?? {};
  if (at_least !== null) found.push({ sign: "≥", low: at_least, high: at_least, source: "constraint of the search" });
  if (at_most !== null) found.push({ sign: "≤", low: at_most, high: at_most, source: "constraint of the search" });
  return found;
}

/** A limit in words: with its relation, or from where to where it goes with the variants, which is no band that is allowed. */
export function wordsOf(limit: Limit): string {
  const [low, high] = [shown(limit.low, DIGITS), shown(limit.high, DIGITS)];
  if (low === high) return `limit ${limit.sign} ${high}`;
  const decimals = Math.max(...[low, high].map((text) => (/^-?\d+\.\d+$/.test(text) ? text.split(".")[1]!.length : 0)));
  return `limit ${[limit.low, limit.high].map((one, k) => (/e/.test([low, high][k]!) ? [low, high][k]! : one.toFixed(decimals))).join(" to ")}, by variant`;
}
