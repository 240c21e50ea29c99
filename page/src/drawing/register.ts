import { addCommand, addPanel } from "../shell/panels.ts";
import { drawFailed } from "./failedMark.ts";
import { drawPlace } from "./placeMark.ts";
import { addLayer } from "./scene.ts";

const act = (name: "fit" | "more" | "less") => () =>
  void import("./fit.ts").then(({ fit, exaggerate }) => (name === "fit" ? fit() : exaggerate(name === "more")));

export function register(): void {
  addPanel({
    id: "drawing",
    slot: "main",
    title: "Line",
    order: 0,
    load: async () => (await import("./Drawing.tsx")).Drawing,
  });
  for (const view of ["side", "plan"] as const) {
    addLayer({ id: `failed, ${view}`, order: 2, view, draw: drawFailed });
    addLayer({ id: `place, ${view}`, order: 3, view, draw: drawPlace });
  }
  addCommand({ id: "fit", title: "Show all of the line", keys: ["F"], act: act("fit") });
  addCommand({ id: "exaggerate", title: "Draw heights larger", keys: ["E"], act: act("more") });
  addCommand({ id: "exaggerate-less", title: "Draw heights smaller", keys: ["Shift+E"], act: act("less") });
}
