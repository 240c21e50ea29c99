/**
 * Contact force of a stored run for strips, thinned by the server to columns of pixels: lowest and
 * highest value each. Positions in m, forces in N.
 */
import { effect } from "@preact/signals";
import { askBytes } from "../../connection/http.ts";
import { source } from "../../state/selection.ts";
import { scene } from "../player.ts";
import { NONE, stored, type Column } from "./columns.ts";

/** Of the whole run: two a pixel of a span that fills the screen would be more than is seen. */
const POINTS = 20_000;

/** Bytes of `api/series`: x, lowest, highest, one after the other. */
export function columnOf(bytes: ArrayBuffer): Column {
  const all = new Float32Array(bytes);
  const count = all.length / 3;
  return { x: all.subarray(0, count), low: all.subarray(count, 2 * count), high: all.subarray(2 * count) };
}

/** Ask for the forces of each stored run that is played. */
export function followSeries(): void {
  effect(() => {
    const of = source.value;
    const count = scene.value?.pantographs.length ?? 0;
    stored.value = NONE;
    if (!of || !("run" in of)) return;
    const column = (name: string, number: number) =>
      askBytes("series", { query: { run: of.run, name, column: number, x: "position", points: POINTS } })
        .then(columnOf)
        // Without them the strips show what was played.
        .catch(() => null);
    const all = (name: string) => Promise.all(Array.from({ length: count }, (_, number) => column(name, number)));
    void Promise.all([all("contact_force"), all("filtered_contact_force")]).then(([raw, filtered]) => {
      if (source.peek() === of) stored.value = { raw, filtered };
    });
  });
}
