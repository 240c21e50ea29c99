/** Commands of the window itself, and what its title says. */
import { computed, effect, signal } from "@preact/signals";
import { connection } from "../connection/stream.ts";
import { jobs } from "../state/jobs.ts";
import { project } from "../state/project.ts";
import { followKeys } from "./keys.ts";
import { fold, remember } from "./layout.ts";
import { toOrFromProject } from "./places.ts";
import { addCommand } from "./panels.ts";
import { followScheme, nextScheme, scheme } from "./scheme.ts";

export type DialogName = "commands" | "keys";
export const dialog = signal<DialogName | null>(null);
export const listed = signal(false);

const running = computed(() => jobs.value.find((one) => one.state === "running"));

/** Title of the browser's tab: what is going on, and the folder. */
export const title = computed(() => {
  const folder = project.value?.name ?? "Arcless studio";
  if (connection.value === "lost") return `No server · ${folder}`;
  return running.value ? `${Math.round(100 * running.value.fraction)} % · ${folder}` : `${folder} · Arcless studio`;
});

export function register(): void {
  addCommand({ id: "palette", title: "Commands", keys: ["Ctrl+K"], act: () => (dialog.value = "commands") });
  addCommand({ id: "help", title: "Keys", keys: ["?"], act: () => (dialog.value = "keys") });
  addCommand({
    id: "scheme",
    get title() {
      return `Theme: ${scheme.value} (light, dark, or as the system)`;
    },
    act: nextScheme,
  });
  addCommand({ id: "fold left", title: "Show or hide the project", act: () => fold("left") });
  addCommand({ id: "project", title: "Go to the project; from there, hide it", keys: ["Ctrl+B"], act: toOrFromProject });
  addCommand({ id: "fold right", title: "Show or hide the inspector", keys: ["Ctrl+I"], act: () => fold("right") });
  addCommand({ id: "fold below", title: "Show or hide the strips", act: () => fold("below") });
  addCommand({ id: "messages", title: "Messages", act: () => (listed.value = !listed.peek()) });
  remember();
  followKeys(() => dialog.peek() !== null);
  followScheme();
  effect(() => void (document.title = title.value));
}
