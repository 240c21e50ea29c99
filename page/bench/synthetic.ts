/**
 * A motion whose values are known: ten spans of 55 m with contact and messenger wire, and two
 * pantographs; each node moves by a sum of travelling waves. SI units.
 */
import type { Dropper, Geometry, Support } from "../src/drawing/geometry.ts";
import type { Store } from "../src/player/motion/store.ts";

export const SPAN = 55;
export const SPANS = 10;
export const SPEED = 80; // m/s
const HEIGHT = 5.3;
const SYSTEM = 1.2;
const SAG = 0.055;
const DROPPERS = 9;
const DISTANCE = 200; // between pantographs, m

export function lineOf(points: number): Geometry {
  const nodes = Math.floor(points / 2);
  const x = Array.from({ length: nodes }, (_, node) => (node * SPAN * SPANS) / (nodes - 1));
  const within = (at: number) => (at % SPAN) / SPAN;
  const contact = x.map((at) => HEIGHT - 4 * SAG * within(at) * (1 - within(at)));
  const messenger = x.map((at) => HEIGHT + SYSTEM - 4 * 0.9 * within(at) * (1 - within(at)));
  const stagger = x.map((at) => 0.2 * Math.cos((Math.PI * at) / SPAN));
  const nodeAt = (at: number) => Math.round((at / (SPAN * SPANS)) * (nodes - 1));
  const droppers: Dropper[] = Array.from({ length: SPANS * DROPPERS }, (_, number) => {
    const span = Math.floor(number / DROPPERS);
    const node = nodeAt(span * SPAN + ((number % DROPPERS) + 0.5) * (SPAN / DROPPERS));
    const y = stagger[node]!;
    return {
      name: `span ${span + 1} dropper ${(number % DROPPERS) + 1}`, span: span + 1, x_m: x[node]!,
      top: [x[node]!, y, messenger[node]!], bottom: [x[node]!, y, contact[node]!],
      length_m: messenger[node]! - contact[node]!, force_N: 90, wire: 0, node, top_wire: 1, top_node: node,
    };
  });
  const supports: Support[] = Array.from({ length: SPANS + 1 }, (_, number) => {
    const node = nodeAt(number * SPAN);
    const y = stagger[node]!;
    return {
      name: `support ${number + 1}`, x_m: x[node]!, stagger_m: y, wire: 0, node,
      arms: [{ from: [x[node]!, y, HEIGHT], to: [x[node]!, y + (y > 0 ? 1 : -1), HEIGHT + 0.3] }],
    };
  });
  return {
    name: "Synthetic line", spatial: true, height_m: HEIGHT, droppers, supports,
    spans: Array.from({ length: SPANS }, (_, span) => ({ number: span + 1, start_m: span * SPAN, end_m: (span + 1) * SPAN })),
    wires: [
      { name: "contact wire", kind: "contact", first: 0, x, y: stagger, z: contact },
      { name: "messenger wire", kind: "messenger", first: 0, x, y: stagger, z: messenger },
    ],
  };
}

/** Displacement in m at a position and a time: a hump under each pantograph, and waves ahead. */
export function upAt(x: number, time: number): number {
  let sum = 0;
  for (const start of [DISTANCE, 0]) {
    const away = x - (start + 40 + SPEED * time);
    sum += 0.05 * Math.exp(-((away / 12) ** 2)) + 0.006 * Math.sin(0.35 * away) * Math.exp(-Math.abs(away) / 60);
  }
  return sum;
}

/** Fill a store with moments at `rate` a second. */
export function fill(store: Store, line: Geometry, seconds: number, rate: number): void {
  for (let row = 0; row <= seconds * rate; row++) {
    const time = row / rate;
    for (const [number, share] of [[0, 1], [1, 0.8]] as const) {
      const up = Float32Array.from(line.wires[number]!.x, (x) => share * upAt(x, time));
      store.add(`wire.${number}.up`, time, { first: 0, values: up });
    }
    store.add("droppers", time, {
      first: 0, values: Float32Array.from(line.droppers, ({ x_m }) => Math.max(0, 90 - 2500 * upAt(x_m, time))),
    });
    store.add("supports", time, { first: 0, values: Float32Array.from(line.supports, ({ x_m }) => upAt(x_m, time)) });
    [DISTANCE, 0].forEach((start, number) => {
      const x = start + 40 + SPEED * time;
      const up = upAt(x, time);
      const force = 150 + 60 * Math.sin(9 * time + number);
      store.add(`pantograph.${number}`, time, { first: 0, values: Float32Array.of(x, force, HEIGHT + up, up, 0.2 * up, 0.6 * up, up) });
    });
  }
  store.cover({ from: 0, to: seconds, every: 0 });
}
