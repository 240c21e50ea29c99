import { beforeEach, describe, expect, it } from "vitest";
import { addPanel, shown } from "../shell/panels.ts";
import { clock, source } from "../state/selection.ts";
import { inWords, wentTo, worst } from "../state/worst.ts";
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
  it("set the player a second before, and are marked with number and force", () => {
    goTo("runs/a", place(300, 4.5));
    expect(source.value).toEqual({ run: "runs/a" });
    expect(clock.time_s.value).toBe(3.5);
    expect(inWords(wentTo.value!)).toBe("1 N");
    worst.value = [100, 300].map((position_m) => ({ position_m, force_N: 1 }));
    expect(inWords(wentTo.value!)).toBe("2 of 2: 1 N");
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
