/**
 * A figure in a uPlot: axes, grid, cursor and selection are its; layers are drawn on its canvas.
 * Nothing here knows signals: `Chart.tsx` ties ranges and cursors to those of the window.
 */
import uPlot from "uplot";
import "uplot/dist/uPlot.min.css";
import { colour } from "./colours.ts";
import { ends, type Range } from "./extent.ts";
import type { Axis, Figure, Layer } from "./figure.ts";
import { draw, type Frame } from "./layers.ts";
import { logarithmicTicks, powered, stepped } from "./numbers.ts";

/** What a chart tells whoever made it. */
export interface Told {
  /** A box was drawn with the pointer. */
  box: (x: Range, y: Range) => void;
  /** The pointer moved: place in units of the axes, and in px of the frame; null: it left. */
  pointer: (at: { x: number; y: number; px: number; py: number } | null) => void;
}

/** Frames of all figures begin at the same place, in px; room for numbers below them. */
const LEFT = 44;
const BELOW = 30;
/** A box smaller than this in px was a click. */
const LEAST_BOX = 6;

export class Plot {
  readonly u: uPlot;
  private x: Range;
  private y: Range;
  private marked: number | null = null;
  /** The line of the cursor, which other views move: drawing all anew would be slower. */
  private readonly line = document.createElement("div");

  constructor(
    into: HTMLElement,
    private figure: Figure,
    private readonly isHidden: (layer: Layer) => boolean,
    told: Told,
  ) {
    this.x = ends(figure.x, figure.layers, "x");
    this.y = ends(figure.y, figure.layers, "y");
    this.line.className = "chart-cursor";
    this.line.hidden = true;
    this.u = new uPlot(this.options(into, told), [[], []], into);
    this.u.over.append(this.line);
    // The text that reads a chart is its own, beside it.
    this.u.root.setAttribute("aria-hidden", "true");
  }

  private options(into: HTMLElement, told: Told): uPlot.Options {
    const { figure } = this;
    const distribution = (axis: Axis) => (axis.logarithmic ? { distr: 3 as const } : {});
    return {
      width: Math.max(into.clientWidth, 200),
      height: figure.height,
      pxAlign: 0,
      legend: { show: false },
      padding: [8, 14, 0, 0],
      scales: {
        x: { time: false, range: () => this.x, ...distribution(figure.x) },
        y: { range: () => this.y, ...distribution(figure.y) },
      },
      axes: [{ ...axisOf(figure.x, "x", figure), size: BELOW }, { ...axisOf(figure.y, "y", figure), size: LEFT }],
      series: [{}, { show: false }],
      cursor: {
        drag: { x: true, y: true, setScale: false, dist: LEAST_BOX },
        points: { show: false },
        y: true,
      },
      hooks: {
        draw: [(u) => this.paint(u)],
        setSelect: [(u) => this.boxed(u, told)],
        setCursor: [(u) => told.pointer(place(u))],
      },
    };
  }

  private boxed(u: uPlot, told: Told): void {
    const { left, top, width, height } = u.select;
    if (width < LEAST_BOX && height < LEAST_BOX) return;
    u.setSelect({ left: 0, top: 0, width: 0, height: 0 }, false);
    const x = width < LEAST_BOX ? this.x : pair(u, "x", left, left + width);
    const y = height < LEAST_BOX ? this.y : pair(u, "y", top + height, top);
    told.box(x, y);
  }

  /** Where numbers are drawn, in pixels of the canvas. */
  frame(): Frame {
    const { left, top, width, height } = this.u.bbox;
    const along = ([low, high]: Range, axis: Axis, from: number, extent: number) => {
      if (!axis.logarithmic) {
        const factor = extent / (high - low);
        return (value: number) => from + (value - low) * factor;
      }
      const factor = extent / Math.log(high / low);
      return (value: number) => (value > 0 ? from + Math.log(value / low) * factor : NaN);
    };
    return {
      x: along(this.x, this.figure.x, left, width),
      y: along(this.y, this.figure.y, top + height, -height),
      left,
      top,
      width,
      height,
      range: this.x,
      ratio: uPlot.pxRatio,
    };
  }

