import { describe, expect, it } from "vitest";
import { camera, fitted, kept, LEFT, nextExaggeration, RIGHT, ticks, zoomed } from "./camera.ts";
import type { Geometry } from "./geometry.ts";
import { below, between, contactAt, indexOf, valueAt } from "./lineIndex.ts";
import { droppersSeen, forceOf } from "./linePainter.ts";
import { pick } from "./pick.ts";
import { shift, traceWire } from "./wirePath.ts";
import { drawingInWords, pickedInWords, placeInWords } from "./words.ts";

/** Two spans of 50 m: a contact wire at 5.3 m, a messenger wire 1.2 m above, droppers every 10 m. */
function line(nodes = 101): Geometry {
  const x = Array.from({ length: nodes }, (_, n) => (100 * n) / (nodes - 1));
  const at = (z: number) => ({ first: 0, x, y: x.map(() => 0.1), z: x.map(() => z) });
  const places = [10, 20, 30, 40, 60, 70, 80, 90];
  return {
    name: "short",
    spatial: true,
    height_m: 5.3,
    spans: [
      { number: 1, start_m: 0, end_m: 50 },
      { number: 2, start_m: 50, end_m: 100 },
    ],
    wires: [
      { name: "contact wire", kind: "contact", ...at(5.3) },
      { name: "messenger wire", kind: "messenger", ...at(6.5) },
    ],
    droppers: places.map((x_m, n) => ({
      name: `span ${x_m < 50 ? 1 : 2} dropper ${(n % 4) + 1}`,
      span: x_m < 50 ? 1 : 2,
      x_m,
      top: [x_m, 0.1, 6.5],
      bottom: [x_m, 0.1, 5.3],
      length_m: 1.2,
      force_N: n === 1 ? 0 : 50,
      wire: 0,
      node: x_m,
      top_wire: 1,
      top_node: x_m,
    })),
    supports: [0, 50, 100].map((x_m, n) => ({
      name: `support ${n + 1}`, x_m, stagger_m: 0.1, wire: 0, node: x_m, arms: [],
    })),
  };
}

const sight = { range: [0, 100] as [number, number], width: 1000 + LEFT + RIGHT, height: 400, exaggeration: 20, middle: 5.9 };

describe("camera", () => {
  it("draws heights larger than lengths by its exaggeration", () => {
    const eye = camera(sight);
    expect(eye.x(100) - eye.x(0)).toBeCloseTo(1000);
    expect(eye.y(5) - eye.y(6)).toBeCloseTo(20 * eye.scale);
    expect(eye.metres(eye.x(37.5))).toBeCloseTo(37.5);
    expect(eye.up(eye.y(5.3))).toBeCloseTo(5.3);
  });
  it("fits with a plain number that fills the height and not more", () => {
    const found = fitted([0, 100], 1.2, sight.width, 400);
    expect(found).toBe(20);
    expect(1.2 * camera(sight).scale * found).toBeLessThanOrEqual(400);
    expect(fitted([0, 50_000], 1.2, 1000, 400)).toBe(5000);
  });
  it("zooms about a place and stays on the line", () => {
    const [start, end] = zoomed([0, 100], 0.5, 25, [-2, 102]);
    expect([start, end]).toEqual([12.5, 62.5]);
    expect(zoomed([0, 100], 10, 50, [-2, 102])).toEqual([-2, 102]);
    expect(kept([-50, 0], [-2, 102])).toEqual([-2, 48]);
  });
  it("goes through the exaggerations that are offered", () => {
    expect([nextExaggeration(20, true), nextExaggeration(20, false), nextExaggeration(5000, true)]).toEqual([50, 10, 5000]);
  });
  it("has plain marks", () => {
    expect(ticks(0, 100, 18)).toEqual([0, 20, 40, 60, 80, 100]);
    expect(ticks(5.25, 5.45, 0.07)).toEqual([5.3, 5.4]);
  });
});

describe("index", () => {
  it("finds a place among numbers that rise", () => {
    expect(below([1, 2, 2, 5], 2)).toBe(1);
    expect(below([1, 2, 2, 5], 6)).toBe(4);
  });
  it("finds nodes and values", () => {
    const found = indexOf(line());
    expect(below(found.dropperX, 20)).toBe(1);
    expect(between(found.wires[0]!, 10.5, 12.2)).toEqual([10, 14]);
    expect(valueAt(found.wires[1]!, "z", 33.3)).toBeCloseTo(6.5);
    expect(valueAt(found.wires[1]!, "z", 101)).toBeNull();
    expect(contactAt(found, 20)).toEqual({ wire: 0, z: 5.3 });
    expect(found.z).toEqual([5.3, 6.5]);
  });
});

describe("twins", () => {
  /** Contact wires over ranges of positions in m. */
  const seconds = (...ranges: [number, number][]) => {
    const wires = ranges.map(([start, end], n) => ({
      name: `contact wire ${n + 1}`, kind: "contact" as const, first: 0, x: [start, end], y: [0.1 * n, 0.1 * n], z: [5.3, 5.3],
    }));
    return indexOf({ ...line(), wires }).wires.map((wire) => wire.isSecond);
  };
  it("run side by side all along; in an overlap one wire ends where the next one goes on", () => {
    expect(seconds([0, 1000], [0, 1000])).toEqual([false, true]);
    expect(seconds([0, 1000], [900, 1900], [1800, 2800])).toEqual([false, false, false]);
    // Two tension lengths of twins.
    expect(seconds([0, 1000], [0, 1000], [900, 1900], [900, 1900])).toEqual([false, true, false, true]);
  });
  it("are told by name, each with its height", () => {
    const geometry = line();
    const [contact] = geometry.wires;
    geometry.wires = [{ ...contact!, name: "contact wire 1" }, { ...contact!, name: "contact wire 2", y: contact!.y.map(() => 0.14) }];
    expect(placeInWords(geometry, indexOf(geometry), 60)).toBe(
      "span 2 · 60.00 m · contact wire 1 5.300 m · lateral 0.100 m · contact wire 2 5.300 m · lateral 0.140 m",
    );
  });
});

