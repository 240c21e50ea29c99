/**
 * What the next run changes of its scenario: dotted field → value as typed, with its unit. Whoever
 * offers a field sets it here; nothing of it is in a file until it is saved as a scenario.
 */
import { signal } from "@preact/signals";

export type Changed = string | number | boolean | null | Changed[] | { [key: string]: Changed };
export type Changes = Record<string, Changed>;

/** A value in words. */
export const written = (value: Changed): string =>
  Array.isArray(value) ? `[${value.map(written).join(", ")}]` : typeof value === "object" && value !== null ? JSON.stringify(value) : String(value);

export const changes = signal<Changes>({});

/** Change a field for the next run; the value of the file takes the change back. */
export function change(field: string, value: Changed, ofFile?: string | number | null): void {
  const { [field]: _, ...others } = changes.peek();
  changes.value = value === ofFile || value === "" ? others : { ...others, [field]: value };
}
