/**
 * The part of a line that the 3-D view holds, as positions of vertices: x along the track from the
 * centre of the part, y up, z to the right, m. Displacements are exaggerated, the line at rest is to
 * scale.
 */
import type { Geometry, Point } from "../../drawing/geometry.ts";
import { below, indexOf } from "../../drawing/lineIndex.ts";
import type { MotionState } from "../motion/state.ts";

/** Half of the length that is held, in m: a dozen spans, and 16 000 nodes of a fine mesh. */
export const HALF = 450;
/** The part is made anew where the place looked at is so near to its end, in m. */
const NEAR = 150;

export interface Part {
  wire: number;
  first: number;
  end: number;
  positions: Float32Array;
}

export interface Segment {
  /** Wire and node that each end moves with; -1 for an end that is fixed. */
  wires: [number, number];
  nodes: [number, number];
  ends: [Point, Point];
}

export interface Section {
  centre: number;
  from: number;
  to: number;
  wires: Part[];
  droppers: Segment[];
  /** Numbers of the droppers in the geometry. */
  dropperNumbers: number[];
  arms: Segment[];
  /** Numbers of the supports in the geometry. */
  supports: number[];
}

/** Whether a place is well inside of a part, or the part has all that there is. */
export function holds(section: Section, geometry: Geometry, x: number): boolean {
  const [start, end] = indexOf(geometry).x;
  return (x > section.from + NEAR || section.from <= start) && (x < section.to - NEAR || section.to >= end);
}

export function sectionAround(geometry: Geometry, x: number): Section {
  const line = indexOf(geometry);
  const [from, to] = [x - HALF, x + HALF];
  const inside = (at: number) => at >= from && at <= to;
  const wires = line.wires.map((wire, number): Part => {
    const [first, end] = [below(wire.x, from), below(wire.x, to)];
    const positions = new Float32Array(3 * Math.max(0, end - first));
    for (let node = first; node < end; node++) {
      positions.set([wire.x[node]! - x, wire.z[node]!, -wire.y[node]!], 3 * (node - first));
    }
    return { wire: number, first, end, positions };
  });
  const dropperNumbers = [...geometry.droppers.keys()].filter((number) => inside(geometry.droppers[number]!.x_m));
  const supports = [...geometry.supports.keys()].filter((number) => inside(geometry.supports[number]!.x_m));
  return {
    centre: x,
    from,
    to,
    wires,
    dropperNumbers,
    droppers: dropperNumbers.map((number) => {
      const { top, bottom, wire, node, top_wire, top_node } = geometry.droppers[number]!;
      return { wires: [top_wire, wire], nodes: [top_node, node], ends: [top, bottom] };
    }),
    supports,
    arms: supports.flatMap((number) => {
      const { arms, wire, node } = geometry.supports[number]!;
      // The arm's end at the wire moves, its hinge is fixed.
      return arms.map((arm): Segment => ({ wires: [wire, -1], nodes: [node, -1], ends: [arm.from, arm.to] }));
    }),
  };
}

/** Set heights and lateral positions of the nodes of a part that move, or did before. */
export function moveWire(part: Part, rest: { y: Float64Array; z: Float64Array }, state: MotionState, larger: number): boolean {
  const motion = state.wires[part.wire];
  if (!motion) return false;
  for (let node = part.first; node < part.end; node++) {
    const at = 3 * (node - part.first);
    part.positions[at + 1] = rest.z[node]! + larger * motion.up[node]!;
    if (motion.across) part.positions[at + 2] = -rest.y[node]! - larger * motion.across[node]!;
  }
  return true;
}

/** Write both ends of a segment at a place of `out`, displaced with their nodes. */
export function writeSegment(out: Float32Array, at: number, one: Segment, centre: number, state: MotionState | null, larger: number): void {
  for (const end of [0, 1] as const) {
    const [x, y, z] = one.ends[end];
    const motion = one.wires[end] < 0 ? undefined : state?.wires[one.wires[end]];
    const node = one.nodes[end];
    out[at + 3 * end] = x - centre;
    out[at + 3 * end + 1] = z + larger * (motion?.up[node] ?? 0);
    out[at + 3 * end + 2] = -y - larger * (motion?.across?.[node] ?? 0);
  }
}
