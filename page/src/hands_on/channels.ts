/**
 * Frames of a session → the motion that is drawn. Channels are pantographs, then wires up, then
 * wires across; the last pantograph completes a moment. m, N, s.
 */
import type { Frame } from "../connection/stream.ts";
import type { MovedWire } from "../drawing/scene.ts";
import type { PantographState } from "../player/motion/state.ts";

/** Values of a pantograph before the displacements of its masses: position, force, height, added force. */
const HEAD = 4;

export interface Sizes {
  pantographs: number;
  wires: number;
}

/** A moment that is put together from its frames. */
export interface Moment {
  time: number;
  wires: (MovedWire | null)[];
  pantographs: PantographState[];
  /** Added to the static force of each, offset and gusts, N. */
  added: number[];
}

function empty({ pantographs, wires }: Sizes): Moment {
  return {
    time: 0,
    wires: Array.from({ length: wires }, () => null),
    pantographs: Array.from({ length: pantographs }, () => ({ position: NaN, force: NaN, height: NaN, uplift: NaN, masses: [] })),
    added: Array.from({ length: pantographs }, () => 0),
  };
}

/** Takes frames one by one and gives each whole moment away. */
export function collector(sizes: Sizes, done: (moment: Moment) => void): (frame: Frame) => void {
  const { pantographs, wires } = sizes;
  let moment = empty(sizes);
  return ({ channel, first, time, values }) => {
    if (channel >= pantographs + wires) {
      const up = moment.wires[channel - pantographs - wires];
      if (up) up.across = values;
    } else if (channel >= pantographs) {
      moment.wires[channel - pantographs] = { first, up: values, across: null };
    } else {
      const [position = NaN, force = NaN, height = NaN, added = 0] = values;
      // Masses come from the base up, and are drawn from the head down.
      const masses = [...values.subarray(HEAD)].reverse();
      moment.pantographs[channel] = { position, force, height, uplift: NaN, masses };
      moment.added[channel] = added;
      if (channel < pantographs - 1) return;
      moment.time = time;
      done(moment);
      moment = empty(sizes);
    }
  };
}
