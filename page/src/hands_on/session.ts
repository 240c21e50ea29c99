/**
 * A session: its socket, what it says, and what is ordered of it. It lives as long as its socket.
 * The line it moves is that of the drawing: played line, motion and pantographs are set here.
 */
import { batch, signal } from "@preact/signals";
import { RefusedError, type Complaint } from "../connection/http.ts";
import { parse } from "../connection/stream.ts";
import { fitted } from "../drawing/camera.ts";
import { size } from "../drawing/fit.ts";
import type { Geometry } from "../drawing/geometry.ts";
import { indexOf } from "../drawing/lineIndex.ts";
import { moved, played, redraw, showing } from "../drawing/scene.ts";
import { newState } from "../player/motion/state.ts";
import { state } from "../player/player.ts";
import { complain, say } from "../shell/messages.ts";
import { exaggeration, range, source } from "../state/selection.ts";
import { subject } from "../state/subject.ts";
import { collector, type Moment } from "./channels.ts";
import { Trace } from "./trace.ts";

export interface Pantograph {
  name: string;
  /** At the start, without lift, N. */
  static_force_N: number;
}

export interface Begun {
  geometry: Geometry;
  pantographs: Pantograph[];
  speed_m_s: number;
  highest: { force_N: number; about: string } | null;
  /** What a user should know, whole sentences. */
  notes: string[];
}

/** Length of the line in m that is seen around the pantographs at first. */
const SIGHT = 130;

export const phase = signal<"off" | "starting" | "on">("off");
export const begun = signal<Begun | null>(null);
/** Of real time: what is wanted, and what the machine reaches; null before it is known. */
export const rate = signal(1);
export const reached = signal<number | null>(null);
/** Offset of each pantograph's static force in N. */
export const offsets = signal<number[]>([]);
/** Peak of the wind in m/s, and duration in s, of a gust. */
export const gust = signal({ wind_m_s: 10, duration_s: 1 });
export const laps = signal(0);
export const moment = signal<Moment | null>(null);
export const trace = new Trace();

let socket: WebSocket | null = null;
let before: { range: [number, number] | null; exaggeration: number } = { range: null, exaggeration: 1 };

function order(value: Record<string, unknown>): void {
  if (socket?.readyState === WebSocket.OPEN) socket.send(JSON.stringify(value));
}

export function setOffset(pantograph: number, force_N: number): void {
  offsets.value = offsets.peek().map((old, at) => (at === pantograph ? force_N : old));
  order({ topic: "offset", pantograph, force_N });
}

export function blow(): void {
  order({ topic: "gust", ...gust.peek() });
}

export function setRate(value: number): void {
  rate.value = value;
  reached.value = null;
  order({ topic: "rate", rate: value });
}

/** Keep the pantographs in sight, at the scale that the user chose. */
function follow({ pantographs }: Moment): void {
  const places = pantographs.map(({ position }) => position);
  const [low, high] = [Math.min(...places), Math.max(...places)];
  const [x0, x1] = range.peek() ?? [0, high - low + SIGHT];
  const middle = (low + high) / 2;
  range.value = [middle - (x1 - x0) / 2, middle + (x1 - x0) / 2];
}

function show(now: Moment): void {
  state.current.pantographs = now.pantographs;
  moved.current = { wires: now.wires, dropper_N: null };
  trace.add(now.time, now.pantographs.map(({ force }) => force));
  batch(() => {
    moment.value = now;
    follow(now);
  });
  redraw();
  requestAnimationFrame(() => order({ topic: "seen" }));
}

function present(told: Begun): (data: ArrayBuffer) => void {
  const { geometry, pantographs } = told;
  const wires = geometry.wires.map((wire) => wire.x.length);
  state.current = newState({
    wires, spatial: geometry.spatial, droppers: geometry.droppers.length,
    supports: geometry.supports.length, pantographs: pantographs.length,
  });
  batch(() => {
    begun.value = told;
    offsets.value = pantographs.map(() => 0);
    played.value = geometry;
    showing.value = "played";
    const [low, high] = indexOf(geometry).z;
    range.value = [0, SIGHT];
    exaggeration.value = fitted([0, SIGHT], high - low, ...(size.current ?? [900, 300]));
    phase.value = "on";
  });
  const take = collector({ pantographs: pantographs.length, wires: wires.length }, show);
  return (data) => take(parse(data));
}

function refuse(error: Complaint, final: boolean): void {
  complain(new RefusedError(400, error, null));
  if (final) stop();
}

/** Begin a session with the scenario that is chosen. */
export function start(): void {
  const path = subject.peek();
  if (path === null || phase.peek() !== "off") return;
  // What was played before is closed: the drawing has one motion.
  source.value = null;
  before = { range: range.peek(), exaggeration: exaggeration.peek() };
  phase.value = "starting";
  trace.clear();
  [laps.value, reached.value] = [0, null];
  const at = new URL("api/hands_on", document.baseURI);
  at.protocol = at.protocol === "https:" ? "wss:" : "ws:";
  const mine = (socket = new WebSocket(at));
  mine.binaryType = "arraybuffer";
  mine.onopen = () => order({ topic: "begin", scenario: path, rate: rate.peek() });
  let take: ((data: ArrayBuffer) => void) | null = null;
  mine.onmessage = ({ data }: MessageEvent<string | ArrayBuffer>) => {
    if (mine !== socket) return;
    if (typeof data !== "string") take?.(data);
    else take = hear(JSON.parse(data) as Record<string, unknown>) ?? take;
  };
  mine.onclose = () => {
    if (mine !== socket) return;
    say("warning", "The session ended: the server closed it.");
    stop();
  };
}

function hear(message: Record<string, unknown>): ((data: ArrayBuffer) => void) | null {
  const { topic } = message;
  if (topic === "begun") return present(message as unknown as Begun);
  if (topic === "pace") reached.value = message["rate"] as number;
  if (topic === "lap") laps.value = message["laps"] as number;
  if (topic === "notice") say("warning", message["text"] as string);
  if (topic === "error") refuse(message["error"] as Complaint, message["final"] === true);
  return null;
}

/** End the session; the drawing has the line of the file again. */
export function stop(): void {
  const mine = socket;
  socket = null;
  mine?.close();
  if (phase.peek() === "off") return;
  const line = begun.peek()?.geometry;
  batch(() => {
    phase.value = "off";
    begun.value = moment.value = null;
    if (line && played.peek() === line) {
      [played.value, moved.current] = [null, null];
      showing.value = "edited";
      [range.value, exaggeration.value] = [before.range, before.exaggeration];
    }
  });
  state.current = newState({ wires: [], spatial: false, droppers: 0, supports: 0, pantographs: 0 });
  redraw();
}
