/** The first screen, with the shipped models to begin with: of an empty folder, or asked for. */
import { computed, signal } from "@preact/signals";
import { show } from "../shell/panels.ts";
import { project } from "../state/project.ts";

const asked = signal(false);
const isEmpty = computed(() => project.value !== null && project.value.models.length === 0);

export const isOffered = computed(() => isEmpty.value || asked.value);

export function showLibrary(): void {
  asked.value = true;
  show("start");
}
