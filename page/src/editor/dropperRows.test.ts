import { expect, it } from "vitest";
import { countOf, rowsOf, spanOf, widestGap, without, withOne } from "./dropperRows.ts";
import type { FormField } from "./formData.ts";
import type { Value } from "./patch.ts";

const DROPPERS = "span_types.standard.droppers";

function list(name: string, typed: Value[], value: number[] = typed as number[]): FormField {
  const field = `${DROPPERS}.${name}`;
  const label = name === "presag" ? "Presag" : "Positions";
  return { field, label, typed, value, unit: "m", units: ["m", "mm"], minimum: null, maximum: null, description: "", line: 1, required: true, together: DROPPERS };
}
const LISTS = [list("positions", [4, 10, 20]), list("presag", ["0 mm", "20 mm", "30 mm"], [0, 0.02, 0.03])];
const other = { ...list("positions", [1]), field: "spans", together: null };

it("puts lists of the same droppers together, and leaves all else alone", () => {
  expect(rowsOf([other, ...LISTS, other]).map((all) => all.length)).toEqual([1, 2, 1]);
  expect(spanOf(DROPPERS, [{ ...other, field: "span_types.standard.length", value: 60 }])).toBe(60);
});

it("takes a dropper out of all lists at once, and out of the longer one where they differ", () => {
  expect(without(LISTS, 1)).toEqual({ [`${DROPPERS}.positions.1`]: null, [`${DROPPERS}.presag.1`]: null });
  const broken = [list("positions", [4, 10]), LISTS[1]!];
  expect(countOf(broken)).toBe(3);
  expect(without(broken, 2)).toEqual({ [`${DROPPERS}.presag.2`]: null });
});

it("adds a dropper to all lists at once, between its neighbours, in their units, and says so", () => {
  const found = withOne(LISTS, 1, 30)!;
  expect(found.changes).toEqual({ [`${DROPPERS}.positions`]: [4, 10, 15, 20], [`${DROPPERS}.presag`]: ["0 mm", "20 mm", "25 mm", "30 mm"] });
  expect(found.told).toBe("Dropper 3 added at 15 m: its pre-sag is 25 mm, half way between its neighbours.");
  // At an end half way to the support, as its only neighbour.
  expect(withOne(LISTS, 2, 30)!.told).toBe("Dropper 4 added at 25 m: its pre-sag is 30 mm, as of its neighbour.");
  expect(withOne(LISTS, -1, 30)!.changes[`${DROPPERS}.positions`]).toEqual([2, 4, 10, 20]);
});

it("adds none where there is no place, or where the lists do not fit together", () => {
  expect(withOne(LISTS, 2, null)).toBeNull();
  expect(withOne(LISTS, 2, 20)).toBeNull();
  expect(withOne([list("positions", [4, 10]), LISTS[1]!], 0, 30)).toBeNull();
});

it("finds the widest gap, those to the supports too", () => {
  expect(widestGap(LISTS, 25)).toBe(1);
  expect(widestGap(LISTS, 40)).toBe(2);
  expect(widestGap(LISTS, null)).toBe(1);
});
