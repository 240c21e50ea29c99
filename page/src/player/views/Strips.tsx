/**
 * Strips below the drawing, on its ruler: contact force of each pantograph, uplift at supports.
 * Lowest and highest value of each column of pixels; forces in N, uplifts in mm.
 */
import { useRef } from "preact/hooks";
import { LEFT, RIGHT, ticks, zoomed } from "../../drawing/camera.ts";
import { useCanvas, type Sheet } from "../../drawing/canvas.ts";
import { isPlayed, shown, sight, whole } from "../../drawing/scene.ts";
import { leave, point, pointed } from "../../state/pointing.ts";
import { range } from "../../state/selection.ts";
import { wentTo } from "../../state/worst.ts";
import { standAt } from "../places.ts";
import { history, scene, state } from "../player.ts";
import { colourOf } from "./pantographs.ts";
import { printing } from "./repaint.ts";
import { columnEnds, stored, type Ends } from "./columns.ts";

/** Room of the title above the scale and the lines, px. */
const TOP = 19;
/** Below the scale half a number has room, px. */
const BOTTOM = 8;
const HEIGHT_APART = 26; // px
const ZOOM = 1.2;
/** The scale of a strip ends at a multiple of this, so that it does not jump with each value. */
const FORCE_STEP = 100; // N
const UPLIFT_STEP = 0.02; // m
/** Droppers and supports nearer than so many px are one mark. */
const MARK_APART = 3;

interface Axis extends Sheet {
  x0: number;
  x1: number;
  x: (metres: number) => number;
  y: (value: number) => number;
}

function axis(sheet: Sheet, high: number): Axis {
  const [x0, x1] = sight.value;
  const scale = Math.max(1, sheet.width - LEFT - RIGHT) / (x1 - x0);
  const room = sheet.height - TOP - BOTTOM;
  return { ...sheet, x0, x1, x: (metres) => LEFT + (metres - x0) * scale, y: (value) => TOP + room * (1 - value / high) };
}

function frame(on: Axis, high: number, unit: string, title: string, factor: number): void {
  const { context, colour, width } = on;
  context.font = `12px ${colour("font-text")}`;
  context.fillStyle = colour("soft");
  context.strokeStyle = colour("grid");
  context.lineWidth = 1;
  context.textBaseline = "middle";
  context.textAlign = "left";
  const step = (HEIGHT_APART / (on.y(0) - on.y(high))) * high * factor;
  context.beginPath();
  for (const value of ticks(0, high * factor, step)) {
    const y = on.y(value / factor);
    context.moveTo(LEFT, y);
    context.lineTo(width - RIGHT, y);
    context.fillText(String(value), 4, y);
  }
  context.stroke();
  context.textAlign = "right";
  context.textBaseline = "top";
  context.fillText(`${title}, ${unit}`, width - RIGHT, 2);
}

function cursors(on: Axis): void {
  const { context, colour, height } = on;
  const line = (x: number, name: string, width: number) => {
    if (!(x >= on.x0 && x <= on.x1)) return;
    context.strokeStyle = colour(name);
    context.lineWidth = width;
    context.beginPath();
    context.moveTo(on.x(x), TOP);
    context.lineTo(on.x(x), height);
    context.stroke();
  };
  state.current.pantographs.forEach((one, number) => line(one.position, colourOf(number), 1.5));
  if (wentTo.value) line(wentTo.value.position_m, "not_met", 1);
  if (pointed.value !== null) line(pointed.value, "accent", 1);
}

function curve(on: Axis, ends: Ends, name: string, width: number): void {
  const { context } = on;
  context.strokeStyle = on.colour(name);
  context.lineWidth = width;
  context.beginPath();
  const metres = (on.x1 - on.x0) / Math.max(1, on.width - LEFT - RIGHT);
  let before: [number, number] | null = null;
  for (let x = on.x0; x < on.x1; x += metres) {
    const here = ends(x, x + metres);
    if (here) {
      // Joined with the column before, also where its values lie wholly above or below.
      if (before) context.lineTo(on.x(x), on.y(here[0]));
      else context.moveTo(on.x(x), on.y(here[0]));
      context.lineTo(on.x(x), on.y(here[1]));
    }
    // Buckets may be wider apart than pixels: a gap shorter than some of them is joined.
    before = here ?? before;
  }
  context.stroke();
}

