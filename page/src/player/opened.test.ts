// @vitest-environment happy-dom
import { beforeEach, describe, expect, test, vi } from "vitest";
import type { Frame, Message } from "../connection/stream.ts";
import { addPanel, part, shown } from "../shell/panels.ts";
import { jobs, type Job } from "../state/jobs.ts";
import { clock, source, type Source } from "../state/selection.ts";
import { followSource } from "./opened.ts";
import { scene, state, store, wake } from "./player.ts";

const server = vi.hoisted(() => ({
  hearers: new Map<string, Set<(message: Message) => void>>(),
  takers: new Map<number, (frame: Frame) => void>(),
}));

vi.mock("../connection/stream.ts", () => ({
  connection: { peek: () => "open" },
  tell: () => undefined,
  hear: (topic: string, act: (message: Message) => void) => {
    const all = server.hearers.get(topic) ?? new Set();
    server.hearers.set(topic, all.add(act));
    return () => void all.delete(act);
  },
  take: (number: number, act: (frame: Frame) => void) => {
    server.takers.set(number, act);
    return () => void server.takers.delete(number);
  },
  whenOpen: () => () => undefined,
}));
vi.mock("../connection/http.ts", () => ({
  ask: () => Promise.resolve({ name: "line", spatial: false, height_m: 5, spans: [], wires: [], droppers: [], supports: [] }),
}));

const say = (message: Message) => server.hearers.get(message.topic)?.forEach((act) => act(message));
const frame = (channel: number, time: number, x: number) =>
  server.takers.get(channel)?.({ channel, first: 0, time, values: Float32Array.of(x, 100, 5, NaN) });

async function announce(of: Source, number: number, more: Partial<Record<string, unknown>>): Promise<void> {
  say({
    topic: "channels", source: of, start_s: 0, end_s: 10, final: true, every_s: 0.01, wires: true, search: null,
    channels: [{ number, name: "pantograph.0", unit: "", shape: [4], about: {} }], ...more,
  });
  await vi.waitFor(() => expect(scene.peek()).not.toBe(null));
  await Promise.resolve();
}

const drawn = () => new Promise((done) => (wake(), requestAnimationFrame(() => requestAnimationFrame(done))));
const job = (path: string | null): Job =>
  ({ id: "j", kind: "run", title: "a", state: "done", fraction: 1, doing: "done", path, notes: [] });

/** A job has been played to its end: the pantograph stands at 800 m, 9.99 s. */
async function watched(): Promise<void> {
  source.value = { job: "j" };
  await announce({ job: "j" }, 1, { final: false });
  for (const time of [9.98, 9.99, 10]) frame(1, time, 800 + time - 9.99);
  [clock.live.value, clock.playing.value, clock.time_s.value] = [false, false, 9.99];
  await drawn();
  expect(state.current.pantographs[0]?.position).toBeCloseTo(800);
}

followSource();
beforeEach(() => {
  source.value = null;
  jobs.value = [];
});

describe("a run that was watched and has ended", () => {
  test("is replayed from where the clock stands, and never without a picture", async () => {
    await watched();
    jobs.value = [job("runs/a")];
    source.value = { run: "runs/a" };
    await drawn();
    expect([clock.time_s.peek(), state.current.pantographs[0]?.position]).toEqual([9.99, 800]);
    await announce({ run: "runs/a" }, 2, { every_s: 0.02 });
    await drawn();
    expect([clock.time_s.peek(), state.current.pantographs[0]?.position, scene.peek()?.row_s]).toEqual([9.99, 800, 0.02]);
  });

  test("whose wires have no stored motion is drawn from the new frames alone", async () => {
    await watched();
    jobs.value = [job("runs/a")];
    source.value = { run: "runs/a" };
    await announce({ run: "runs/a" }, 2, { wires: false });
    await vi.waitFor(() => expect(scene.peek()?.wires).toBe(false));
    expect([clock.time_s.peek(), store.moments.length]).toEqual([9.99, 0]);
  });

  test("gives way to another run, which begins at its start", async () => {
    await watched();
    jobs.value = [job("runs/a")];
    source.value = { run: "runs/b" };
    expect([clock.time_s.peek(), store.moments.length, scene.peek()]).toEqual([0, 0, null]);
  });
});

test("an attempt that begins again has clock, place and frames of its own", async () => {
  source.value = { job: "j" };
  await announce({ job: "j" }, 1, { final: false, end_s: 5, search: 1 });
  for (const time of [4.98, 4.99, 5]) frame(1, time, 400);
  await drawn();
  expect([scene.peek()?.search, clock.time_s.peek()]).toEqual([1, 5]);
  await announce({ job: "j" }, 2, { final: false, end_s: 0, search: 2, again: true });
  await vi.waitFor(() => expect(scene.peek()?.search).toBe(2));
  frame(1, 4.97, 399); // of the old attempt, on its way
  await drawn();
  expect([clock.time_s.peek(), clock.live.peek(), state.current.pantographs[0]?.position]).toEqual([0, true, NaN]);
  frame(2, 0, 3);
  await drawn();
  expect([clock.time_s.peek(), state.current.pantographs[0]?.position]).toEqual([0, 3]);
});

test("a run that is opened stands in place of the first screen, and moves nobody out of the tree of a phone", async () => {
  for (const id of ["start", "drawing"]) addPanel({ id, slot: "main", title: id, order: 0, load: async () => () => null });
  shown.value = { main: "start" };
  part.value = "left";
  source.value = { run: "runs/a" };
  await announce({ run: "runs/a" }, 2, {});
  expect([shown.peek().main, part.peek()]).toEqual(["drawing", "left"]);
});
