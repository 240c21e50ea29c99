import { followScheme } from "../charts/colours.ts";
import { addCommand, addPanel, show } from "../shell/panels.ts";
import { acceptDrops } from "./measured.ts";

export function register(): void {
  addPanel({
    id: "space-time",
    slot: "main",
    title: "Space–time",
    order: 30,
    load: async () => (await import("./SpaceTime.tsx")).SpaceTime,
  });
  addPanel({
    id: "results",
    slot: "main", alone: true,
    title: "Results",
    order: 40,
    load: async () => (await import("./Results.tsx")).Results,
  });
  addPanel({
    id: "compare",
    slot: "main", alone: true,
    title: "Compare",
    order: 50,
    load: async () => (await import("./Compare.tsx")).Compare,
  });
  addPanel({
    id: "explanation",
    slot: "main", alone: true,
    title: "Why σ",
    order: 60,
    load: async () => (await import("./Explanation.tsx")).Explanation,
  });
  addCommand({ id: "results", title: "Results of the run", act: () => show("results") });
  addCommand({ id: "compare", title: "Compare what is ticked", keys: ["C"], act: () => show("compare") });
  addCommand({ id: "explanation", title: "Why σ is as it is", act: () => show("explanation") });
  addCommand({ id: "space-time", title: "Space–time view", act: () => show("space-time") });
  followScheme();
  acceptDrops();
}