function paintForce(sheet: Sheet): void {
  const columns = stored.value;
  let largest = Math.max(FORCE_STEP, columns.top);
  const raw = state.current.pantographs.map((_, number) => columns.raw[number] ?? null);
  raw.forEach((column, number) => {
    const top = column ? 0 : (history.force[number]?.ends(...sight.value)?.[1] ?? 0);
    if (top > largest) largest = top;
  });
  const high = Math.ceil(largest / FORCE_STEP) * FORCE_STEP;
  const on = axis(sheet, high);
  const filtered = columns.filtered.some((column) => column);
  frame(on, high, "N", filtered ? "Contact force, filtered; unfiltered pale" : "Contact force, unfiltered", 1);
  state.current.pantographs.forEach((_, number) => {
    const column = raw[number];
    const live = history.force[number];
    const fine = columns.filtered[number];
    const ends = column ? columnEnds(column) : live ? (from: number, to: number) => live.ends(from, to) : null;
    if (ends) curve(on, ends, fine ? "raw" : colourOf(number), 1);
    if (fine) curve(on, columnEnds(fine), colourOf(number), 1.6);
  });
  cursors(on);
}

function paintUplift(sheet: Sheet): void {
  const supports = scene.peek()?.geometry.supports ?? [];
  const now = state.current.supports;
  let largest = 0;
  for (const values of [history.uplift, now]) for (const value of values) if (value > largest) largest = value;
  const high = Math.max(1, Math.ceil(largest / UPLIFT_STEP)) * UPLIFT_STEP;
  const on = axis(sheet, high);
  frame(on, high, "mm", "Uplift at supports, now and largest seen", 1000);
  const { context, colour } = on;
  const seen = supports.filter((one) => one.x_m >= on.x0 && one.x_m <= on.x1);
  if ((on.x(on.x1) - on.x(on.x0)) / Math.max(1, seen.length) < MARK_APART) return cursors(on);
  context.fillStyle = colour("contact_wire");
  context.strokeStyle = colour("soft");
  context.lineWidth = 1.5;
  context.beginPath();
  supports.forEach(({ x_m }, number) => {
    if (x_m < on.x0 || x_m > on.x1) return;
    const value = now[number]!;
    if (value > 0) context.fillRect(on.x(x_m) - 4, on.y(value), 8, on.y(0) - on.y(value));
    const most = history.uplift[number] ?? NaN;
    if (most > 0) {
      context.moveTo(on.x(x_m) - 8, on.y(most));
      context.lineTo(on.x(x_m) + 8, on.y(most));
    }
  });
  context.stroke();
  cursors(on);
}

interface Given {
  paint: (sheet: Sheet) => void;
  label: string;
  wheel: boolean;
}

function Strip({ paint, label, wheel }: Given) {
  const canvas = useRef<HTMLCanvasElement>(null);
  useCanvas(canvas, (sheet) => {
    void printing.value;
    paint(sheet);
  });
  const metres = (event: MouseEvent) => {
    const [x0, x1] = sight.peek();
    const width = (event.currentTarget as HTMLElement).clientWidth - LEFT - RIGHT;
    return x0 + ((event.offsetX - LEFT) / width) * (x1 - x0);
  };
  return (
    <canvas
      ref={canvas}
      class="strip"
      role="img"
      aria-label={label}
      onPointerMove={(event) => point(metres(event))}
      onPointerLeave={leave}
      onClick={(event) => standAt(metres(event))}
      onWheel={(event) => {
        const line = shown.peek();
        if (!wheel || !line || !event.deltaY) return;
        event.preventDefault();
        range.value = zoomed(sight.peek(), event.deltaY > 0 ? ZOOM : 1 / ZOOM, metres(event), whole(line));
      }}
    />
  );
}

/** `wheel`: whether it zooms; in a page that is scrolled it must not. */
function Both({ wheel }: { wheel: boolean }) {
  if (!scene.value || !isPlayed.value) return null;
  return (
    <div class="strips">
      <Strip wheel={wheel} paint={paintForce} label="Contact force along the track; a click places the pantograph" />
      <Strip wheel={wheel} paint={paintUplift} label="Uplift at supports along the track" />
    </div>
  );
}

export const Strips = () => <Both wheel />;
export const StripsOfReport = () => <Both wheel={false} />;
