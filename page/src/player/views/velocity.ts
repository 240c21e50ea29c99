/**
 * Wires coloured by their vertical velocity over the drawing of the side view: mean velocity
 * between the two kept moments, m/s; the colours of the ends of the scale are ± `SCALE`.
 */
import { signal } from "@preact/signals";
import { orders } from "../../../../python/arcless/figures/description/tokens.json";
import { between } from "../../drawing/lineIndex.ts";
import type { Pencil } from "../../drawing/scene.ts";
import { state } from "../player.ts";

/** Whether it is drawn. */
export const byVelocity = signal(false);
/** Velocity of the last colours in m/s: larger ones have the same. */
export const SCALE = 0.6;

const COLOURS = orders.diverging;
const MIDDLE = (COLOURS.length - 1) / 2;

/** The number of a velocity's colour. */
export function shade(velocity: number, scale = SCALE): number {
  const share = Math.min(Math.max(velocity / scale, -1), 1);
  return Math.round(MIDDLE + MIDDLE * share);
}

export function drawVelocity(pencil: Pencil): void {
  if (!byVelocity.value) return;
  const { context, camera, line, colour } = pencil;
  const paths = COLOURS.map(() => new Path2D());
  state.current.wires.forEach((wire, number) => {
    const own = line.wires[number];
    if (!own) return;
    const [from, to] = between(own, camera.x0, camera.x1);
    for (const [first, end] of wire.moving) {
      let last = -1;
      for (let node = Math.max(first, from); node < Math.min(end, to) - 1; node++) {
        const colour = shade(wire.velocity[node]!);
        const path = paths[colour]!;
        if (colour === MIDDLE) {
          last = colour; // the wire's own colour says that it stands
          continue;
        }
        if (colour !== last) path.moveTo(camera.x(own.x[node]!), camera.y(own.z[node]! + wire.up[node]!));
        path.lineTo(camera.x(own.x[node + 1]!), camera.y(own.z[node + 1]! + wire.up[node + 1]!));
        last = colour;
      }
    }
  });
  context.save();
  context.beginPath();
  context.rect(50, 0, camera.width - 50, camera.height);
  context.clip();
  context.lineWidth = 4;
  paths.forEach((path, number) => {
    context.strokeStyle = COLOURS[number]!;
    context.stroke(path);
  });
  context.restore();
  legend(context, camera.width, colour);
}

function legend(context: CanvasRenderingContext2D, width: number, colour: (name: string) => string): void {
  const size = 14;
  const left = width - 12 - size * COLOURS.length - 60;
  COLOURS.forEach((one, number) => {
    context.fillStyle = one;
    context.fillRect(left + number * size, 24, size, 6);
  });
  context.fillStyle = colour("soft");
  context.font = `12px ${colour("font-text")}`;
  context.textBaseline = "middle";
  context.textAlign = "right";
  context.fillText(`−${SCALE}`, left - 4, 27);
  context.textAlign = "left";
  context.fillText(`${SCALE} m/s`, left + COLOURS.length * size + 4, 27);
}
