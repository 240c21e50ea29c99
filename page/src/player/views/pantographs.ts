/**
 * Pantographs over the drawing of the line: masses and springs below the contact point, the contact
 * force as an arrow with its number. Heights and displacements at the scale of the drawing; the
 * distances of masses from one another are a scheme and not to scale.
 */
import type { Geometry } from "../../drawing/geometry.ts";
import { valueAt, type LineIndex } from "../../drawing/lineIndex.ts";
import type { Pencil } from "../../drawing/scene.ts";
import type { PantographState } from "../motion/state.ts";
import { state } from "../player.ts";

/** Length of the arrow in px of a newton, so that 300 N stay in the picture. */
const ARROW = 0.22;
/** Distance between masses in px, and the half width of a mass and of the head. */
const APART = 30;
const HALF_MASS = 9;
const HALF_HEAD = 15;
const COLOURS = 4;

export const colourOf = (number: number): string => `pantograph_${(number % COLOURS) + 1}`;

/** Pixels of the masses of a pantograph, from the head down: head at the wire, or below it where it has left it. */
export function places(one: PantographState, wire: number, anchor: number, scale: number): number[] {
  // Displacements come from the base up to the strips.
  const up = one.masses.toReversed();
  return up.map((mass, at) => {
    const moved = anchor + at * APART - mass * scale;
    return at === 0 && one.force > 0 ? wire : Math.max(moved, wire + at * 4);
  });
}

function spring(context: CanvasRenderingContext2D, x: number, top: number, bottom: number): void {
  const turns = 6;
  context.moveTo(x, top);
  for (let turn = 0; turn <= turns; turn++) {
    const side = turn === 0 || turn === turns ? 0 : turn % 2 ? 4 : -4;
    context.lineTo(x + side, top + ((bottom - top) * (turn + 0.5)) / (turns + 1));
  }
  context.lineTo(x, bottom);
}

function halo(pencil: Pencil, text: string, x: number, y: number): void {
  const { context, colour } = pencil;
  context.strokeStyle = colour("paper");
  context.lineWidth = 4;
  context.lineJoin = "round";
  context.strokeText(text, x, y);
  context.fillText(text, x, y);
}

/** Height in m of the lowest contact wire at rest at a position. */
function restAt(line: LineIndex, x: number): number | null {
  let least: number | null = null;
  for (const wire of line.wires) {
    const z = wire.kind === "contact" ? valueAt(wire, "z", x) : null;
    if (z !== null && (least === null || z < least)) least = z;
  }
  return least;
}

/** Height in m at which the head stands where no mass is displaced, by pantograph; see `anchorOf`. */
const anchors = new WeakMap<Geometry, Map<number, number>>();

/**
 * The contact height less the displacement of the head, which counts from the start of the run; it
 * changes with the compression of the strip alone, so that it is kept from a moment in contact.
 */
function anchorOf(geometry: Geometry, number: number, one: PantographState, otherwise: number): number {
  const head = one.masses.at(-1);
  const own = anchors.get(geometry) ?? new Map<number, number>();
  anchors.set(geometry, own);
  if (!own.has(number) && one.force > 0 && head !== undefined && Number.isFinite(one.height - head)) {
    own.set(number, one.height - head);
  }
  return own.get(number) ?? otherwise;
}

function drawOne(pencil: Pencil, number: number, one: PantographState): void {
  const { context, camera, line, geometry, colour } = pencil;
  const height = Number.isFinite(one.height) ? one.height : restAt(line, one.position);
  if (height === null) return;
  const x = camera.x(one.position);
  const wire = camera.y(height);
  const scale = camera.scale * camera.exaggeration;
  const own = colour(colourOf(number));
  const all = places(one, wire, camera.y(anchorOf(geometry, number, one, height)), scale);
  const head = all[0] ?? wire;
  const floor = Math.max((all.at(-1) ?? wire) + APART, wire + APART);
  context.strokeStyle = context.fillStyle = own;
  context.lineWidth = 1.5;
  context.beginPath();
  [...all, floor].forEach((y, at) => at > 0 && spring(context, x, (all[at - 1] ?? wire) + 4, y - 4));
  context.moveTo(x - HALF_HEAD, floor);
  context.lineTo(x + HALF_HEAD, floor);
  context.stroke();
  context.lineWidth = 4;
  context.lineCap = "round";
  context.beginPath();
  context.moveTo(x - HALF_HEAD, head + 3);
  context.lineTo(x + HALF_HEAD, head + 3);
  context.stroke();
  context.lineCap = "butt";
  for (const y of all.slice(1)) context.fillRect(x - HALF_MASS, y - 4, 2 * HALF_MASS, 8);
  if (all.length > 1) context.fillRect(x - 4, head + 3, 8, 5);
  force(pencil, number, one, x, wire);
}

function force(pencil: Pencil, number: number, one: PantographState, x: number, wire: number): void {
  const { context, colour } = pencil;
  if (!Number.isFinite(one.force)) return;
  const lost = one.force <= 0;
  const tip = Math.max(wire - one.force * ARROW, 30);
  context.strokeStyle = context.fillStyle = colour(lost ? "limit" : colourOf(number));
  context.lineWidth = 2.5;
  context.beginPath();
  if (!lost) {
    context.moveTo(x, wire);
    context.lineTo(x, tip);
    context.stroke();
    context.beginPath();
    context.moveTo(x, tip - 6);
    context.lineTo(x - 4.5, tip + 3);
    context.lineTo(x + 4.5, tip + 3);
    context.fill();
  }
  context.font = `600 13px ${colour("font-text")}`;
  context.textAlign = "left";
  context.textBaseline = "middle";
  const text = lost ? "no contact" : `${Math.round(one.force)} N`;
  halo(pencil, text, x + 8, tip);
}

/** Layer of the side view. */
export function drawSide(pencil: Pencil): void {
  const { x0, x1 } = pencil.camera;
  const all = state.current.pantographs;
  // The leading one last, so that nothing covers it.
  for (let number = all.length - 1; number >= 0; number--) {
    const one = all[number]!;
    if (one.position >= x0 && one.position <= x1) drawOne(pencil, number, one);
  }
}

/** Layer of the plan: where each pantograph is, and where contact wires cross it. */
export function drawPlan(pencil: Pencil): void {
  const { context, camera, line, colour } = pencil;
  state.current.pantographs.forEach((one, number) => {
    if (!(one.position >= camera.x0 && one.position <= camera.x1)) return;
    const x = camera.x(one.position);
    context.strokeStyle = context.fillStyle = colour(colourOf(number));
    context.lineWidth = 2;
    context.beginPath();
    context.moveTo(x, 20);
    context.lineTo(x, camera.height - 20);
    context.stroke();
    for (const wire of line.wires) {
      const y = wire.kind === "contact" ? valueAt(wire, "y", one.position) : null;
      if (y === null) continue;
      context.beginPath();
      context.arc(x, camera.y(y), 4, 0, 2 * Math.PI);
      context.fill();
    }
  });
}
