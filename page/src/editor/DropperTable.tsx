/** Droppers of a span type as a table: a row each, with all that the file has of it in separate lists. */
import { complain, say } from "../shell/messages.ts";
import { writable } from "./documents.ts";
import { countOf, widestGap, withOne, without } from "./dropperRows.ts";
import type { FormField } from "./formData.ts";
import { Cell } from "./ListField.tsx";
import { patch } from "./patch.ts";
import { About, problemsOf } from "./ValueField.tsx";

interface Props {
  lists: readonly FormField[];
  /** Length of the span in m. */
  span: number | null;
}

const titleOf = ({ label }: FormField) => label.replace(/^Presag$/, "Pre-sag").replace(/s$/, "");

export function DropperTable({ lists, span }: Props) {
  const disabled = !writable.value;
  const count = countOf(lists);
  const remove = (row: number) => void patch(without(lists, row)).catch(complain);
  const add = (after: number) => {
    const found = withOne(lists, after, span);
    if (!found) return say("warning", "No dropper was added: there is no place for one, or the lists do not fit together.");
    patch(found.changes).then(() => say("note", found.told), complain);
  };
  return (
    <fieldset class="list droppers">
      <legend>Droppers (m unless typed)</legend>
      <table>
        <thead>
          <tr>
            <th scope="col">Number</th>
            {lists.map((own) => (
              <th scope="col" key={own.field} title={own.description}>{titleOf(own)}</th>
            ))}
            <th scope="col">
              <span class="visually-hidden">Add or remove</span>
            </th>
          </tr>
        </thead>
        <tbody>
          {Array.from({ length: count }, (_, row) => (
            <tr key={row}>
              <th scope="row">{row + 1}</th>
              {lists.map((own) => {
                const value = Array.isArray(own.typed) ? own.typed[row] : undefined;
                const field = `${own.field}.${row}`;
                return (
                  <td key={own.field} data-field={field}>
                    {value === undefined
                      ? <span class="soft">missing</span>
                      : <Cell field={field} value={value} label={`${titleOf(own)} of dropper ${row + 1}`} disabled={disabled} canVary={false} />}
                  </td>
                );
              })}
              <td>
                <button disabled={disabled} aria-label={`Remove dropper ${row + 1}`} title="Remove this dropper" onClick={() => remove(row)}>×</button>
                <button disabled={disabled} aria-label={`Add a dropper after dropper ${row + 1}`} title="Add a dropper after this one" onClick={() => add(row)}>+</button>
              </td>
            </tr>
          ))}
        </tbody>
      </table>
      <button disabled={disabled} title="In the widest gap" onClick={() => add(widestGap(lists, span))}>
        Add a dropper
      </button>
      {lists.map((own) => (
        <About key={own.field} own={own} problems={problemsOf(own.field)} />
      ))}
    </fieldset>
  );
}
