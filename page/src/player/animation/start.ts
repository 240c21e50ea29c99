/** Gives the motion of a report to the player. */
import { drawPlace } from "../../drawing/placeMark.ts";
import { addLayer } from "../../drawing/scene.ts";
import { clock } from "../../state/selection.ts";
import { worst } from "../../state/worst.ts";
import { history, present, store, viewers } from "../player.ts";
import { followCamera } from "../views/camera.ts";
import { stored, topOf } from "../views/columns.ts";
import { drawPlan, drawSide } from "../views/pantographs.ts";
import { drawVelocity } from "../views/velocity.ts";
import { columnOf, timesOf, unpack, type Packed } from "./unpack.ts";

/** Of real time: at full speed a span passes in half a second. */
const SLOW = 0.25;

export function start(packed: Packed): void {
  unpack(packed, store, history);
  const times = timesOf(packed);
  const { geometry, pantographs, row_s } = packed;
  present({ geometry, pantographs, row_s, wires: true, search: null }, times[0]!, times.at(-1)!, false);
  clock.time_s.value = packed.begin_s;
  clock.rate.value = SLOW;
  worst.value = packed.worst.map((position_m) => ({ position_m, force_N: null }));
  const raw = packed.force.raw.map(columnOf);
  stored.value = { raw, filtered: packed.force.filtered.map(columnOf), top: topOf(raw) };
  addLayer({ id: "velocity", order: 0, view: "side", draw: drawVelocity });
  addLayer({ id: "pantographs", order: 1, view: "side", draw: drawSide });
  addLayer({ id: "place", order: 3, view: "side", draw: drawPlace });
  addLayer({ id: "pantographs in plan", order: 1, view: "plan", draw: drawPlan });
  viewers.add(followCamera);
}
