/** A button beside a number of a model: the field is varied in the study that is being defined, or no more. */
import { leave, varied } from "./defining.ts";
import { isAsked, varyField } from "./vary.ts";

export function VaryButton({ field, label }: { field: string; label: string }) {
  const own = varied.value.find((one) => isAsked(one.field, field));
  const words = own ? `Do not vary ${label} in the study` : `Vary ${label} in a study`;
  return (
    <button type="button" class="vary" aria-pressed={own !== undefined} aria-label={words} title={words}
      onClick={() => (own ? leave(own.field) : varyField(field))}>
      <span aria-hidden="true">↕</span>
    </button>
  );
}
