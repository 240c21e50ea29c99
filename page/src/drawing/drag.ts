/** A dropper dragged along the line, or the stagger at a support dragged in plan. */
import { typedLike } from "../editor/typedLike.ts";
import { complain } from "../shell/messages.ts";
import { text } from "../editor/documents.ts";
import { patch } from "../editor/patch.ts";
import type { Camera } from "./camera.ts";
import type { Geometry, Handle, Handles } from "./geometry.ts";
import type { View } from "./wirePath.ts";
import type { Picked } from "./pick.ts";
import type { Pencil } from "./scene.ts";

/** Values are rounded to this, in m: droppers are placed by the centimetre. */
const STEP = 0.01;
/** A pointer that moved less than this, in px, drags nothing. */
const LEAST = 4;

export interface Drag {
  moved: boolean;
  told: string;
  to(camera: Camera, x: number, y: number): Drag;
  draw(pencil: Pencil): void;
  drop(): Promise<void>;
}

/** What can be dragged there; null where a field of the text does not stand behind it. */
export function dragOf(
  picked: Picked,
  handles: Handles,
  geometry: Geometry,
  view: View,
  start: number,
): Drag | null {
  if (picked.kind === "dropper" && view === "side") {
    const [handle, dropper] = [handles.droppers[picked.index], geometry.droppers[picked.index]];
    const span = geometry.spans.find((one) => one.number === dropper?.span);
    if (!handle || !dropper || !span) return null;
    const inside: [number, number] = [span.start_m + STEP, span.end_m - STEP];
    return dragging(handle, dropper.name, inside, start, "x", dropper.x_m);
  }
  const [handle, support] =
    picked.kind === "support" ? [handles.supports[picked.index], geometry.supports[picked.index]] : [];
  if (!handle || !support || view !== "plan") return null;
  // Wider than any stagger; what the line refuses, the server says.
  return dragging(handle, support.name, [-1, 1], start, "y", support.x_m);
}

function dragging(
  handle: Handle,
  name: string,
  inside: [number, number],
  start: number,
  axis: "x" | "y",
  place: number,
): Drag {
  const at = (value: number | null): Drag => ({
    moved: value !== null,
    told: value === null ? "" : `${name}: ${(value - handle.from_m).toFixed(2)} m`,
    to(camera, x, y) {
      if (value === null && axis === "x" && Math.abs(x - start) < LEAST) return this;
      const raw = axis === "x" ? camera.metres(x) : camera.up(y);
      const own = Math.round((raw - handle.from_m) / STEP) * STEP + handle.from_m;
      return at(Math.min(Math.max(own, inside[0]), inside[1]));
    },
    draw({ context, camera, colour }) {
      if (value === null) return;
      context.strokeStyle = colour("accent");
      context.lineWidth = 2;
      context.setLineDash([6, 3]);
      context.beginPath();
      if (axis === "x") {
        context.moveTo(camera.x(value), 18);
        context.lineTo(camera.x(value), camera.height - 18);
      } else {
        context.moveTo(camera.x(place) - 30, camera.y(value));
        context.lineTo(camera.x(place) + 30, camera.y(value));
      }
      context.stroke();
      context.setLineDash([]);
    },
    async drop() {
      if (value === null) return;
      const metres = Number((value - handle.from_m).toFixed(4));
      try {
        await patch({ [handle.field]: await typedLike(text.peek(), handle.field, metres) });
      } catch (error) {
        complain(error);
      }
    },
  });
  return at(null);
}
