/**
 * The one WebSocket to the server. Text frames are messages `{topic, …}`. Binary frames are data of
 * a numbered channel: u32 channel, u32 first, f64 time in s, then singles, all little-endian.
 */
import { signal } from "@preact/signals";

export interface Message {
  topic: string;
  [key: string]: unknown;
}

/** A piece of a channel: its values at a time, of which the first one has the number `first`. */
export interface Frame {
  channel: number;
  first: number;
  time: number;
  values: Float32Array;
}

export const HEADER = 16; // bytes
const FIRST_WAIT = 250; // ms
const LONGEST_WAIT = 5000; // ms
/**
 * The server says something every 2 s (`BEAT_S` of `studio/stream/hub.py`). After so many looks, in
 * ms from one to the next, without a word it does not answer. Looks are counted, not the time: a page
 * that was stopped with its server has not waited. With fewer a server that is busy for a moment is
 * said to be gone; with more the page is silent with it.
 */
const LOOK_EVERY = 1000;
const SILENT_LOOKS = 5;

/** "open", "lost" (closed, or nothing comes; it is being tried again), "new" before the first time. */
export const connection = signal<"new" | "open" | "lost">("new");

const listeners = new Map<string, Set<(message: Message) => void>>();
const channels = new Map<number, (frame: Frame) => void>();
const openers = new Set<() => void>();
let socket: WebSocket | undefined;
let wait = FIRST_WAIT;
let silent = 0;

/** Hear all messages of a topic; the returned function ends it. */
export function hear(topic: string, listener: (message: Message) => void): () => void {
  const all = listeners.get(topic) ?? new Set();
  listeners.set(topic, all.add(listener));
  return () => void all.delete(listener);
}

/** Take the frames of a channel; the returned function ends it. */
export function take(channel: number, taker: (frame: Frame) => void): () => void {
  channels.set(channel, taker);
  return () => void channels.delete(channel);
}

/** Do something whenever the connection is open, now if it is: what was asked for is asked again. */
export function whenOpen(act: () => void): () => void {
  openers.add(act);
  if (connection.peek() === "open") act();
  return () => void openers.delete(act);
}

/** Send a message; without a connection it is dropped, see `whenOpen`. */
export function tell(message: Message): void {
  if (socket?.readyState === WebSocket.OPEN) socket.send(JSON.stringify(message));
}

export function parse(data: ArrayBuffer): Frame {
  const view = new DataView(data);
  return {
    channel: view.getUint32(0, true),
    first: view.getUint32(4, true),
    time: view.getFloat64(8, true),
    values: new Float32Array(data, HEADER),
  };
}

function received(event: MessageEvent<string | ArrayBuffer>): void {
  silent = 0;
  if (connection.peek() !== "open") opened(); // it was stopped, and goes on
  if (typeof event.data !== "string") {
    const frame = parse(event.data);
    channels.get(frame.channel)?.(frame);
    return;
  }
  const message = JSON.parse(event.data) as Message;
  for (const listener of [...(listeners.get(message.topic) ?? [])]) listener(message);
}

function opened(): void {
  wait = FIRST_WAIT;
  silent = 0;
  connection.value = "open";
  for (const act of [...openers]) act();
}

function look(): void {
  if (connection.peek() === "open" && ++silent > SILENT_LOOKS) connection.value = "lost";
}

function dial(): void {
  const at = new URL("api/stream", document.baseURI);
  at.protocol = at.protocol === "https:" ? "wss:" : "ws:";
  socket = new WebSocket(at);
  socket.binaryType = "arraybuffer";
  socket.onmessage = received;
  socket.onopen = opened;
  socket.onclose = () => {
    connection.value = "lost";
    setTimeout(dial, wait);
    wait = Math.min(2 * wait, LONGEST_WAIT);
  };
}

/** Open the socket, and again whenever it is lost. */
export function connect(): void {
  dial();
  setInterval(look, LOOK_EVERY);
}
