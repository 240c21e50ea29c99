/** The space–time view on its canvas: image, axes, supports, paths, fronts, clock. */
import { colour } from "../charts/colours.ts";
import type { Scale } from "../charts/figure.ts";
import { imageOf } from "../charts/image.ts";
import { decimals, stepped } from "../charts/numbers.ts";
import { placesOf, ticks, type About, type Frame, type Part } from "./view.ts";

const MARGIN = { left: 62, right: 14, top: 10, bottom: 44 };
/** A path is named at this share of what is seen of it. */
const NAMED = 0.8;
/** Of the tokens; blue downwards, red upwards, told apart by those who see no green. */
const ORDER = ["#2c5aa0", "#6f9bd1", "#b9d0e8", "#f2f2f2", "#f2c4a8", "#dd8452", "#a4431c"];

export interface Shown {
  about: About;
  values: Float32Array;
}

export interface Marks {
  waves: boolean;
  /** Of the clock in s, and of the cursor in m. */
  time_s: number;
  cursor_m: number | null;
}

export function scaleOf(end: number): Scale {
  return {
    title: "velocity of the contact wire, upwards, m/s",
    label: "velocity of the contact wire, upwards,",
    unit: "m/s",
    low: -end,
    high: end,
    order: ORDER,
    under: "",
    under_label: "",
  };
}

export function frameOf(width: number, height: number): Frame {
  const { left, right, top, bottom } = MARGIN;
  return { left, top, width: Math.max(width - left - right, 10), height: Math.max(height - top - bottom, 10) };
}

function axes(at: CanvasRenderingContext2D, part: Part, frame: Frame): void {
  const places = placesOf(part, frame);
  const family = getComputedStyle(document.body).fontFamily;
  at.font = `12px ${family}`;
  at.fillStyle = colour("soft");
  at.strokeStyle = colour("rule");
  at.textAlign = "center";
  at.textBaseline = "top";
  const below = frame.top + frame.height;
  const along = ticks(part.x, frame.width / 90);
  for (const x of along.at) at.fillText(stepped(x, along.step), places.x(x), below + 6);
  at.fillText("position along the track, m", frame.left + frame.width / 2, below + 26);
  at.textAlign = "right";
  at.textBaseline = "middle";
  const up = ticks(part.t, frame.height / 40);
  for (const t of up.at) at.fillText(stepped(t, up.step), frame.left - 6, places.t(t));
  at.save();
  at.translate(14, frame.top + frame.height / 2);
  at.rotate(-Math.PI / 2);
  at.textAlign = "center";
  at.fillText("time, s", 0, 0);
  at.restore();
  at.strokeRect(frame.left, frame.top, frame.width, frame.height);
}

function lines(at: CanvasRenderingContext2D, ink: string, width: number, dash: number[], draw: () => void): void {
  at.strokeStyle = ink;
  at.lineWidth = width;
  at.setLineDash(dash);
  at.beginPath();
  draw();
  at.stroke();
  at.setLineDash([]);
}

/** A name beside a line, on paper of its own: the map below has all colours. */
function name(at: CanvasRenderingContext2D, text: string, x: number, y: number, frame: Frame): void {
  const width = at.measureText(text).width + 8;
  const left = Math.min(Math.max(x, frame.left + 2), frame.left + frame.width - width - 2);
  at.fillStyle = colour("paper");
  at.fillRect(left, y - 9, width, 18);
  at.fillStyle = colour("ink");
  at.fillText(text, left + 4, y);
}

