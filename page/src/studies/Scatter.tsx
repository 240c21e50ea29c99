/** Two columns of the open study against each other. Click: the nearest point is picked. */
import { useSignal } from "@preact/signals";
import { useRef } from "preact/hooks";
import { ticks } from "../drawing/camera.ts";
import { useCanvas, type Sheet } from "../drawing/canvas.ts";
import { bucketOf, colourOfBucket } from "./colours.ts";
import { extent, shown, variantOf, type Column } from "./columns.ts";
import { count, picked, rows } from "./open.ts";
import { axes, colouredBy, columns, places } from "./selection.ts";

const [LEFT, RIGHT, TOP, BOTTOM] = [60, 12, 10, 34]; // px
const APART = 60; // px, between numbers of a scale

interface Plane {
  x(value: number): number;
  y(value: number): number;
}

function plane(one: Column, other: Column, width: number, height: number): (Plane & { ends: [[number, number], [number, number]] }) | null {
  const [across, up] = [extent(one, rows), extent(other, rows)];
  if (!across || !up) return null;
  return {
    ends: [across, up],
    x: (value) => LEFT + ((value - across[0]) / (across[1] - across[0])) * (width - LEFT - RIGHT),
    y: (value) => TOP + (1 - (value - up[0]) / (up[1] - up[0])) * (height - TOP - BOTTOM),
  };
}

function scales({ context, colour, width, height }: Sheet, on: NonNullable<ReturnType<typeof plane>>, one: Column, other: Column): void {
  context.font = `12px ${colour("font-text")}`;
  context.fillStyle = colour("soft");
  context.strokeStyle = colour("grid");
  const [across, up] = on.ends;
  context.beginPath();
  context.textAlign = "center";
  context.textBaseline = "top";
  for (const value of ticks(across[0], across[1], ((across[1] - across[0]) * APART) / (width - LEFT - RIGHT))) {
    context.moveTo(on.x(value), TOP);
    context.lineTo(on.x(value), height - BOTTOM);
    context.fillText(shown(value), on.x(value), height - BOTTOM + 3);
  }
  context.textAlign = "right";
  context.textBaseline = "middle";
  for (const value of ticks(up[0], up[1], ((up[1] - up[0]) * APART) / 2 / (height - TOP - BOTTOM))) {
    context.moveTo(LEFT, on.y(value));
    context.lineTo(width - RIGHT, on.y(value));
    context.fillText(shown(value), LEFT - 5, on.y(value));
  }
  context.stroke();
  context.textBaseline = "bottom";
  context.fillText(`${one.label}${one.unit ? `, ${one.unit}` : ""}`, width - RIGHT, height);
  context.textAlign = "left";
  context.textBaseline = "top";
  context.fillText(`${other.label}${other.unit ? `, ${other.unit}` : ""}`, LEFT + 4, 0);
}

function paint(sheet: Sheet, one: Column, other: Column): void {
  const on = plane(one, other, sheet.width, sheet.height);
  if (!on) return;
  scales(sheet, on, one, other);
  const { context, colour } = sheet;
  const inside = new Set(places.value);
  const coloured = columns.value.find(({ name }) => name === colouredBy.value) ?? null;
  const range = coloured && extent(coloured, rows);
  rows.forEach((row, at) => {
    const [x, y] = [one.number(row), other.number(row)];
    if (x === null || y === null) return;
    const bucket = coloured && range ? bucketOf(coloured.number(row), range) : -1;
    context.fillStyle = !inside.has(at) ? colour("grid") : bucket < 0 ? colour("accent") : colourOfBucket(bucket);
    context.fillRect(on.x(x) - 2.5, on.y(y) - 2.5, 5, 5);
  });
  const variant = picked.value;
  const own = rows.find((row) => variantOf(row) === variant);
  const [x, y] = own ? [one.number(own), other.number(own)] : [null, null];
  if (x === null || y === null) return;
  context.strokeStyle = colour("highlight");
  context.lineWidth = 3;
  context.strokeRect(on.x(x) - 6, on.y(y) - 6, 12, 12);
}

export function Scatter() {
  const canvas = useRef<HTMLCanvasElement>(null);
  const names = useSignal<[string | null, string | null]>([null, null]);
  const chosen = (at: 0 | 1): Column | undefined => {
    const all = axes.value;
    const outputs = all.filter(({ kind }) => kind === "output");
    return all.find(({ name }) => name === names.value[at]) ?? (at ? outputs[0] : all[0]);
  };
  useCanvas(canvas, (sheet) => {
    void count.value;
    const [one, other] = [chosen(0), chosen(1)];
    if (one && other) paint(sheet, one, other);
  });
  const pick = (event: PointerEvent) => {
    const box = canvas.current!.getBoundingClientRect();
    const [one, other] = [chosen(0), chosen(1)];
    const on = one && other && plane(one, other, box.width, box.height);
    if (!on) return;
    let [best, least] = [null as number | null, Infinity];
    for (const at of places.peek()) {
      const [x, y] = [one.number(rows[at]!), other.number(rows[at]!)];
      if (x === null || y === null) continue;
      const distance = Math.hypot(on.x(x) - event.clientX + box.left, on.y(y) - event.clientY + box.top);
      if (distance < least) [best, least] = [variantOf(rows[at]!), distance];
    }
    picked.value = best;
  };
  const select = (at: 0 | 1, label: string) => (
    <label>
      {label}{" "}
      <select value={chosen(at)?.name ?? ""} onChange={(event) => {
        const next: [string | null, string | null] = [...names.value];
        next[at] = event.currentTarget.value;
        names.value = next;
      }}>
        {axes.value.map(({ name, label }) => <option key={name} value={name}>{label}</option>)}
      </select>
    </label>
  );
  return (
    <section class="scatter" aria-label="Two columns">
      <div class="bar">{select(0, "Across")}{select(1, "Up")}</div>
      <canvas ref={canvas} role="img" onPointerDown={pick}
        aria-label={`${chosen(1)?.label ?? ""} against ${chosen(0)?.label ?? ""}, ${places.value.length} of ${count.value} rows`} />
    </section>
  );
}
