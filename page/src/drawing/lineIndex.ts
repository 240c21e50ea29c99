/** A geometry as typed arrays in m, with what drawing and picking look up. */
import type { Geometry, Wire, WireKind } from "./geometry.ts";

export interface WireArrays {
  kind: WireKind;
  name: string;
  x: Float64Array;
  y: Float64Array;
  z: Float64Array;
  /** Whether it runs beside an earlier wire of its kind, which hides it from the side: the second of twins. */
  isSecond: boolean;
}

export interface LineIndex {
  wires: WireArrays[];
  /** Positions of droppers in m, ascending, and the number of each in the geometry. */
  dropperX: Float64Array;
  dropperOrder: Uint32Array;
  /** Ends of the line, and of its heights and lateral positions, in m. */
  x: [number, number];
  y: [number, number];
  z: [number, number];
}

const known = new WeakMap<Geometry, LineIndex>();

/** Kinds of which two may run side by side all along a line. */
const IN_PAIRS: readonly WireKind[] = ["contact", "messenger", "auxiliary"];
/** Wires that have more than this share of their length in common are twins; in an overlap it is a tenth. */
const TWINS = 0.5;

/** Whether a wire runs beside one of the earlier ones of its kind. */
function isSecond(wires: readonly Wire[], number: number): boolean {
  const own = wires[number]!;
  const [start, end] = [own.x[0] ?? 0, own.x.at(-1) ?? 0];
  if (!IN_PAIRS.includes(own.kind)) return false;
  return wires.slice(0, number).some(({ kind, x }) => {
    const common = Math.min(end, x.at(-1) ?? 0) - Math.max(start, x[0] ?? 0);
    return kind === own.kind && common > TWINS * (end - start);
  });
}

/** The index of a geometry, made once. */
export function indexOf(geometry: Geometry): LineIndex {
  const found = known.get(geometry) ?? made(geometry);
  known.set(geometry, found);
  return found;
}

function made(geometry: Geometry): LineIndex {
  const wires = geometry.wires.map(({ kind, name, x, y, z }, number) => ({
    kind,
    name,
    x: Float64Array.from(x),
    y: Float64Array.from(y),
    z: Float64Array.from(z),
    isSecond: isSecond(geometry.wires, number),
  }));
  const order = Uint32Array.from(geometry.droppers.keys());
  order.sort((a, b) => geometry.droppers[a]!.x_m - geometry.droppers[b]!.x_m);
  const ends = (axis: "x" | "y" | "z"): [number, number] => {
    let [low, high] = [Infinity, -Infinity];
    for (const wire of wires) {
      for (const value of wire[axis]) {
        if (value < low) low = value;
        if (value > high) high = value;
      }
    }
    return low <= high ? [low, high] : [0, 0];
  };
  return {
    wires,
    dropperX: Float64Array.from(order, (number) => geometry.droppers[number]!.x_m),
    dropperOrder: order,
    x: ends("x"),
    y: ends("y"),
    z: ends("z"),
  };
}

/** Number of values of an ascending array that are below a value. */
export function below(values: ArrayLike<number>, value: number): number {
  let [low, high] = [0, values.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if (values[middle]! < value) low = middle + 1;
    else high = middle;
  }
  return low;
}

/** Nodes of a wire between two positions in m, one more on either side: first and last + 1. */
export function between(wire: WireArrays, x0: number, x1: number): [number, number] {
  return [Math.max(0, below(wire.x, x0) - 1), Math.min(wire.x.length, below(wire.x, x1) + 1)];
}

/** Height in m of a wire at a position in m, or its lateral position; null off its ends. */
export function valueAt(wire: WireArrays, axis: "y" | "z", x: number): number | null {
  const { x: along, [axis]: values } = wire;
  const last = along.length - 1;
  if (last < 1 || x < along[0]! || x > along[last]!) return null;
  const right = Math.min(Math.max(below(along, x), 1), last);
  const share = (x - along[right - 1]!) / (along[right]! - along[right - 1]! || 1);
  return values[right - 1]! + share * (values[right]! - values[right - 1]!);
}

/** The lowest contact wire at a position in m: its number and its height in m. */
export function contactAt(line: LineIndex, x: number): { wire: number; z: number } | null {
  let found: { wire: number; z: number } | null = null;
  line.wires.forEach((wire, number) => {
    const z = wire.kind === "contact" ? valueAt(wire, "z", x) : null;
    if (z !== null && (!found || z < found.z)) found = { wire: number, z };
  });
  return found;
}
