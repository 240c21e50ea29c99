/** Path of a wire on a canvas, at rest or moved; where pixels are fewer than nodes, its lowest and highest in each. */
import type { Camera } from "./camera.ts";
import { between, type WireArrays } from "./lineIndex.ts";
import type { MovedWire } from "./scene.ts";

export type View = "side" | "plan";

/** Of so many nodes in a pixel each is still drawn. */
const NODES_PER_PIXEL = 2;

/** Lowest and highest values at rest, in m, of so many neighbouring nodes each. */
interface Envelope {
  chunk: number;
  low: Float64Array;
  high: Float64Array;
}

/** Those that were drawn last: a line of 50 km has 300 000 nodes, and most of them rest. */
const envelopes: Record<View, WeakMap<WireArrays, Envelope>> = { side: new WeakMap(), plan: new WeakMap() };

/** Displacement in m of a node, up or across. */
export function shift(own: MovedWire | null | undefined, node: number, view: View): number {
  const values = view === "side" ? own?.up : own?.across;
  return own && values ? (values[node - own.first] ?? 0) : 0;
}

const valuesOf = (wire: WireArrays, view: View) => (view === "side" ? wire.z : wire.y);

function envelopeOf(wire: WireArrays, view: View, chunk: number): Envelope {
  const known = envelopes[view].get(wire);
  if (known?.chunk === chunk) return known;
  const values = valuesOf(wire, view);
  const count = Math.ceil(values.length / chunk);
  const made = { chunk, low: new Float64Array(count).fill(Infinity), high: new Float64Array(count).fill(-Infinity) };
  values.forEach((value, node) => {
    const at = Math.floor(node / chunk);
    if (value < made.low[at]!) made.low[at] = value;
    if (value > made.high[at]!) made.high[at] = value;
  });
  envelopes[view].set(wire, made);
  return made;
}

/** Draw a wire with the style that is set. */
export function traceWire(
  context: CanvasRenderingContext2D,
  camera: Camera,
  wire: WireArrays,
  view: View,
  own: MovedWire | null | undefined,
): void {
  const [first, last] = between(wire, camera.x0, camera.x1);
  if (last - first < 2) return; // not in the picture
  const values = valuesOf(wire, view);
  // Its own pixels: a tension length of a long line has few of those of the picture.
  const pixels = Math.max(1, (wire.x[last - 1]! - wire.x[first]!) * camera.scale);
  const crowd = (last - first) / pixels;
  context.beginPath();
  if (crowd <= NODES_PER_PIXEL) {
    for (let node = first; node < last; node++) {
      context.lineTo(camera.x(wire.x[node]!), camera.y(values[node]! + shift(own, node, view)));
    }
  } else {
    // Begins at a multiple: when the picture is moved, the same nodes stand together.
    const chunk = Math.ceil(crowd);
    const rest = envelopeOf(wire, view, chunk);
    const [moves, end] = own ? [own.first, own.first + own.up.length] : [0, 0];
    for (let start = first - (first % chunk); start < last; start += chunk) {
      let [low, high] = [rest.low[start / chunk]!, rest.high[start / chunk]!];
      if (start < end && start + chunk > moves) {
        [low, high] = [Infinity, -Infinity];
        for (let node = start; node < Math.min(start + chunk, wire.x.length); node++) {
          const value = values[node]! + shift(own, node, view);
          if (value < low) low = value;
          if (value > high) high = value;
        }
      }
      const x = camera.x(wire.x[start]!);
      context.lineTo(x, camera.y(high));
      context.lineTo(x, camera.y(low));
    }
  }
  context.stroke();
}
