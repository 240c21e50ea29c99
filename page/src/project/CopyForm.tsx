/** Asks for the name of a copy of a shipped model, and makes it. */
import { signal } from "@preact/signals";
import type { ModelEntry } from "../state/project.ts";
import { copy, nameFor } from "./copy.ts";

/** Path of the shipped model that is about to be copied, and where that was asked. */
export const copying = signal<{ path: string; at: "tree" | "start" } | null>(null);

/** Letters, digits and what else a file can be called without a folder. */
const NAME = "[\\p{L}\\p{N}_][\\p{L}\\p{N}_ .+=\\-]*";

export function CopyForm({ entry }: { entry: ModelEntry }) {
  const make = async (event: SubmitEvent) => {
    event.preventDefault();
    const given = new FormData(event.currentTarget as HTMLFormElement);
    const name = String(given.get("name")).trim();
    if ((await copy(entry, name, given.has("second"))) !== null) copying.value = null;
  };
  return (
    <form class="copy-form" onSubmit={(event) => void make(event)} onKeyDown={(event) => event.key === "Escape" && (copying.value = null)}>
      <label>
        Name of the copy{" "}
        <input
          name="name"
          defaultValue={nameFor(entry)}
          pattern={NAME}
          title="Letters, digits, blanks, - _ . + ="
          spellcheck={false}
          autocomplete="off"
          required
          ref={(field) => field?.select()}
        />
      </label>
      {entry.kind === "scenario" && (
        <label title="200 m from 250 km/h, 85 m above 120, 15 m above 80, else 8 m: it follows the speed">
          <input type="checkbox" name="second" /> second pantograph, at the spacing of the TSI
        </label>
      )}
      <button type="submit">Copy to my folder</button>
      <button type="button" onClick={() => (copying.value = null)}>Cancel</button>
    </form>
  );
}
