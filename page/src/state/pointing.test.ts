import { afterEach, expect, test } from "vitest";
import { followPointing, leave, point, pointed } from "./pointing.ts";
import { clock, cursor, file, source } from "./selection.ts";

followPointing();

afterEach(() => {
  leave();
  clock.playing.value = false;
});

test("a cursor that was left is not told, and stays for others", () => {
  point(354.65);
  expect(pointed.value).toBe(354.65);
  leave();
  expect([pointed.value, cursor.value]).toEqual([null, 354.65]);
});

test("it is of no other run, and of no other file", () => {
  for (const other of [() => (source.value = { run: "runs/b" }), () => (file.value = "b.yaml")]) {
    point(10);
    other();
    expect(pointed.value).toBe(null);
  }
});

test("while a run is played, the pointer tells a position, and a key that was pressed before does not", () => {
  point(10);
  clock.playing.value = true;
  expect(pointed.value).toBe(10);
  clock.playing.value = false;
  point(10, "keys");
  clock.playing.value = true;
  expect(pointed.value).toBe(null);
});
