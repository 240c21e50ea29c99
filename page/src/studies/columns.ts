/** Columns of a study: variables in the unit of its file, outputs in theirs; sorted, filtered, brushed. */
import type { Definition, Output, Row } from "./open.ts";

export interface Column {
  name: string;
  /** As it is headed: field or quantity, and whose it is. */
  label: string;
  unit: string;
  kind: "variable" | "output";
  description: string;
  output: Output | null;
  /** Number that is shown; null where there is none. */
  number(row: Row): number | null;
  /** As it is read in a table. */
  text(row: Row): string;
}

export type Brushes = Readonly<Record<string, readonly [number, number]>>;

/** Digits that are shown: more than these are not told apart by eye, and a certainty has fewer. */
const DIGITS = 5;

export function shown(value: number, digits = DIGITS): string {
  return Math.abs(value) >= 1e5 || (value !== 0 && Math.abs(value) < 1e-3)
    ? value.toExponential(digits - 2)
    : String(Number(value.toPrecision(digits)));
}

export const variantOf = (row: Row): number => row[0] as number;
export const statusOf = (row: Row): string => row[1] as string;
export const errorOf = (row: Row): string => (row.at(-2) as string) ?? "";

export const capital = (text: string): string => text.charAt(0).toUpperCase() + text.slice(1);

/** Name of a column, and what it is of, as the file has them. */
const told = (name: string, from: string, description: string) =>
  [name === from ? name : `${name}: ${from}`, description].filter(Boolean).join(". ");

/** The verdict on a row stands in a column of its own. */
const isVerdict = ({ output }: Column) => output?.expression.trim() === "passed";

export function columnsOf({ variables, outputs }: Definition): Column[] {
  const column = (at: number, scale: number, decimals: number | null, rest: Omit<Column, "number" | "text">): Column => {
    const number = (row: Row) => {
      const value = row[at];
      return typeof value === "number" ? value / scale : null;
    };
    const text = (row: Row) => {
      const value = number(row);
      if (value !== null) return decimals === null ? shown(value) : value.toFixed(decimals);
      const given = row[at];
      return given === null || given === undefined ? "" : typeof given === "object" ? JSON.stringify(given) : String(given);
    };
    return { ...rest, number, text };
  };
  const all = [
    ...variables.map(({ name, label, unit, scale, description, field }, at) =>
      column(2 + at, scale, null, { name, label, unit, kind: "variable", description: told(name, field, description), output: null })),
    ...outputs.map((output, at) =>
      column(2 + variables.length + at, 1, output.decimals, {
        name: output.name, label: capital([output.label, output.of].filter(Boolean).join(", ")), unit: output.unit === "1" ? "" : output.unit, kind: "output",
        description: told(output.name, output.expression, output.description), output,
      })),
  ];
  return all.filter((one) => !isVerdict(one));
}

/** Lowest and highest value of a column; null where no row has one. */
export function extent(column: Column, rows: readonly Row[]): [number, number] | null {
  let [low, high] = [Infinity, -Infinity];
  for (const row of rows) {
    const value = column.number(row);
    if (value === null) continue;
    if (value < low) low = value;
    if (value > high) high = value;
  }
  if (low > high) return null;
  // What the digits of the ends do not tell apart is one value: a search for a mean force leaves some mN.
  return shown(low) === shown(high) ? [low - (Math.abs(low) || 1) * 0.5, high + (Math.abs(high) || 1) * 0.5] : [low, high];
}

/** Places of the rows that lie within all brushes and have a text in status, error or number. */
export function kept(rows: readonly Row[], columns: readonly Column[], brushes: Brushes, search: string): number[] {
  const limits = columns.flatMap((column) => {
    const brush = brushes[column.name];
    return brush ? [{ column, low: brush[0], high: brush[1] }] : [];
  });
  const wanted = search.trim().toLowerCase();
  const found: number[] = [];
  rows.forEach((row, at) => {
    const inside = limits.every(({ column, low, high }) => {
      const value = column.number(row);
      return value !== null && value >= low && value <= high;
    });
    const fits = !wanted || String(variantOf(row)) === wanted || `${statusOf(row)} ${errorOf(row)}`.toLowerCase().includes(wanted);
    if (inside && fits) found.push(at);
  });
  return found;
}

export interface Order {
  /** Name of a column, `variant`, `status` or `verdict`. */
  by: string;
  down: boolean;
}

/** Places in an order; rows without a value come last either way. */
export function sorted(places: readonly number[], rows: readonly Row[], columns: readonly Column[], { by, down }: Order): number[] {
  const column = columns.find(({ name }) => name === by);
  const sign = down ? -1 : 1;
  const word = by === "status" ? statusOf : by === "verdict" ? (row: Row) => String(row.at(-4)) : null;
  if (word) return [...places].sort((a, b) => sign * word(rows[a]!).localeCompare(word(rows[b]!)));
  const value = (at: number) => (column ? column.number(rows[at]!) : variantOf(rows[at]!));
  const values = new Map(places.map((at) => [at, value(at)]));
  return [...places].sort((a, b) => {
    const [one, other] = [values.get(a) ?? null, values.get(b) ?? null];
    if (one === null || other === null) return (one === null ? 1 : 0) - (other === null ? 1 : 0);
    return sign * (one - other) || a - b;
  });
}
