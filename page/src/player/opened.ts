/** Follows what shall be played: asks for its line, opens its motion on the stream. */
import { effect } from "@preact/signals";
import { ask } from "../connection/http.ts";
import type { Geometry } from "../drawing/geometry.ts";
import { complain, say } from "../shell/messages.ts";
import { raise, shown } from "../shell/panels.ts";
import { jobs } from "../state/jobs.ts";
import { clock, source, type Source } from "../state/selection.ts";
import { follow, setEnds } from "./clock.ts";
import { Pull, type Opened } from "./motion/pull.ts";
import { asking, begin, fits, history, pace, present, rate, scene, store, wake, type Scene } from "./player.ts";

let current: Pull | null = null;

/** Heads of a pantograph's values: position, force, height, uplift; then its masses. */
const HEAD = 4;

function pantographs(about: Opened) {
  return about.channels
    .filter(({ name }) => name.startsWith("pantograph."))
    .map((channel, number) => ({
      name: channel.about.name ?? `Pantograph ${number + 1}`,
      masses: (channel.about.values ?? []).slice(HEAD).map(({ name }) => name),
    }));
}

/** Source whose line is known, and that line. */
let line: { of: Source; geometry: Geometry } | null = null;

async function lineOf(of: Source): Promise<Geometry> {
  const query = "run" in of ? { path: of.run } : { job: of.job };
  if (line?.of !== of) line = { of, geometry: await ask<Geometry>("run/line", { query }) };
  return line.geometry;
}

async function opened(of: Source, about: Opened): Promise<void> {
  try {
    const geometry = await lineOf(of);
    if (current?.source !== of) return;
    const known = scene.peek();
    const next: Scene = {
      geometry, pantographs: pantographs(about), row_s: about.every_s, wires: about.wires, search: about.search ?? null,
    };
    // Of a run that has ended its line is asked for again, and is the same: drawn is the one that was.
    if (known && fits(known, next)) next.geometry = known.geometry;
    // What was kept has no wires, and these move; or the other way round; or it is of another mesh.
    if (known && (about.wires !== known.wires || !fits(known, next))) store.clear();
    present(next, about.start_s, about.end_s, !about.final);
    if (!known) toTheLine();
    if (!known && !about.final && !isStill()) follow();
  } catch (error) {
    if (current?.source === of) complain(error);
  }
}

/** Whoever wants little motion starts it by hand: a run is then not followed by itself. */
const isStill = (): boolean => matchMedia("(prefers-reduced-motion: reduce)").matches;

/** A run is seen in place of the first screen; other panels stay. It may have been opened by itself, while somebody reads the tree of a phone. */
function toTheLine(): void {
  const now = shown.peek().main;
  if (now === undefined || now === "start") raise("drawing");
}

function edge(end: number, final: boolean): void {
  pace.reached(end, performance.now());
  setEnds(clock.start_s.peek(), end, !final);
  // Frames between a clock that slept and the edge were missed; nobody waits for them.
  if (clock.live.peek() && end - clock.time_s.peek() > 4 * rate()) clock.time_s.value = end;
  wake();
}

/** There is no more of a source; of a job that failed, or was lost with its server, its end is told already. */
function closed(of: Source, text: string): void {
  const job = "job" in of ? jobs.peek().find((one) => one.id === of.job) : undefined;
  if (!job || job.state === "done") say("error", text);
  if (!scene.peek()) return;
  const last = store.track("pantograph.0").times.at(-1) ?? clock.start_s.peek();
  setEnds(clock.start_s.peek(), last, false);
  wake();
}

function open(of: Source): Pull {
  pace.forget();
  const pull = new Pull(of, store, history, {
    opened: (about) => void opened(of, about),
    edge,
    changed: wake,
    failed: (text) => say("error", text),
    closed: (text) => closed(of, text),
  });
  asking.current = () => {
    const now = scene.peek();
    if (!now) return;
    pull.update({
      time: clock.time_s.peek(), rate: rate(), start: clock.start_s.peek(), edge: clock.end_s.peek(), row: now.row_s,
    });
  };
  return pull;
}

/** Whether a run is what a job, which was played until now, has computed: clock and frames stay. */
function isEndOf(before: Source | null, of: Source | null): boolean {
  if (!before || !of || !("job" in before) || !("run" in of)) return false;
  return jobs.peek().some(({ id, path }) => id === before.job && path === of.run);
}

/** Have what `source` names played, from now on. */
export function followSource(): void {
  let before: Source | null = null;
  effect(() => {
    const of = source.value;
    current?.close();
    asking.current = null;
    current = null;
    if (!isEndOf(before, of)) begin();
    before = of;
    if (of) current = open(of);
  });
}
