/** What of the open study is looked at: columns, brushes, filter, order, colour. */
import { computed, effect, signal } from "@preact/signals";
import { columnsOf, kept, sorted, type Brushes, type Order } from "./columns.ts";
import { about, count, current, progress, rows } from "./open.ts";
import { limitsOf, NOT_JUDGED, verdictOf, type Limit } from "./verdicts.ts";

export const columns = computed(() => (about.value ? columnsOf(about.value) : []));
export const brushes = signal<Brushes>({});
export const search = signal("");
export const order = signal<Order>({ by: "variant", down: false });
/** Name of the column that colours lines and points. */
export const colouredBy = signal<string | null>(null);

/** Columns with a number in some row. */
export const axes = computed(() => {
  void count.value;
  return columns.value.filter((column) => rows.some((row) => column.number(row) !== null));
});
/** Criteria of the rows that are there. */
export const criteria = computed(() => progress.value?.criteria ?? []);
export const isJudged = computed(() => {
  void count.value;
  return rows.some((row) => verdictOf(row) !== NOT_JUDGED);
});
/** Limits by column. */
export const limits = computed((): Record<string, Limit[]> => {
  void count.value;
  return Object.fromEntries(columns.value.map((column) => [column.name, limitsOf(column, rows, criteria.value)]));
});
/** Only rows that meet all limits. */
export const onlyMet = signal(false);
export const places = computed(() => {
  void count.value;
  const found = kept(rows, columns.value, brushes.value, search.value);
  return onlyMet.value ? found.filter((at) => verdictOf(rows[at]!) === "met") : found;
});
export const inOrder = computed(() => sorted(places.value, rows, columns.value, order.value));

export function brush(name: string, range: readonly [number, number] | null): void {
  const { [name]: _old, ...others } = brushes.peek();
  brushes.value = range ? { ...others, [name]: range } : others;
}

// Another study has other columns.
effect(() => {
  void current.value;
  brushes.value = {};
  search.value = "";
  onlyMet.value = false;
  order.value = { by: "variant", down: false };
  colouredBy.value = null;
});
