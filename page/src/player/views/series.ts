/**
 * Contact force of a stored run for strips, thinned by the server to columns of pixels: lowest and
 * highest value each. Of the whole run, and finer of the part that is seen. Positions in m, forces in N.
 */
import { effect } from "@preact/signals";
import { askBytes, newest } from "../../connection/http.ts";
import { sight } from "../../drawing/scene.ts";
import { source } from "../../state/selection.ts";
import { scene } from "../player.ts";
import { NONE, stored, topOf, widest, type Column, type Stored } from "./columns.ts";

/** Values of the whole run, and of a part: a screen has fewer pixels, and a part is wider than it. */
const POINTS = 20_000;
/** Places farther apart than this share of what is seen, some pixels, are seen as steps. */
const COARSE = 1 / 300;
/** What is asked for begins and ends so many lengths beside what is seen: a clock that plays moves it on. */
const BESIDE = 2;
/** Nearer than so many lengths to the end of what is there, more is asked for. */
const NEAR = 0.5;
/** After the range has changed, in ms. */
const REST = 150;

type Range = [number, number];

/** Bytes of `api/series`: x, lowest, highest, one after the other. */
export function columnOf(bytes: ArrayBuffer): Column {
  const all = new Float32Array(bytes);
  const count = all.length / 3;
  return { x: all.subarray(0, count), low: all.subarray(count, 2 * count), high: all.subarray(2 * count) };
}

/** The part to ask for; "whole" where that is fine enough for what is seen, `null` where the part that is there is. */
export function wantedPart(seen: Range, whole: Stored, part: Range | null): Range | "whole" | null {
  const length = seen[1] - seen[0];
  const isFine = whole.raw.every((column) => !column || widest(column, seen) <= COARSE * length);
  // Asked anew before its end is seen, and where much less is seen than when it was asked for.
  const near = NEAR * length;
  const isWide = part && part[0] <= seen[0] - near && part[1] >= seen[1] + near;
  const holds = isWide && part[1] - part[0] <= 2 * (2 * BESIDE + 1) * length;
  if (isFine) return "whole";
  return holds ? null : [seen[0] - BESIDE * length, seen[1] + BESIDE * length];
}

async function columns(run: string, count: number, part: Range | null, signal?: AbortSignal): Promise<Omit<Stored, "top">> {
  const among = part ? { from: part[0], to: part[1] } : {};
  const column = (name: string, number: number) =>
    askBytes("series", { query: { run, name, column: number, x: "position", points: POINTS, ...among }, ...(signal ? { signal } : {}) })
      .then(columnOf)
      // Without them the strips show what was played.
      .catch(() => null);
  const all = (name: string) => Promise.all(Array.from({ length: count }, (_, number) => column(name, number)));
  const [raw, filtered] = await Promise.all([all("contact_force"), all("filtered_contact_force")]);
  return { raw, filtered };
}

/** Keep a finer part of what is seen, until the returned function is called. */
function followPart(run: string, count: number, whole: Stored): () => void {
  let part: Range | null = null;
  let timer: ReturnType<typeof setTimeout> | undefined;
  const answer = newest((signal: AbortSignal, wanted: Range) => columns(run, count, wanted, signal));
  const use = (next: Range | null, columns: Stored) => {
    part = next;
    stored.value = columns;
  };
  const look = async () => {
    timer = undefined;
    const wanted = wantedPart(sight.peek(), whole, part);
    if (wanted === "whole" && part) use(null, whole);
    if (!wanted || wanted === "whole") return;
    const found = await answer(wanted);
    if (!found || isOver || !found.raw.some((column) => column?.x.length)) return;
    use(wanted, { ...found, top: whole.top });
  };
  let isOver = false;
  const end = effect(() => {
    const [from, to] = sight.value;
    // Some of what is seen lies beyond the part: the whole is coarse, and better than nothing.
    if (part && (from < part[0] || to > part[1])) use(null, whole);
    timer ??= setTimeout(() => void look(), REST);
  });
  return () => {
    isOver = true;
    clearTimeout(timer);
    end();
  };
}

/** Ask for the forces of each stored run that is played. */
export function followSeries(): void {
  effect(() => {
    const of = source.value;
    const count = scene.value?.pantographs.length ?? 0;
    stored.value = NONE;
    if (!of || !("run" in of)) return;
    let end: (() => void) | null = null;
    let isOver = false;
    void columns(of.run, count, null).then((found) => {
      if (isOver) return;
      const whole = { ...found, top: topOf(found.raw) };
      stored.value = whole;
      end = followPart(of.run, count, whole);
    });
    return () => {
      isOver = true;
      end?.();
    };
  });
}
