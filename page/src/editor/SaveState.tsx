/** Whether what is seen is on the disk, undo and redo, and the way from a shipped model to an own one. */
import { useSignal } from "@preact/signals";
import { ask } from "../connection/http.ts";
import { complain, say } from "../shell/messages.ts";
import { openModel } from "../state/opening.ts";
import { readProject } from "../state/project.ts";
import { isWrong } from "./checking.ts";
import { kind, opened, saving, writable } from "./documents.ts";
import { redo, undo } from "./session.ts";

const WORDS = {
  saved: "Saved",
  waiting: "Saving",
  saving: "Saving",
  "not saved": "Not saved: kept in this browser until the server answers",
  conflict: "Not saved: the file was changed elsewhere",
};

/** Copy a shipped model into the folder, and open the copy. */
async function copy(from: string, name: string): Promise<void> {
  const of = kind.peek();
  try {
    const made = await ask<{ path: string }>("new", { body: { name, from, with_pantographs: of === "scenario" } });
    await readProject();
    openModel(made.path, of);
    say("note", `Copied to ${made.path}`);
  } catch (error) {
    complain(error);
  }
}

export function SaveState() {
  const name = useSignal<string | null>(null);
  const document = opened.value;
  if (!document) return null;
  const shipped = document.path.replace(/^shipped:\w+\//, "");
  return (
    <div class="save-state">
      <span class="path" title={document.path}>
        {document.path}
      </span>
      {writable.value ? (
        <>
          <button onClick={undo} title="Ctrl+Z">
            Undo
          </button>
          <button onClick={redo} title="Ctrl+Shift+Z">
            Redo
          </button>
          <span role="status" class={saving.value === "not saved" || saving.value === "conflict" ? "open" : ""}>
            {WORDS[saving.value]}
            {saving.value === "saved" && isWrong.value && <span class="error">, with an error</span>}
          </span>
        </>
      ) : name.value === null ? (
        <>
          <span>Shipped model, read-only</span>
          {kind.value !== "study" && <button onClick={() => (name.value = `my-${shipped}`)}>Copy to my folder</button>}
        </>
      ) : (
        <form
          onSubmit={(event) => {
            event.preventDefault();
            void copy(document.path, name.value!.trim()).then(() => (name.value = null));
          }}
        >
          <label>
            Name of the copy{" "}
            <input value={name.value} onInput={(event) => (name.value = event.currentTarget.value)} required />
          </label>
          <button type="submit">Copy</button>
          <button type="button" onClick={() => (name.value = null)}>
            Cancel
          </button>
        </form>
      )}
    </div>
  );
}
