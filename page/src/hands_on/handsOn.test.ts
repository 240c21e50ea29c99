import { expect, test } from "vitest";
import { collector, type Moment } from "./channels.ts";
import { SHOWN, Trace } from "./trace.ts";

const frame = (channel: number, values: number[], first = 0, time = 1) => ({ channel, first, time, values: Float32Array.from(values) });

test("a moment is whole with its last pantograph, and the next one begins empty", () => {
  const found: Moment[] = [];
  const take = collector({ pantographs: 2, wires: 2 }, (moment) => found.push(moment));
  take(frame(2, [0.5, 0.25], 7));
  take(frame(4, [-0.5, -0.25], 7));
  take(frame(0, [100, 120, 5.5, 20, 0.125, 0.25]));
  expect(found).toHaveLength(0);
  take(frame(1, [50, 0, 5.25, 20, 0.5, 0.75]));
  take(frame(0, [101, 121, 5.5, 0]));
  take(frame(1, [51, 1, 5.5, 0], 0, 2));
  expect(found.map(({ time }) => time)).toEqual([1, 2]);
  const [first, second] = found;
  expect(first!.wires[0]).toEqual({ first: 7, up: Float32Array.of(0.5, 0.25), across: Float32Array.of(-0.5, -0.25) });
  expect(first!.wires[1]).toBeNull();
  // From the head down: the last displacement is that of the head.
  expect(first!.pantographs[0]).toMatchObject({ position: 100, force: 120, height: 5.5, masses: [0.25, 0.125] });
  expect(first!.added).toEqual([20, 20]);
  expect(second!.wires).toEqual([null, null]);
});

test("a trace forgets what is older than the strip", () => {
  const trace = new Trace();
  trace.add(0, [900]);
  trace.add(SHOWN / 2, [100]);
  expect(trace.highest()).toBe(900);
  trace.add(SHOWN + 1, [200]);
  expect(trace.times).toEqual([SHOWN / 2, SHOWN + 1]);
  expect(trace.highest()).toBe(200);
  trace.add(SHOWN + 2, [NaN, 150]); // beside the wire
  expect(trace.highest()).toBe(200);
  trace.clear();
  expect(trace.highest()).toBe(0);
});