  private paint(u: uPlot): void {
    draw(u.ctx, this.figure, this.frame(), this.isHidden);
    this.place();
  }

  /** Put the line of the cursor where its place is now. */
  private place(): void {
    const { left, width, x } = this.frame();
    const at = this.marked === null ? NaN : x(this.marked) - left;
    this.line.hidden = !(at >= 0 && at <= width);
    if (!this.line.hidden) this.line.style.transform = `translateX(${at / uPlot.pxRatio}px)`;
  }

  get ranges(): { x: Range; y: Range } {
    return { x: this.x, y: this.y };
  }

  /** Show a range; without one that of the figure. */
  show(x: Range | null, y: Range | null = null): void {
    this.x = x ?? ends(this.figure.x, this.figure.layers, "x");
    if (y) this.y = y;
    this.u.setScale("x", { min: this.x[0], max: this.x[1] });
    this.u.setScale("y", { min: this.y[0], max: this.y[1] });
  }

  /** Show the whole range of the second axis again. */
  wholeY(): void {
    this.y = ends(this.figure.y, this.figure.layers, "y");
  }

  /** Take other layers of the same figure: those of a range, with more samples. */
  take(figure: Figure): void {
    this.figure = figure;
    this.redraw();
  }

  /** Mark a place of the first axis: the cursor of another view. */
  mark(x: number | null): void {
    this.marked = x;
    this.place();
  }

  redraw(): void {
    this.u.redraw(false, true);
  }

  resize(width: number): void {
    this.u.setSize({ width: Math.max(width, 200), height: this.figure.height });
  }

  destroy(): void {
    this.u.destroy();
  }
}

function pair(u: uPlot, scale: "x" | "y", from: number, to: number): Range {
  return [u.posToVal(from, scale), u.posToVal(to, scale)];
}

function place(u: uPlot): { x: number; y: number; px: number; py: number } | null {
  const { left = -1, top = -1 } = u.cursor;
  if (left < 0 || top < 0) return null;
  return { x: u.posToVal(left, "x"), y: u.posToVal(top, "y"), px: left, py: top };
}

function axisOf(axis: Axis, side: "x" | "y", figure: Figure): uPlot.Axis {
  const family = getComputedStyle(document.body).fontFamily;
  const isMap = figure.layers.some((layer) => layer.kind === "map");
  return {
    scale: side,
    label: axis.title,
    labelSize: 22,
    font: `12px ${family}`,
    labelFont: `12px ${family}`,
    stroke: () => colour("soft"),
    // A grid would lie below a map, and be seen through its holes alone.
    grid: { show: !isMap, stroke: () => colour("grid"), width: 1 },
    ticks: { stroke: () => colour("rule"), width: 1, size: 5 },
    ...(axis.categories.length ? named(axis.categories) : {}),
    ...(axis.logarithmic
      ? {
          splits: (_u, _k, low, high) => logarithmicTicks(low, high),
          filter: (_u, splits) => splits,
          values: (_u, splits) => splits.map((value) => powered(value, splits)),
        }
      : {}),
    ...(axis.categories.length || axis.logarithmic ? {} : { values: (_u, splits) => texts(splits, axis.form) }),
  };
}

function texts(splits: number[], form: string): string[] {
  const step = splits.length > 1 ? splits[1]! - splits[0]! : 1;
  const digits = (form.split(".")[1] ?? "").length;
  return splits.map((value) => stepped(value, form ? Math.min(step, 10 ** -digits) : step));
}

function named(names: string[]): Partial<uPlot.Axis> {
  const marked = names.map((name, k) => (name ? k : -1)).filter((k) => k >= 0);
  const inside = (u: uPlot, axis: number) => {
    const scale = u.scales[axis === 0 ? "x" : "y"]!;
    return marked.filter((k) => k >= scale.min! && k <= scale.max!);
  };
  return { splits: (u, axis) => inside(u, axis), values: (_u, splits) => splits.map((k) => names[k] ?? "") };
}
