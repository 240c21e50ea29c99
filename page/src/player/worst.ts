/** Worst places of the run that is played, as the explanation of its contact force names them. */
import { effect } from "@preact/signals";
import { ask } from "../connection/http.ts";
import { source } from "../state/selection.ts";
import { wentTo, worst, type WorstPlace } from "../state/worst.ts";

interface Explained {
  pantographs: { worst: { position_m: number; force_N?: number }[] }[];
}

/** Ask for the worst places of each run that is played. */
export function followWorst(): void {
  effect(() => {
    const of = source.value;
    worst.value = [];
    wentTo.value = null;
    if (!of || !("run" in of)) return;
    // A run that is too short has no explanation: J and K then have nowhere to go.
    void ask<Explained>("explain", { query: { run: of.run } })
      .then(({ pantographs }) => {
        if (source.peek() !== of) return;
        const all = pantographs.flatMap((one) => one.worst);
        const places = new Map(all.map(({ position_m, force_N = null }): [number, WorstPlace] => [position_m, { position_m, force_N }]));
        worst.value = [...places.values()].sort((a, b) => a.position_m - b.position_m);
      })
      .catch(() => undefined);
  });
}
