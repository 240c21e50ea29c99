/** Contact forces of a session: the number, a bar with the limit, and a strip of the last seconds. N, s. */
import { useRef } from "preact/hooks";
import { ticks } from "../drawing/camera.ts";
import { useCanvas, type Sheet } from "../drawing/canvas.ts";
import { colourOf } from "../player/views/pantographs.ts";
import { begun, moment, trace } from "./session.ts";
import { SHOWN } from "./trace.ts";

/** The scale ends at a multiple of this in N, so that it does not jump with each value; and at least at `LEAST`. */
const STEP = 100;
const LEAST = 400;
const LEFT = 44; // px, for numbers of the scale
const APART = 28; // px, between lines of the scale

const top = () => Math.max(LEAST, Math.ceil(trace.highest() / STEP) * STEP);

/** Numbers change so often that only a few of them can be read; a reader hears none of them unasked. */
export function ForceNumber({ number }: { number: number }) {
  const now = moment.value?.pantographs[number]?.force ?? NaN;
  const told = begun.value!;
  const limit = told.highest;
  const most = top();
  const words = now <= 0 ? "no contact" : Number.isNaN(now) ? "–" : `${Math.round(now)} N`;
  return (
    <div class="force">
      <span class="name">{told.pantographs[number]?.name}</span>
      <output class={now <= 0 ? "number lost" : "number"}>{words}</output>
      <meter
        aria-label={`Contact force of ${told.pantographs[number]?.name}`}
        min={0} max={most} value={Math.max(0, now || 0)}
        {...(limit ? { high: limit.force_N } : {})}
      />
      <small>0 to {most} N</small>
    </div>
  );
}

function scale({ context, width, height, colour }: Sheet, most: number): void {
  context.font = `12px ${colour("font-text")}`;
  context.fillStyle = colour("soft");
  context.strokeStyle = colour("grid");
  context.textBaseline = "middle";
  context.beginPath();
  for (const value of ticks(0, most, (APART / height) * most)) {
    const y = height * (1 - value / most);
    context.moveTo(LEFT, y);
    context.lineTo(width, y);
    context.fillText(String(value), 4, Math.min(Math.max(y, 7), height - 7));
  }
  context.stroke();
}

function paint(sheet: Sheet): void {
  const { context, width, height, colour } = sheet;
  const most = top();
  scale(sheet, most);
  const end = trace.times.at(-1) ?? 0;
  const x = (time: number) => LEFT + ((time - end + SHOWN) / SHOWN) * (width - LEFT);
  const y = (force: number) => height * (1 - force / most);
  const limit = begun.value?.highest?.force_N;
  if (limit !== undefined) {
    context.strokeStyle = colour("limit");
    context.setLineDash([6, 4]);
    context.beginPath();
    context.moveTo(LEFT, y(limit));
    context.lineTo(width, y(limit));
    context.stroke();
    context.setLineDash([]);
  }
  for (let number = (begun.value?.pantographs.length ?? 0) - 1; number >= 0; number--) {
    context.strokeStyle = colour(colourOf(number));
    context.lineWidth = 1.5;
    context.beginPath();
    trace.times.forEach((time, at) => context.lineTo(x(time), y(trace.forces[at]![number] ?? NaN)));
    context.stroke();
  }
}

export function Strip() {
  const canvas = useRef<HTMLCanvasElement>(null);
  useCanvas(canvas, paint);
  return (
    <figure class="strip">
      <figcaption>
        Contact force, N, of the last {SHOWN} s{begun.value?.highest ? `; dashed: ${begun.value.highest.about}, ${begun.value.highest.force_N} N` : ""}
      </figcaption>
      <canvas ref={canvas} role="img" aria-label={`Contact force in N of the last ${SHOWN} seconds`} />
    </figure>
  );
}
