/**
 * Parallel coordinates of the open study. A click picks the nearest line or point. Drag along an axis: only
 * rows in that range stay; click on that axis: all again. The fields above do the same from the keyboard.
 */
import { useRef } from "preact/hooks";
import { useCanvas } from "../drawing/canvas.ts";
import { shown, type Column } from "./columns.ts";
import { count, picked, rows } from "./open.ts";
import { axisAt, layout, lineAt, paint, pointAt, type Picture } from "./parallel.ts";
import { axes, brush, brushes, colouredBy, columns, criteria, isJudged, limits, places } from "./selection.ts";
import { SHAPES, wordsOf } from "./verdicts.ts";

/** An axis has so much room in px at least: the words of its head, and two fields. */
const NARROWEST = 92;
/** A pointer that moved less than this, in px, clicked. */
const CLICK = 4;

function picture(): Picture {
  void count.value;
  return {
    columns: axes.value, rows, places: places.value, brushes: brushes.value, picked: picked.value,
    coloured: columns.value.find(({ name }) => name === colouredBy.value) ?? null,
    criteria: criteria.value, limits: limits.value,
  };
}

export function Parallel() {
  const canvas = useRef<HTMLCanvasElement>(null);
  const drag = useRef<{ axis: number; from: number } | null>(null);
  useCanvas(canvas, (sheet) => paint(sheet, picture()));
  const place = (event: PointerEvent) => {
    const box = canvas.current!.getBoundingClientRect();
    return { x: event.clientX - box.left, y: event.clientY - box.top, width: box.width, height: box.height };
  };
  const down = (event: PointerEvent) => {
    const { x, y, width, height } = place(event);
    const axis = axisAt(picture(), width, height, x);
    if (axis === null) {
      picked.value = lineAt(picture(), width, height, x, y);
      return;
    }
    canvas.current!.setPointerCapture(event.pointerId);
    drag.current = { axis, from: y };
  };
  const move = (event: PointerEvent) => {
    const began = drag.current;
    if (!began) return;
    const { y, width, height } = place(event);
    const column = axes.peek()[began.axis];
    const on = layout(picture(), width, height);
    if (!column || Math.abs(y - began.from) < CLICK) return;
    const ends = [on.value(began.axis, began.from), on.value(began.axis, y)].sort((a, b) => a - b) as [number, number];
    brush(column.name, ends);
  };
  const up = (event: PointerEvent) => {
    const began = drag.current;
    drag.current = null;
    if (!began || Math.abs(place(event).y - began.from) >= CLICK) return;
    const column = axes.peek()[began.axis];
    if (!column) return;
    const { y, width, height } = place(event);
    if (brushes.peek()[column.name]) brush(column.name, null);
    else picked.value = pointAt(picture(), width, height, began.axis, y);
  };
  return (
    <section class="parallel" aria-label="Parallel coordinates">
      <div class="wide" style={{ minWidth: `${axes.value.length * NARROWEST}px` }}>
        <div class="heads">
          {axes.value.map((column) => (
            <Head key={column.name} column={column} />
          ))}
        </div>
        <canvas ref={canvas} role="img" onPointerDown={down} onPointerMove={move} onPointerUp={up}
          aria-label={`Parallel coordinates: ${axes.value.length} axes, ${places.value.length} of ${count.value} rows`} />
      </div>
      {isJudged.value && <Key />}
    </section>
  );
}

/** What bars and shapes on the axes mean. */
function Key() {
  return (
    <p class="soft key">
      <span class="bar-of-limit" aria-hidden="true" /> limit
      {Object.entries(SHAPES).map(([word, { drawn, state }]) => (
        <span key={word}><span class={state} aria-hidden="true">{DRAWN[drawn]}</span> {word}</span>
      ))}
    </p>
  );
}

const DRAWN = { circle: "●", up: "▲", down: "▼", diamond: "◆" };

function Head({ column }: { column: Column }) {
  const range = brushes.value[column.name];
  const end = (at: 0 | 1, text: string) => {
    const value = Number(text);
    const old = range ?? [-Infinity, Infinity];
    const next: [number, number] = [old[0], old[1]];
    next[at] = text.trim() === "" || Number.isNaN(value) ? (at ? Infinity : -Infinity) : value;
    brush(column.name, Number.isFinite(next[0]) || Number.isFinite(next[1]) ? next : null);
  };
  const typed = (value: number | undefined) => (value !== undefined && Number.isFinite(value) ? shown(value) : "");
  return (
    <div class="head">
      <strong title={column.description}>{column.label}</strong>
      <span class="unit">{column.unit}</span>
      {limits.value[column.name]?.map((limit) => (
        <span class="limit" key={limit.source} title={`${limit.sign} ${limit.source}`}>{wordsOf(limit)}</span>
      ))}
      <span class="ends">
        <input aria-label={`Lowest ${column.label}`} inputMode="decimal" placeholder="from" value={typed(range?.[0])}
          onChange={(event) => end(0, event.currentTarget.value)} />
        <input aria-label={`Highest ${column.label}`} inputMode="decimal" placeholder="to" value={typed(range?.[1])}
          onChange={(event) => end(1, event.currentTarget.value)} />
      </span>
    </div>
  );
}
