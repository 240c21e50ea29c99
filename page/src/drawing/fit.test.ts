// @vitest-environment happy-dom
import { beforeEach, expect, it } from "vitest";
import { exaggeration, range } from "../state/selection.ts";
import "./fit.ts";
import type { Geometry } from "./geometry.ts";
import { edited, played, showing } from "./scene.ts";

const line = (name: string, end: number): Geometry => ({
  name, spatial: false, height_m: 5.3, spans: [], droppers: [], supports: [],
  wires: [{ name: "contact wire", kind: "contact", first: 0, x: [0, end], y: [0, 0], z: [5.3, 5.3] }],
});
const drawn = () => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
const look = () => {
  [range.value, exaggeration.value] = [[100, 200], 50];
};

beforeEach(async () => {
  [edited.value, played.value, showing.value] = [null, null, "edited"];
  edited.value = line("first", 1000);
  await drawn();
  look();
});

it("shows all of another line, and a changed one where it was looked at", async () => {
  edited.value = line("first", 1050);
  await drawn();
  expect(range.value).toEqual([100, 200]);
  edited.value = line("second", 2000);
  await drawn();
  expect(range.value).toBe(null);
});

it("keeps the view when a line is edited that is as long as the one of the run", async () => {
  [played.value, showing.value] = [line("of the run", 1200), "played"];
  await drawn();
  look();
  showing.value = "edited";
  edited.value = line("edited", 1200.0001);
  await drawn();
  expect([range.value, exaggeration.value]).toEqual([[100, 200], 50]);
});

it("keeps the view while one run gives way to another one", async () => {
  [played.value, showing.value] = [line("of a run", 3000), "played"];
  look();
  played.value = null;
  await drawn();
  played.value = line("of another run", 2000);
  await drawn();
  expect(range.value).toEqual([100, 200]);
});
