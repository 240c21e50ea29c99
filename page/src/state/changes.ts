/**
 * What the next run changes of its scenario: dotted field → value as typed, with its unit. Whoever
 * offers a field sets it here; nothing of it is in a file until it is saved as a scenario.
 */
import { signal } from "@preact/signals";

type Scalar = string | number | boolean | null;
/** As typed; a list such as pre-sags is whole. */
export type Typed = Scalar | Scalar[];
export type Changes = Record<string, Typed>;

/** A value in words. */
export const written = (value: Typed): string => (Array.isArray(value) ? `[${value.join(", ")}]` : String(value));

export const changes = signal<Changes>({});

/** Change a field for the next run; the value of the file takes the change back. */
export function change(field: string, value: Typed, ofFile?: Typed): void {
  const { [field]: _, ...others } = changes.peek();
  changes.value = value === ofFile || value === "" ? others : { ...others, [field]: value };
}
