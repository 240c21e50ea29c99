/** Layers of a figure on a canvas. Places in CSS pixels come from the axes. */
import { colour } from "./colours.ts";
import type { Area, Bars, Curve, Figure, Grid, Layer, Points, Rules, Segments, Strip, Texts } from "./figure.ts";
import { imageOf } from "./image.ts";
import { ascends, seen, trace } from "./thin.ts";

/** Where numbers are drawn, in pixels of the canvas, and the frame that they are drawn in. */
export interface Frame {
  x: (value: number) => number;
  y: (value: number) => number;
  left: number;
  top: number;
  width: number;
  height: number;
  /** What is shown of the first axis. */
  range: [number, number];
  /** Pixels of the canvas in a pixel of CSS. */
  ratio: number;
}

const DASHES = { solid: [], dashed: [7, 4], dotted: [2, 3] };
type Canvas = CanvasRenderingContext2D;

function stroke(at: Canvas, frame: Frame, width: number, dash: keyof typeof DASHES = "solid"): void {
  at.lineWidth = width * frame.ratio;
  at.setLineDash(DASHES[dash].map((part) => part * frame.ratio));
  at.stroke();
}

/** Above so many samples on a pixel, corners are too many to be seen round. */
const DENSE = 1;
/** Points of a path: a browser without a GPU sorts all edges of a path line by line, and takes several times longer for one long path. */
const OF_A_PATH = 32;

function curve(at: Canvas, { x, y, width, dash }: Curve, frame: Frame): void {
  const isAlong = ascends(x);
  const range: [number, number] = isAlong ? seen(x, ...frame.range) : [0, x.length];
  const place = (k: number): [number, number] => [frame.x(x[k]!), frame.y(y[k]!)];
  const isDense = range[1] - range[0] > DENSE * frame.width;
  let points = 0;
  const line = (px: number, py: number) => {
    at.lineTo(px, py);
    if (!isDense || dash !== "solid" || ++points % OF_A_PATH) return;
    stroke(at, frame, width);
    at.beginPath();
    at.moveTo(px, py);
  };
  at.lineJoin = isDense ? "bevel" : "round";
  at.beginPath();
  // A curve that goes back has its extremes anywhere.
  if (isAlong) trace(range, place, (px, py) => at.moveTo(px, py), line);
  else whole(at, range, place);
  stroke(at, frame, width, dash);
}

function whole(at: Canvas, [from, to]: [number, number], place: (k: number) => [number, number]): void {
  let open = false;
  for (let k = from; k < to; k++) {
    const [px, py] = place(k);
    if (Number.isNaN(px) || Number.isNaN(py)) open = false;
    else if (open) at.lineTo(px, py);
    else {
      at.moveTo(px, py);
      open = true;
    }
  }
}

function area(at: Canvas, { x, low, high }: Area, frame: Frame): void {
  at.beginPath();
  x.forEach((value, k) => at.lineTo(frame.x(value), frame.y(high[k]!)));
  for (let k = x.length - 1; k >= 0; k--) at.lineTo(frame.x(x[k]!), frame.y(low[k]!));
  at.fill();
}

/** Corners of a mark around its middle, in halves of its size. */
const SHAPES: Record<"triangle" | "down" | "diamond", [number, number][]> = {
  triangle: [[0, -1], [0.9, 0.7], [-0.9, 0.7]],
  down: [[0, 1], [0.9, -0.7], [-0.9, -0.7]],
  diamond: [[0, -1], [0.7, 0], [0, 1], [-0.7, 0]],
};

function mark(at: Canvas, shape: Points["shape"], x: number, y: number, half: number): void {
  if (shape === "circle") {
    at.moveTo(x + half, y);
    at.arc(x, y, half, 0, 2 * Math.PI);
  } else if (shape === "tick") {
    at.moveTo(x, y - half);
    at.lineTo(x, y + half);
  } else if (shape === "cross") {
    at.moveTo(x - half, y - half);
    at.lineTo(x + half, y + half);
    at.moveTo(x - half, y + half);
    at.lineTo(x + half, y - half);
  } else {
    SHAPES[shape].forEach(([dx, dy], k) => (k ? at.lineTo : at.moveTo).call(at, x + half * dx, y + half * dy));
    at.closePath();
  }
}

function shade(figure: Figure, value: number): string {
  const scale = figure.scale!;
  const part = (value - scale.low) / (scale.high - scale.low || 1);
  return scale.order[Math.round(Math.min(Math.max(part, 0), 1) * (scale.order.length - 1))]!;
}

