/** A line drawn on a canvas, from the side or in plan, at rest or moved; see `camera` for units. */
import type { Selected } from "../state/selection.ts";
import { ticks, type Camera } from "./camera.ts";
import type { Dropper, Support } from "./geometry.ts";
import { below } from "./lineIndex.ts";
import type { Moved, Pencil } from "./scene.ts";
import { shift, traceWire, type View } from "./wirePath.ts";

const COLOURS = {
  contact: "contact_wire",
  messenger: "messenger_wire",
  auxiliary: "auxiliary_wire",
  stitch: "stitch_wire",
  bridle: "bridle",
} as const;
const CONTACT_WIDTH = 2.4;
const OTHER_WIDTH = 1.4;
// The second wire of twins: hollow in dashes, so that both are seen where one hides the other.
const SECOND_WIDTH = 3;
const HOLLOW = { width: 1.4, dash: [6, 5] };
// Level of detail, in px: droppers and numbers that are nearer to one another are not drawn.
const DROPPER_APART = 3;
const NUMBER_APART = 34;
const TICK_APART = 90;
const HEIGHT_APART = 34;

function wires(pencil: Pencil, view: View, now: Moved | null, colour?: string): void {
  const { context, line, camera } = pencil;
  context.lineJoin = "round";
  // The contact wire last, so that nothing covers it.
  const order = [...line.wires.keys()].sort(
    (a, b) => Number(line.wires[a]!.kind === "contact") - Number(line.wires[b]!.kind === "contact"),
  );
  for (const number of order) {
    const wire = line.wires[number]!;
    context.strokeStyle = pencil.colour(colour ?? COLOURS[wire.kind]);
    context.lineWidth = colour ? 1 : wire.kind === "contact" ? CONTACT_WIDTH : OTHER_WIDTH;
    if (wire.isSecond && !colour) context.lineWidth = SECOND_WIDTH;
    traceWire(context, camera, wire, view, now?.wires[number]);
    if (!wire.isSecond || colour) continue;
    context.strokeStyle = pencil.colour("paper");
    context.lineWidth = HOLLOW.width;
    context.setLineDash(HOLLOW.dash);
    context.stroke();
    context.setLineDash([]);
  }
}

/** Numbers of the droppers that are seen, and whether they are far enough from one another. */
export function droppersSeen({ line, camera }: Pick<Pencil, "line" | "camera">): Uint32Array {
  const first = below(line.dropperX, camera.x0);
  const last = below(line.dropperX, camera.x1);
  const room = ((camera.x1 - camera.x0) * camera.scale) / Math.max(1, last - first);
  return room < DROPPER_APART ? new Uint32Array() : line.dropperOrder.subarray(first, last);
}

/** Ends of a dropper in px: x and y of the top, then of the bottom. */
export function dropperEnds(
  dropper: Dropper,
  camera: Camera,
  view: View,
  now: Moved | null,
): [number, number, number, number] {
  const axis = view === "side" ? 2 : 1;
  const top = dropper.top[axis] + shift(now?.wires[dropper.top_wire], dropper.top_node, view);
  const bottom = dropper.bottom[axis] + shift(now?.wires[dropper.wire], dropper.node, view);
  return [camera.x(dropper.top[0]), camera.y(top), camera.x(dropper.bottom[0]), camera.y(bottom)];
}

/** Force of a dropper in N now; null where it is not known. */
export function forceOf(dropper: Dropper, number: number, now: Moved | null): number | null {
  const force = now ? now.dropper_N?.[number] : dropper.force_N;
  return force === undefined || Number.isNaN(force) ? null : force;
}

function droppers(pencil: Pencil, view: View, now: Moved | null, marked: ReadonlySet<number>): void {
  const { context, camera, geometry } = pencil;
  const slack: number[] = [];
  context.lineWidth = 1;
  context.strokeStyle = pencil.colour("dropper");
  context.beginPath();
  for (const number of droppersSeen(pencil)) {
    const dropper = geometry.droppers[number]!;
    const [x0, y0, x1, y1] = dropperEnds(dropper, camera, view, now);
    if (marked.has(number)) bold(pencil, x0, y0, x1, y1);
    if (forceOf(dropper, number, now) === 0) {
      slack.push(number);
      continue;
    }
    context.moveTo(x0, y0);
    context.lineTo(x1, y1);
  }
  context.stroke();
  // Slack ones are told by dashes and a ring too, not by the colour alone.
  context.strokeStyle = pencil.colour("slack");
  for (const number of slack) {
    const [x0, y0, x1, y1] = dropperEnds(geometry.droppers[number]!, camera, view, now);
    context.setLineDash([3, 3]);
    context.beginPath();
    context.moveTo(x0, y0);
    context.lineTo(x1, y1);
    context.stroke();
    context.setLineDash([]);
    context.beginPath();
    context.arc((x0 + x1) / 2, (y0 + y1) / 2, 3, 0, 2 * Math.PI);
    context.stroke();
  }
}

