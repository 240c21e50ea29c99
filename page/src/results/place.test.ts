import { beforeEach, describe, expect, it } from "vitest";
import { addPanel, shown } from "../shell/panels.ts";
import { clock, cursor, source } from "../state/selection.ts";
import type { Place } from "./told.ts";
import { goTo } from "./place.ts";

const place = (position_m: number, time_s: number): Place => ({
  position_m, time_s, span: 1, force_N: 1, deviation_N: 1, where: "at dropper 1", as_built: null,
});

beforeEach(() => {
  source.value = null;
  clock.start_s.value = 0;
});

describe("worst places", () => {
  it("set player and cursor, a second before", () => {
    goTo("runs/a", place(300, 4.5));
    expect(source.value).toEqual({ run: "runs/a" });
    expect(clock.time_s.value).toBe(3.5);
    expect(cursor.value).toBe(300);
  });
  it("show the line, where they are seen", () => {
    addPanel({ id: "drawing", slot: "main", title: "Line", order: 0, load: async () => () => null });
    goTo("runs/a", place(300, 4.5));
    expect(shown.value.main).toBe("drawing");
  });
  it("never set the clock before its start", () => {
    goTo("runs/a", place(300, 0.4));
    expect(clock.time_s.value).toBe(0);
  });
});
