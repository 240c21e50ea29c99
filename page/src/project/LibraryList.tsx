/** The shipped library by kind, with a field that searches it. */
import { useSignal } from "@preact/signals";
import type { ComponentChildren } from "preact";
import type { ModelEntry } from "../state/project.ts";
import { KINDS, matches } from "./words.ts";

interface Given {
  library: ModelEntry[];
  /** Name of the search field, and what stands in it while it is empty. */
  label: string;
  hint: string;
  /** Class of the lists. */
  lists?: string;
  children: (entry: ModelEntry) => ComponentChildren;
}

export function LibraryList({ library, label, hint, lists = "", children }: Given) {
  const typed = useSignal("");
  const found = library.filter((entry) => matches(entry, typed.value));
  return (
    <>
      <input
        type="search"
        class="search"
        aria-label={label}
        placeholder={hint}
        value={typed.value}
        onInput={(event) => (typed.value = event.currentTarget.value)}
      />
      {KINDS.map(([kind, title]) => {
        const all = found.filter((one) => one.kind === kind);
        return (
          all.length > 0 && (
            <div key={kind}>
              <h3>{title}</h3>
              <ul class={lists}>{all.map(children)}</ul>
            </div>
          )
        );
      })}
      {found.length === 0 && <p class="soft">No shipped model has these words in its name or description.</p>}
    </>
  );
}
