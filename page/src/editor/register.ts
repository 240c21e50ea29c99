/** The editor: its panels, and what follows the file that is selected. Its code is loaded with the first one. */
import { effect, signal } from "@preact/signals";
import { addCommand, addPanel } from "../shell/panels.ts";
import { complain } from "../shell/messages.ts";
import { file } from "../state/selection.ts";
import { followText } from "./checking.ts";
import { opened, writable } from "./documents.ts";
import { followFiles } from "./saving.ts";

const session = () => import("./session.ts");
const isOpen = signal(false);

export function register(): void {
  addPanel({
    id: "inspector",
    slot: "right",
    title: "Fields",
    order: 0,
    load: async () => (await import("./Inspector.tsx")).Inspector,
  });
  addPanel({
    id: "yaml",
    slot: "main", alone: true,
    title: "YAML",
    order: 70,
    when: isOpen,
    load: async () => (await import("./LargeYaml.tsx")).LargeYaml,
  });
  addCommand({ id: "undo", title: "Undo the last change of the file", keys: ["Ctrl+Z"], when: writable, act: () => void session().then(({ undo }) => undo()) });
  addCommand({ id: "redo", title: "Redo a change of the file", keys: ["Ctrl+Shift+Z"], when: writable, act: () => void session().then(({ redo }) => redo()) });
  effect(() => {
    const path = file.value;
    if (path !== null) session().then(({ open }) => open(path), complain);
  });
  effect(() => void (isOpen.value = opened.value !== null));
  followText();
  followFiles();
}
