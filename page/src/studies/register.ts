import { computed } from "@preact/signals";
import { addCommand, addPanel, show } from "../shell/panels.ts";
import { selected } from "../state/selection.ts";
import { face, varyField } from "./vary.ts";

export function register(): void {
  addPanel({ id: "studies", slot: "main", alone: true, title: "Studies", order: 55, load: async () => (await import("./Studies.tsx")).Studies });
  addCommand({ id: "studies.define", title: "Define a study", act: () => ((face.value = "define"), show("studies")) });
  addCommand({ id: "studies.watch", title: "Watch a study", act: () => ((face.value = "watch"), show("studies")) });
  addCommand({
    id: "studies.vary",
    title: "Vary the selected field in a study",
    when: computed(() => selected.value?.kind === "field"),
    act: () => {
      const chosen = selected.peek();
      if (chosen?.kind === "field") varyField(chosen.field);
    },
  });
}
