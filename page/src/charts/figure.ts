/**
 * Descriptions of figures, as `arcless.figures` makes them and the server tells them: title, two
 * axes, layers from below upwards. Numbers of layers travel as little-endian singles in base64.
 */

export interface Axis {
  label: string;
  unit: string;
  title: string;
  low: number | null;
  high: number | null;
  bounds: [number, number] | null;
  logarithmic: boolean;
  categories: string[];
  /** Figures whose axes have the same group show the same range. */
  group: string;
  /** Decimals, as in "0.00"; empty where the chart chooses. */
  form: string;
}

export interface Scale {
  title: string;
  label: string;
  unit: string;
  low: number;
  high: number;
  /** Colours from `low` to `high`, `#rrggbb`. */
  order: string[];
  under: string;
  under_label: string;
}

/** A line under the pointer. */
export interface Tip {
  label: string;
  unit: string;
  form: string;
  /** "x" or "y" for the place; else a value for each thing drawn. */
  values: string | { texts: string[] } | { numbers: Float32Array };
}

interface Look {
  colour: string;
  name: string;
  alpha: number;
  tips: Tip[];
  hidden: boolean;
}

type Dash = "solid" | "dashed" | "dotted";
type Numbers = Float32Array;

export type Curve = Look & { kind: "curve"; x: Numbers; y: Numbers; width: number; dash: Dash; samples: number };
export type Area = Look & { kind: "area"; x: Numbers; low: Numbers; high: Numbers };
export type Points = Look & {
  kind: "points";
  x: Numbers;
  y: Numbers;
  size: number;
  shape: "circle" | "tick" | "triangle" | "down" | "diamond" | "cross";
  values: Numbers | null;
};
export type Segments = Look & { kind: "segments"; x0: Numbers; y0: Numbers; x1: Numbers; y1: Numbers; width: number };
export type Bars = Look & { kind: "bars"; left: Numbers; right: Numbers; low: Numbers; high: Numbers };
export type Strip = Look & { kind: "strip"; axis: "x" | "y"; low: number; high: number };
export type Rules = Look & { kind: "rules"; axis: "x" | "y"; at: Numbers; width: number; dash: Dash };
/** `shape` is rows, columns; the first row lies at the lower edge. */
export type Grid = Look & {
  kind: "map";
  x: [number, number];
  y: [number, number];
  values: Numbers;
  shape: [number, number];
};
export type Texts = Look & {
  kind: "texts";
  x: Numbers;
  y: Numbers;
  texts: string[];
  size: number;
  align: "left" | "center" | "right";
  baseline: "top" | "middle" | "bottom";
  backed: boolean;
};
export type Layer = Curve | Area | Points | Segments | Bars | Strip | Rules | Grid | Texts;

/** All of a figure but its layers. */
export interface Head {
  key: string;
  title: string;
  caption: string;
  alt: string;
  /** In px. */
  height: number;
  x: Axis;
  y: Axis;
  scale: Scale | null;
}

export interface Figure extends Head {
  layers: Layer[];
}

/** A range of the first axis, and how many samples of each curve are wished. */
export interface Shown {
  from?: number;
  to?: number;
  points: number;
}

/** Figures of a section of a report, in rows. */
export interface Section {
  key: string;
  title: string;
  rows: Head[][];
}

/** Numbers of base64; a system of numbers that begins with another end reads them wrongly: none is left. */
export function unpacked(text: string): Float32Array {
  const bytes = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
  return new Float32Array(bytes.buffer);
}

const NUMBERS = new Set(["x", "y", "x0", "y0", "x1", "y1", "left", "right", "low", "high", "at", "values"]);

type Told = Record<string, unknown>;

function tip(told: Told): Tip {
  const values = told["values"] as string | { texts: string[] } | { numbers: string };
  const read = typeof values === "object" && "numbers" in values ? { numbers: unpacked(values.numbers) } : values;
  return { ...(told as unknown as Tip), values: read };
}

/** A figure as it was told → with its numbers. */
export function figureOf(told: unknown): Figure {
  const { layers, ...head } = told as { layers: Told[] } & Head;
  return {
    ...head,
    layers: layers.map((layer) => {
      const read = Object.entries(layer).map(([name, value]) =>
        typeof value === "string" && NUMBERS.has(name) ? [name, unpacked(value)] : [name, value],
      );
      const found = Object.fromEntries(read) as Told;
      found["tips"] = (layer["tips"] as Told[]).map(tip);
      return found as unknown as Layer;
    }),
  };
}