function points(at: Canvas, layer: Points, frame: Frame, figure: Figure): void {
  const half = (layer.size * frame.ratio) / 2;
  const lined = layer.shape === "tick" || layer.shape === "cross";
  const ink = () => (lined ? stroke(at, frame, 1.5) : at.fill());
  at.beginPath();
  for (let k = 0; k < layer.x.length; k++) {
    mark(at, layer.shape, frame.x(layer.x[k]!), frame.y(layer.y[k]!), half);
    if (layer.values) {
      at.fillStyle = at.strokeStyle = shade(figure, layer.values[k]!);
      ink();
      at.beginPath();
    }
  }
  if (!layer.values) ink();
}

function segments(at: Canvas, { x0, y0, x1, y1, width }: Segments, frame: Frame): void {
  at.beginPath();
  x0.forEach((value, k) => {
    at.moveTo(frame.x(value), frame.y(y0[k]!));
    at.lineTo(frame.x(x1[k]!), frame.y(y1[k]!));
  });
  stroke(at, frame, width);
}

function bars(at: Canvas, { left, right, low, high }: Bars, frame: Frame): void {
  left.forEach((value, k) => {
    const [a, b, c, d] = [frame.x(value), frame.x(right[k]!), frame.y(high[k]!), frame.y(low[k]!)];
    at.fillRect(a, c, Math.max(b - a, 1), d - c);
  });
}

function strip(at: Canvas, { axis, low, high }: Strip, { x, y, left, top, width, height }: Frame): void {
  if (axis === "x") at.fillRect(x(low), top, x(high) - x(low), height);
  else at.fillRect(left, y(high), width, y(low) - y(high));
}

function rules(at: Canvas, layer: Rules, frame: Frame): void {
  at.beginPath();
  for (const value of layer.at) {
    const place = layer.axis === "x" ? frame.x(value) : frame.y(value);
    if (layer.axis === "x") {
      at.moveTo(place, frame.top);
      at.lineTo(place, frame.top + frame.height);
    } else {
      at.moveTo(frame.left, place);
      at.lineTo(frame.left + frame.width, place);
    }
  }
  stroke(at, frame, layer.width, layer.dash);
}

function map(at: Canvas, grid: Grid, frame: Frame, figure: Figure): void {
  const [x0, x1, y0, y1] = [frame.x(grid.x[0]), frame.x(grid.x[1]), frame.y(grid.y[0]), frame.y(grid.y[1])];
  at.imageSmoothingEnabled = false;
  at.drawImage(imageOf(grid, figure.scale!), x0, y1, x1 - x0, y0 - y1);
}

function texts(at: Canvas, layer: Texts, frame: Frame): void {
  const size = layer.size * frame.ratio;
  at.font = `${size}px ${getComputedStyle(document.body).fontFamily}`;
  [at.textAlign, at.textBaseline] = [layer.align, layer.baseline];
  layer.texts.forEach((text, k) => {
    const [x, y] = [frame.x(layer.x[k]!), frame.y(layer.y[k]!)];
    if (layer.backed) {
      const width = at.measureText(text).width;
      const from = x - { left: 0, center: width / 2, right: width }[layer.align];
      const above = y - { top: 0, middle: size / 2, bottom: size }[layer.baseline];
      at.fillStyle = colour("paper");
      at.fillRect(from - 2, above - 1, width + 4, size + 2);
    }
    at.fillStyle = colour(layer.colour);
    at.fillText(text, x, y);
  });
}

function one(at: Canvas, layer: Layer, frame: Frame, figure: Figure): void {
  switch (layer.kind) {
    case "curve": return curve(at, layer, frame);
    case "area": return area(at, layer, frame);
    case "points": return points(at, layer, frame, figure);
    case "segments": return segments(at, layer, frame);
    case "bars": return bars(at, layer, frame);
    case "strip": return strip(at, layer, frame);
    case "rules": return rules(at, layer, frame);
    case "map": return map(at, layer, frame, figure);
    case "texts": return texts(at, layer, frame);
  }
}

/** Draw the layers of a figure that are not hidden, the first one lowest. */
export function draw(at: Canvas, figure: Figure, frame: Frame, isHidden: (layer: Layer) => boolean): void {
  at.save();
  at.beginPath();
  at.rect(frame.left, frame.top, frame.width, frame.height);
  at.clip();
  for (const layer of figure.layers) {
    if (isHidden(layer)) continue;
    at.globalAlpha = layer.alpha;
    at.strokeStyle = at.fillStyle = colour(layer.colour);
    one(at, layer, frame, figure);
  }
  at.restore();
}
