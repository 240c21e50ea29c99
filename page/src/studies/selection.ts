/** What of the open study is looked at: columns, brushes, filter, order, colour. */
import { computed, effect, signal } from "@preact/signals";
import { columnsOf, kept, sorted, type Brushes, type Order } from "./columns.ts";
import { about, count, current, rows } from "./open.ts";

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
export const places = computed(() => {
  void count.value;
  return kept(rows, columns.value, brushes.value, search.value);
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
  order.value = { by: "variant", down: false };
  colouredBy.value = null;
});
