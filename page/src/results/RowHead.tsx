/** Head of a row of a comparison: what the row is of, its unit, and which pantograph where there are several. */
import type { Comparison } from "./told.ts";

interface Row {
  unit: string;
  pantograph: string;
}

export function RowHead({ of, row, label }: { of: Comparison; row: Row; label: string }) {
  return (
    <th scope="row">
      {label}
      {row.unit ? `, ${row.unit}` : ""}
      {of.several && row.pantograph ? `, ${row.pantograph}` : ""}
    </th>
  );
}
