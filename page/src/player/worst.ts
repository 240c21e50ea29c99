/** Worst places of the run that is played, as the explanation of its contact force names them. */
import { effect } from "@preact/signals";
import { ask } from "../connection/http.ts";
import { source } from "../state/selection.ts";
import { worst } from "./places.ts";

interface Explained {
  pantographs: { worst: { position_m: number }[] }[];
}

/** Ask for the worst places of each run that is played. */
export function followWorst(): void {
  effect(() => {
    const of = source.value;
    worst.value = [];
    if (!of || !("run" in of)) return;
    // A run that is too short has no explanation: J and K then have nowhere to go.
    void ask<Explained>("explain", { query: { run: of.run } })
      .then(({ pantographs }) => {
        if (source.peek() !== of) return;
        const all = pantographs.flatMap((one) => one.worst.map((place) => place.position_m));
        worst.value = [...new Set(all)].sort((a, b) => a - b);
      })
      .catch(() => undefined);
  });
}
