/** The file that is edited: form or YAML, what is wrong with it, and whether it is saved. */
import { signal } from "@preact/signals";
import { Conflict } from "./Conflict.tsx";
import { conflict, opened } from "./documents.ts";
import "./editor.css";
import { FormView } from "./FormView.tsx";
import { Problems } from "./Problems.tsx";
import { SaveState } from "./SaveState.tsx";
import { YamlView } from "./YamlView.tsx";

export const face = signal<"form" | "yaml">("form");
/** Whether the text is shown in the main slot, where it is wide. */
export const isLarge = signal(false);

export function Inspector() {
  if (!opened.value) return <p class="empty">Choose a model on the left to change it.</p>;
  if (conflict.value) return <Conflict />;
  return (
    <div class="inspector">
      <SaveState />
      <div class="faces" role="group" aria-label="Shown as">
        <button aria-pressed={face.value === "form"} onClick={() => (face.value = "form")}>
          Form
        </button>
        <button aria-pressed={face.value === "yaml"} onClick={() => (face.value = "yaml")} disabled={isLarge.value}>
          YAML
        </button>
      </div>
      {face.value === "form" || isLarge.value ? <FormView /> : <YamlView />}
      <Problems />
    </div>
  );
}
