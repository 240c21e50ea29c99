import { beforeEach, describe, expect, test, vi } from "vitest";
import type { Frame, Message } from "../../connection/stream.ts";
import { History } from "./history.ts";
import { Pull, type Opened } from "./pull.ts";
import { Store } from "./store.ts";

/** A server that does what a test says. */
const server = vi.hoisted(() => ({
  told: [] as Message[],
  hearers: new Map<string, Set<(message: Message) => void>>(),
  takers: new Map<number, (frame: Frame) => void>(),
  opened: new Set<() => void>(),
}));

vi.mock("../../connection/stream.ts", () => ({
  connection: { peek: () => "open" },
  tell: (message: Message) => void server.told.push(message),
  hear: (topic: string, act: (message: Message) => void) => {
    const all = server.hearers.get(topic) ?? new Set();
    server.hearers.set(topic, all.add(act));
    return () => void all.delete(act);
  },
  take: (number: number, act: (frame: Frame) => void) => {
    server.takers.set(number, act);
    return () => void server.takers.delete(number);
  },
  whenOpen: (act: () => void) => {
    server.opened.add(act);
    act();
    return () => void server.opened.delete(act);
  },
}));

const source = { run: "runs/a" };
const say = (message: Message) => server.hearers.get(message.topic)?.forEach((act) => act(message));
const announce = (first: number, again = false) =>
  say({
    topic: "channels", source, again, start_s: 0, end_s: 10, final: true, every_s: 0.01, wires: true,
    channels: [{ number: first, name: "pantograph.0", unit: "", shape: [5], about: {} }],
  });
const frame = (number: number, time: number) =>
  server.takers.get(number)?.({ channel: number, first: 0, time, values: Float32Array.of(10 * time, 100, 5, NaN) });
const wants = () => server.told.filter((one) => one.topic === "want");
const answer = (dropped = 0, to_s?: number) => {
  const { ask, from_s, to_s: end } = wants().at(-1)!;
  say({ topic: "sent", source, ask, from_s, to_s: to_s ?? end, frames: 1, dropped });
};
const now = { time: 0, rate: 1, start: 0, edge: 10, row: 0.01 };

let opened: Opened[];
let closed: string[];
let pull: Pull;
let store: Store;

beforeEach(() => {
  for (const one of [server.hearers, server.takers, server.opened]) one.clear();
  server.told.length = 0;
  opened = [];
  closed = [];
  store = new Store();
  pull = new Pull(source, store, new History(), {
    opened: (about) => void opened.push(about), edge: () => undefined, changed: () => undefined, failed: () => undefined,
    closed: (text) => void closed.push(text),
  });
});

describe("a motion that is pulled", () => {
  test("that a new server does not know is asked for no more", () => {
    announce(7);
    frame(7, 0.5);
    for (const act of server.opened) act();
    say({ topic: "error", source, about: "play", text: "there is no such job" });
    pull.update(now);
    expect(wants()).toEqual([]);
    expect(closed).toEqual(["there is no such job"]);
    expect(store.moments).toEqual([0.5]);
  });

  test("is opened, asked for once at a time, and stored", () => {
    expect(server.told).toEqual([{ topic: "play", source }]);
    pull.update(now);
    expect(wants()).toEqual([]);
    announce(7);
    expect(opened.length).toBe(1);
    pull.update(now);
    pull.update({ ...now, time: 0.2 });
    expect(wants().map(({ from_s, to_s }) => [from_s, to_s])).toEqual([[0, 1.5]]);
    frame(7, 0.5);
    expect(store.moments).toEqual([0.5]);
    answer();
    pull.update(now);
    expect(wants().at(-1)).toMatchObject({ from_s: 1.5, to_s: 3 });
  });

  test("goes on after a lost socket, whose channels have other numbers", () => {
    announce(7);
    pull.update(now);
    server.opened.forEach((act) => act());
    expect(server.told.at(-1)).toEqual({ topic: "play", source });
    announce(3);
    frame(7, 0.1); // of the old socket
    frame(3, 0.2);
    expect(store.moments).toEqual([0.2]);
    pull.update(now);
    expect(wants().length).toBe(2);
  });

  test("a jump replaces the question, an old answer says nothing", () => {
    announce(7);
    pull.update(now);
    const old = wants()[0]!;
    pull.update({ ...now, time: 6 });
    expect(wants().at(-1)).toMatchObject({ from_s: 6, to_s: 7.5 });
    say({ topic: "sent", source, ask: old["ask"], from_s: 0, to_s: 1.5, frames: 9, dropped: 0 });
    expect(store.reach(0, 1, 1)).toBe(0);
  });

  test("dropped moments are asked for again, from the gap on", () => {
    announce(7);
    pull.update(now);
    for (const time of [0, 0.016, 0.032, 0.4]) frame(7, time);
    answer(20);
    pull.update(now);
    expect(wants().at(-1)).toMatchObject({ from_s: 0.032 });
  });

  test("an edge with nothing new is asked for once", () => {
    announce(7);
    pull.update({ ...now, time: 10 });
    answer();
    for (let count = wants().length; ; count = wants().length) {
      pull.update({ ...now, time: 10 });
      if (wants().length === count) break;
      answer();
    }
    pull.update({ ...now, time: 10 });
    expect(wants().length).toBeLessThan(6);
  });

  test("forgets what was sent of a run that begins again", () => {
    announce(7);
    frame(7, 0.5);
    announce(8, true);
    expect(store.moments).toEqual([]);
    pull.update(now);
    expect(wants().at(-1)).toMatchObject({ from_s: 0 });
  });

  test("says when it is left", () => {
    announce(7);
    pull.close();
    expect(server.told.at(-1)).toEqual({ topic: "leave", source });
    expect(server.takers.size).toBe(0);
  });
});
