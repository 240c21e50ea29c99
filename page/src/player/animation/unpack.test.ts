import { expect, test } from "vitest";
import { History } from "../motion/history.ts";
import { Store } from "../motion/store.ts";
import { columnOf, scaled, timesOf, unpack, type Packed } from "./unpack.ts";

const text = (values: ArrayBufferView) =>
  btoa(String.fromCharCode(...new Uint8Array(values.buffer, values.byteOffset, values.byteLength)));

const packed: Packed = {
  geometry: { name: "", spatial: false, height_m: 5, spans: [], wires: [], droppers: [], supports: [] },
  pantographs: [{ name: "P1", masses: [] }],
  times: text(Float64Array.of(1, 1.02)),
  row_s: 0.02,
  begin_s: 1,
  blocks: [
    {
      name: "wire.0.up", step: 1e-3, first: text(Uint32Array.of(4, 5)), count: text(Uint32Array.of(2, 1)),
      values: text(Int16Array.of(10, -20, 30)),
    },
    {
      name: "supports", step: 0.01, first: text(Uint32Array.of(0, 0)), count: text(Uint32Array.of(2, 2)),
      values: text(Int16Array.of(1, -32768, 3, 2)),
    },
    {
      name: "pantograph.0", step: null, first: text(Uint32Array.of(0, 0)), count: text(Uint32Array.of(2, 2)),
      values: text(Float32Array.of(50_000.5, 100, 50_001.5, 101)),
    },
  ],
  force: { raw: [null], filtered: [] },
  worst: [],
};

test("rows of a report become frames of the store", () => {
  const [store, history] = [new Store(), new History()];
  unpack(packed, store, history);
  expect([...timesOf(packed)]).toEqual([1, 1.02]);
  const { times, entries } = store.track("wire.0.up");
  expect(times).toEqual([1, 1.02]);
  expect(entries.map(([piece]) => [piece!.first, ...piece!.values].map((one) => Math.round(1e6 * one) / 1e6))).toEqual([
    [4, 0.01, -0.02],
    [5, 0.03],
  ]);
  expect(store.track("pantograph.0").entries[1]![0]!.values[0]).toBe(50_001.5);
  expect([...history.uplift].map((one) => Math.round(100 * one))).toEqual([3, 2]);
});

test("what is not known is not zero", () => {
  expect([...scaled(Int16Array.of(-32768, 0), 1)]).toEqual([NaN, 0]);
  expect(columnOf(null)).toBe(null);
});