/** Names at the lines: each path near its upper end, the wave speed at the longest front that is seen. */
function names(at: CanvasRenderingContext2D, part: Part, about: About, waves: boolean, frame: Frame): void {
  const places = placesOf(part, frame);
  at.font = `12px ${getComputedStyle(document.body).fontFamily}`;
  at.textAlign = "left";
  at.textBaseline = "middle";
  about.paths.forEach((path, number) => {
    const seen = path.x.map((x, k): [number, number] => [places.x(x), places.t(path.t[k]!)]).filter(isIn(frame));
    // Paths of several pantographs are close to one another: their names stand one below the other.
    const [x, y] = seen[Math.floor(NAMED * (seen.length - 1))] ?? [];
    if (x !== undefined) name(at, path.name, x + 8, y! + 20 * number, frame);
  });
  if (!waves || !about.wave_speed) return;
  const middles = about.fronts.map(([x0, t0, x1, t1]): [number, number, number] => [
    (places.x(x0) + places.x(x1)) / 2, (places.t(t0) + places.t(t1)) / 2, Math.abs(places.x(x1) - places.x(x0)),
  ]);
  const [x, y] = middles.filter(([a, b]) => isIn(frame)([a, b])).sort((a, b) => b[2] - a[2])[0] ?? [];
  if (x !== undefined) name(at, `wave speed ${decimals(about.wave_speed, 1)} m/s`, x + 8, y! + 12, frame);
}

const isIn = ({ left, top, width, height }: Frame) => ([x, y]: [number, number]): boolean =>
  x >= left && x <= left + width && y >= top && y <= top + height;

/** Draw a part; the image may be of another one, from before a zoom. */
export function paint(canvas: HTMLCanvasElement, part: Part, shown: Shown | null, marks: Marks): void {
  const ratio = devicePixelRatio;
  const [width, height] = [canvas.clientWidth, canvas.clientHeight];
  if (canvas.width !== Math.round(width * ratio)) canvas.width = Math.round(width * ratio);
  if (canvas.height !== Math.round(height * ratio)) canvas.height = Math.round(height * ratio);
  const at = canvas.getContext("2d");
  if (!at) return;
  at.setTransform(ratio, 0, 0, ratio, 0, 0);
  at.clearRect(0, 0, width, height);
  const frame = frameOf(width, height);
  const places = placesOf(part, frame);
  at.save();
  at.beginPath();
  at.rect(frame.left, frame.top, frame.width, frame.height);
  at.clip();
  if (shown) inside(at, part, shown, marks, frame);
  const line = (x0: number, y0: number, x1: number, y1: number) => {
    at.moveTo(x0, y0);
    at.lineTo(x1, y1);
  };
  lines(at, colour("accent"), 1, [], () => {
    line(frame.left, places.t(marks.time_s), frame.left + frame.width, places.t(marks.time_s));
    if (marks.cursor_m !== null) line(places.x(marks.cursor_m), frame.top, places.x(marks.cursor_m), frame.top + frame.height);
  });
  at.restore();
  axes(at, part, frame);
}

function inside(at: CanvasRenderingContext2D, part: Part, { about, values }: Shown, marks: Marks, frame: Frame): void {
  const places = placesOf(part, frame);
  const [x0, x1] = about.x.map(places.x) as [number, number];
  const [y0, y1] = about.t.map(places.t) as [number, number];
  at.imageSmoothingEnabled = false;
  at.drawImage(imageOf({ values, shape: [about.rows, about.columns] }, scaleOf(about.scale_end)), x0, y1, x1 - x0, y0 - y1);
  lines(at, colour("rest"), 1, [2, 3], () => {
    for (const support of about.supports) {
      at.moveTo(places.x(support), frame.top);
      at.lineTo(places.x(support), frame.top + frame.height);
    }
  });
  if (marks.waves) {
    lines(at, colour("wave"), 1.2, [7, 4], () => {
      for (const [x0, t0, x1, t1] of about.fronts) {
        at.moveTo(places.x(x0), places.t(t0));
        at.lineTo(places.x(x1), places.t(t1));
      }
    });
  }
  for (const path of about.paths) {
    for (const [ink, width] of [[colour("wave"), 3.6], [colour(path.colour), 2]] as const) {
      lines(at, ink, width, [], () => path.x.forEach((x, k) => at.lineTo(places.x(x), places.t(path.t[k]!))));
    }
  }
  names(at, part, about, marks.waves, frame);
}