/** A mark of what is selected, drawn at once; the path that is being made goes on. */
function bold({ context, colour }: Pencil, x0: number, y0: number, x1: number, y1: number): void {
  context.save();
  context.strokeStyle = context.fillStyle = colour("accent");
  context.fillRect(Math.min(x0, x1) - 1.5, Math.min(y0, y1), Math.abs(x1 - x0) + 3, Math.abs(y1 - y0));
  context.restore();
}

function arms(pencil: Pencil, view: View, now: Moved | null): void {
  const { context, camera, geometry } = pencil;
  const axis = view === "side" ? 2 : 1;
  context.strokeStyle = context.fillStyle = pencil.colour("arm");
  context.lineWidth = 2;
  const all = seen(geometry.supports, camera);
  if (all.length * DROPPER_APART > camera.width) return;
  for (const support of all) {
    for (const { from, to } of support.arms) {
      const moved = shift(now?.wires[support.wire], support.node, view);
      context.beginPath();
      context.moveTo(camera.x(from[0]), camera.y(from[axis] + moved));
      context.lineTo(camera.x(to[0]), camera.y(to[axis]));
      context.stroke();
      context.beginPath();
      context.arc(camera.x(to[0]), camera.y(to[axis]), 2.5, 0, 2 * Math.PI);
      context.fill();
    }
  }
}

const seen = (supports: Support[], { x0, x1 }: Camera) =>
  supports.filter(({ x_m }) => x_m >= x0 && x_m <= x1);

/** Supports as marks, span numbers, ruler of positions, and of heights or lateral positions. */
function rulers(pencil: Pencil, view: View, selected: Selected | null): void {
  const { context, camera, geometry } = pencil;
  const { width, height } = camera;
  context.font = `12px ${pencil.colour("font-text")}`;
  context.fillStyle = pencil.colour("soft");
  const spans = geometry.spans.filter((span) => span.end_m >= camera.x0 && span.start_m <= camera.x1);
  const room = ((camera.x1 - camera.x0) * camera.scale) / Math.max(1, spans.length);
  const every = Math.max(1, Math.ceil(NUMBER_APART / room));
  context.textAlign = "center";
  context.textBaseline = "top";
  for (const { number, start_m, end_m } of spans) {
    if (selected?.kind === "span" && selected.number === number) {
      context.save();
      context.globalAlpha = 0.12;
      context.fillStyle = pencil.colour("accent");
      context.fillRect(camera.x(start_m), 0, (end_m - start_m) * camera.scale, height);
      context.restore();
    }
    if ((number - 1) % every === 0) context.fillText(String(number), camera.x((start_m + end_m) / 2), 4);
  }
  context.strokeStyle = pencil.colour("support");
  context.lineWidth = 1;
  context.setLineDash([2, 3]);
  context.beginPath();
  for (const { x_m } of seen(geometry.supports, camera)) {
    context.moveTo(camera.x(x_m), 20);
    context.lineTo(camera.x(x_m), height - 18);
  }
  if (room >= DROPPER_APART) context.stroke();
  context.setLineDash([]);
  context.textBaseline = "bottom";
  for (const x of ticks(Math.max(camera.x0, 0), camera.x1, TICK_APART / camera.scale)) {
    context.fillText(`${x} m`, camera.x(x), height - 2);
  }
  context.textAlign = "left";
  context.textBaseline = "middle";
  const up = camera.scale * camera.exaggeration;
  context.strokeStyle = pencil.colour("grid");
  for (const value of ticks(camera.up(height - 24), camera.up(22), HEIGHT_APART / up)) {
    const y = camera.y(value);
    context.beginPath();
    context.moveTo(50, y);
    context.lineTo(width, y);
    context.stroke();
    context.fillText(String(value), 4, y);
  }
  context.textBaseline = "top";
  context.fillText(view === "side" ? "m up" : "m left", 4, 4);
}

export interface Shown {
  now: Moved | null;
  /** Whether the line at rest is drawn below the moved one. */
  ghost: boolean;
  selected: Selected | null;
  /** Droppers by number. */
  marked: ReadonlySet<number>;
}

/** Draw a line: what it stands before, the ghost of it at rest, then itself. */
export function paintLine(
  pencil: Pencil,
  view: View,
  { now, ghost, selected, marked }: Shown,
): void {
  rulers(pencil, view, selected);
  const { context, camera } = pencil;
  context.save();
  context.beginPath();
  context.rect(50, 0, camera.width - 50, camera.height);
  context.clip();
  if (now && ghost) wires(pencil, view, null, "rest");
  droppers(pencil, view, now, marked);
  arms(pencil, view, now);
  wires(pencil, view, now);
  context.restore();
}
