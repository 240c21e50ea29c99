/** All commands that are offered now, found by typing parts of their names. */
import { useSignal } from "@preact/signals";
import { useMemo } from "preact/hooks";
import { Dialog } from "./Dialog.tsx";
import { Keys } from "./Help.tsx";
import { typedEarly } from "./keys.ts";
import { commands, type Command } from "./panels.ts";
import { dialog } from "./window.ts";

/** Commands in whose titles all words stand, whole titles that begin with them first. */
export function found(all: readonly Command[], typed: string): Command[] {
  const words = typed.toLowerCase().split(/\s+/).filter(Boolean);
  const begins = (one: Command) => Number(one.title.toLowerCase().startsWith(words[0] ?? ""));
  return all
    .filter((one) => words.every((word) => one.title.toLowerCase().includes(word)))
    .sort((a, b) => begins(b) - begins(a));
}

export function Palette() {
  const typed = useSignal(useMemo(typedEarly, []));
  const at = useSignal(0);
  const offered = commands.value.filter((one) => (one.when?.value ?? true) && one.id !== "palette");
  // One name is offered once: a room that knows better has registered it later.
  const all = offered.filter((one, place) => offered.findLastIndex((other) => other.title === one.title) === place);
  const shown = found(all, typed.value);
  const current = Math.min(at.value, shown.length - 1);
  const act = (command: Command | undefined) => {
    if (!command) return;
    dialog.value = null;
    command.act();
  };
  const press = (event: KeyboardEvent) => {
    if (event.key === "Enter") act(shown[current]);
    else if (event.key === "ArrowDown") at.value = Math.min(current + 1, shown.length - 1);
    else if (event.key === "ArrowUp") at.value = Math.max(current - 1, 0);
    else return;
    event.preventDefault();
    document.getElementById(`command-${at.value}`)?.scrollIntoView({ block: "nearest" });
  };
  return (
    <Dialog label="Commands" close={() => (dialog.value = null)}>
      <input
        role="combobox"
        aria-label="Command"
        aria-expanded="true"
        aria-controls="commands"
        aria-activedescendant={shown.length ? `command-${current}` : undefined}
        placeholder="Type a command"
        autocomplete="off"
        autofocus
        value={typed.value}
        onInput={(event) => {
          typed.value = event.currentTarget.value;
          at.value = 0;
        }}
        onKeyDown={press}
      />
      <ul id="commands" class="commands" role="listbox" aria-label="Commands" tabIndex={-1}>
        {shown.map((command, place) => (
          <li
            key={command.id}
            id={`command-${place}`}
            role="option"
            aria-selected={place === current}
            onClick={() => act(command)}
          >
            {command.title}
            <Keys keys={command.keys ?? []} />
          </li>
        ))}
      </ul>
      {shown.length === 0 && <p class="none">No command has these words in its name.</p>}
    </Dialog>
  );
}
