import { computed, signal } from "@preact/signals";
import { addCommand, addPanel, show } from "../shell/panels.ts";
import { subject } from "../state/subject.ts";

/** Whether a session runs: its code is loaded with the panel. */
const isOn = signal(false);

export function register(): void {
  addPanel({
    id: "hands on",
    slot: "main",
    title: "Hands on",
    order: 60,
    when: computed(() => subject.value !== null || isOn.value),
    load: async () => {
      const [{ HandsOn }, session] = await Promise.all([import("./HandsOn.tsx"), import("./session.ts")]);
      session.phase.subscribe((phase) => void (isOn.value = phase === "on"));
      return HandsOn;
    },
  });
  addCommand({ id: "hands on", title: "Feel the line: a session in real time", act: () => show("hands on"), when: computed(() => subject.value !== null) });
  addCommand({ id: "hands on.gust", title: "Let a gust blow", keys: ["G"], when: isOn, act: () => void import("./session.ts").then(({ blow }) => blow()) });
}
