/** A small chart of one quantity along the line: of the file thin, with what is tried heavy. */
import { useEffect, useRef } from "preact/hooks";
import { LEFT, RIGHT, ticks } from "../drawing/camera.ts";
import { useCanvas } from "../drawing/canvas.ts";
import { cursor } from "../state/selection.ts";
import { scaleOf } from "./scale.ts";

export interface Series {
  x: readonly number[];
  y: readonly number[];
}

interface ChartProps {
  title: string;
  unit: string;
  now: Series;
  /** Without what is tried; null where nothing is. */
  before: Series | null;
  /** Values that stand alone are marks; others are joined. */
  marks?: boolean;
}

const TOP = 8;
const BOTTOM = 20;
/** Between two ticks in px, at least. */
const APART = 26;

export function Chart({ title, unit, now, before, marks = false }: ChartProps) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const data = useRef({ now, before });
  data.current = { now, before };
  const paint = useRef<() => void>(() => undefined);
  useCanvas(canvas, ({ context, width, height, colour }) => {
    const { now, before } = data.current;
    if (now.x.length < 2) return;
    const values = [...now.y, ...(before?.y ?? [])];
    const scale = scaleOf(values, Math.floor((height - TOP - BOTTOM) / APART));
    const [base, room] = [scale.low, scale.high - scale.low];
    const [x0, x1] = [now.x[0]!, now.x.at(-1)!];
    const px = (x: number) => LEFT + ((x - x0) / (x1 - x0 || 1)) * (width - LEFT - RIGHT);
    const py = (y: number) => TOP + (1 - (y - base) / room) * (height - TOP - BOTTOM);
    context.font = `12px ${colour("font-text")}`;
    context.fillStyle = colour("soft");
    context.strokeStyle = colour("grid");
    context.textBaseline = "middle";
    context.textAlign = "left";
    for (const y of scale.ticks) {
      context.beginPath();
      context.moveTo(LEFT - 4, py(y));
      context.lineTo(width - RIGHT, py(y));
      context.stroke();
      context.fillText(String(y), 4, py(y));
    }
    context.textAlign = "center";
    context.textBaseline = "bottom";
    for (const x of ticks(x0, x1, ((x1 - x0) * 80) / Math.max(width - LEFT - RIGHT, 1))) {
      context.fillText(`${x} m`, Math.min(px(x), width - 20), height - 2);
    }
    const draw = ({ x, y }: Series, name: string, thick: number) => {
      context.strokeStyle = context.fillStyle = colour(name);
      context.lineWidth = thick;
      context.beginPath();
      x.forEach((at, number) => {
        if (!marks) context.lineTo(px(at), py(y[number]!));
        else context.rect(px(at) - thick, py(y[number]!) - thick, 2 * thick, 2 * thick);
      });
      if (marks) context.fill();
      else context.stroke();
    };
    if (before) draw(before, "rest", marks ? 2 : 1);
    draw(now, "accent", marks ? 2.5 : 2);
    const at = cursor.value;
    if (at === null || at < x0 || at > x1) return;
    context.strokeStyle = colour("accent");
    context.lineWidth = 1;
    context.beginPath();
    context.moveTo(px(at), TOP);
    context.lineTo(px(at), height - BOTTOM);
    context.stroke();
  }, paint);
  useEffect(() => paint.current());
  const point = (event: PointerEvent) => {
    const { x } = data.current.now;
    const width = (event.currentTarget as HTMLElement).clientWidth - LEFT - RIGHT;
    const share = (event.offsetX - LEFT) / Math.max(width, 1);
    if (x.length > 1 && share >= 0 && share <= 1) cursor.value = x[0]! + share * (x.at(-1)! - x[0]!);
  };
  const range = now.y.length ? `${Math.min(...now.y).toPrecision(4)} to ${Math.max(...now.y).toPrecision(4)} ${unit}` : "";
  return (
    <figure class="chart">
      <figcaption>
        {title} ({unit})
      </figcaption>
      <canvas ref={canvas} role="img" aria-label={`${title}: ${range}`} onPointerMove={point} />
    </figure>
  );
}