describe("level of detail", () => {
  const count = (nodes: number) => {
    let points = 0;
    const context = { beginPath() {}, stroke() {}, lineTo: () => points++ } as unknown as CanvasRenderingContext2D;
    traceWire(context, camera(sight), indexOf(line(nodes)).wires[0]!, "side", null);
    return points;
  };
  it("draws every node where there are few, and no more than two a pixel where there are many", () => {
    expect(count(101)).toBe(101);
    expect(count(350_000)).toBeLessThanOrEqual(2 * sight.width + 4);
  });
  it("draws so many of the pixels that a tension length has in the picture, not of all", () => {
    let points = 0;
    const context = { beginPath() {}, stroke() {}, lineTo: () => points++ } as unknown as CanvasRenderingContext2D;
    // 100 m of the 50 km that are seen: two pixels.
    const far = camera({ ...sight, range: [0, 50_000] });
    traceWire(context, far, indexOf(line(350)).wires[0]!, "side", null);
    expect(points).toBeLessThanOrEqual(8);
    points = 0;
    traceWire(context, camera({ ...sight, range: [200, 300] }), indexOf(line(350)).wires[0]!, "side", null);
    expect(points).toBe(0);
  });
  it("moves what moves, also where it knows the lowest and highest nodes at rest", () => {
    const wire = indexOf(line(350_000)).wires[0]!;
    const eye = camera(sight);
    const highest = (own: { first: number; up: Float32Array } | null) => {
      const drawn: number[] = [];
      const context = { beginPath() {}, stroke() {}, lineTo: (_: number, y: number) => drawn.push(y) };
      traceWire(context as unknown as CanvasRenderingContext2D, eye, wire, "side", own && { ...own, across: null });
      return Math.min(...drawn);
    };
    expect(highest(null)).toBeCloseTo(eye.y(5.3));
    expect(highest({ first: 123_456, up: Float32Array.of(0.25) })).toBeCloseTo(eye.y(5.55));
    expect(highest(null)).toBeCloseTo(eye.y(5.3));
  });
  it("leaves droppers out where they would touch", () => {
    const geometry = line();
    const looked = (width: number) => droppersSeen({ line: indexOf(geometry), camera: camera({ ...sight, width }) });
    expect(looked(sight.width)).toHaveLength(8);
    expect(looked(LEFT + RIGHT + 20)).toHaveLength(0);
  });
});

describe("motion", () => {
  it("moves the nodes that it is of, others rest", () => {
    const own = { first: 10, up: Float32Array.of(0.1, 0.25), across: null };
    expect([9, 10, 11, 12].map((node) => shift(own, node, "side"))).toEqual([0, Math.fround(0.1), 0.25, 0]);
    expect(shift(own, 10, "plan")).toBe(0);
  });
  it("knows slack droppers, and those whose force is not known", () => {
    const dropper = line().droppers[0]!;
    expect(forceOf(dropper, 0, null)).toBe(50);
    expect(forceOf(dropper, 0, { wires: [], dropper_N: Float32Array.of(0) })).toBe(0);
    expect(forceOf(dropper, 0, { wires: [], dropper_N: Float32Array.of(NaN) })).toBeNull();
    expect(forceOf(dropper, 0, { wires: [], dropper_N: null })).toBeNull();
  });
});

describe("picking", () => {
  const geometry = line();
  const eye = camera(sight);
  const at = (x: number, z: number) =>
    pick({ geometry, line: indexOf(geometry), camera: eye, view: "side", now: null }, eye.x(x), eye.y(z));
  it("takes the dropper that is near, then a support, then the span", () => {
    expect(at(30.3, 5.9)).toEqual({ kind: "dropper", index: 2 });
    expect(at(50.2, 5.9)).toEqual({ kind: "support", index: 1 });
    expect(at(55, 5.9)).toEqual({ kind: "span", number: 2 });
    expect(at(30.3, 8)).toEqual({ kind: "span", number: 1 });
    expect(at(120, 5.9)).toBeNull();
  });
});

describe("words", () => {
  const geometry = line();
  it("tell the place, what was picked and the whole", () => {
    expect(placeInWords(geometry, indexOf(geometry), 33.333)).toBe(
      "span 1 · 33.33 m · contact wire 5.300 m · lateral 0.100 m · messenger wire 6.500 m",
    );
    const slack = { kind: "dropper" as const, index: 1 };
    expect(pickedInWords(geometry, slack, null, false)).toBe("span 1 dropper 2 at 20.00 m: 1.200 m between clamps, slack");
    expect(pickedInWords(geometry, slack, null, true)).toBe("span 1 dropper 2 at 20.00 m");
    expect(drawingInWords(geometry, indexOf(geometry))).toContain("8 droppers, 1 of them slack at rest");
  });
});
