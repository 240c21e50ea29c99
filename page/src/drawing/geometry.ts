/** A line at rest as the server gives it, SI units: points are (along, to the left, up) in m. */

export type Point = [number, number, number];
export type WireKind = "contact" | "messenger" | "auxiliary" | "stitch" | "bridle";

export interface Wire {
  name: string;
  kind: WireKind;
  /** Number of its first node among all of its kind in a result. */
  first: number;
  x: number[];
  y: number[];
  z: number[];
}

export interface Dropper {
  name: string;
  /** From 1. */
  span: number;
  x_m: number;
  top: Point;
  bottom: Point;
  length_m: number;
  force_N: number;
  /** Of its lower end: number of the wire, from 0, and of the node in it. */
  wire: number;
  node: number;
  top_wire: number;
  top_node: number;
}

export interface Support {
  name: string;
  x_m: number;
  stagger_m: number;
  /** Of the contact wire there. */
  wire: number;
  node: number;
  arms: { from: Point; to: Point }[];
}

export interface Span {
  number: number;
  start_m: number;
  end_m: number;
}

export interface Geometry {
  name: string;
  spatial: boolean;
  /** Nominal height of the contact wire above rail. */
  height_m: number;
  spans: Span[];
  wires: Wire[];
  droppers: Dropper[];
  supports: Support[];
}

/** A field of the text behind a part of the drawing, and the place in m its value counts from. */
export interface Handle {
  field: string;
  from_m: number;
}

export interface Handles {
  droppers: (Handle | null)[];
  supports: (Handle | null)[];
}
