import { describe, expect, it } from "vitest";
import { diff, joined, stretch } from "./diff.ts";

const lines = (...all: string[]) => all.join("\n");

describe("diff", () => {
  it("keeps what both have", () => {
    const pieces = diff(lines("a", "b", "c", "d"), lines("a", "x", "c", "d", "e"));
    expect(pieces).toEqual([
      { same: true, mine: ["a"], theirs: ["a"] },
      { same: false, mine: ["b"], theirs: ["x"] },
      { same: true, mine: ["c", "d"], theirs: ["c", "d"] },
      { same: false, mine: [], theirs: ["e"] },
    ]);
  });
  it("gives either text back, whatever they are", () => {
    const letters = (seed: number) => Array.from({ length: 40 }, (_, n) => "abc"[(seed * (n + 3) * 7919) % 3]);
    for (let seed = 1; seed < 30; seed++) {
      const [one, other] = [lines(...letters(seed) as string[]), lines(...letters(seed * 31 + 1) as string[])];
      const pieces = diff(one, other);
      const all = (side: "mine" | "theirs") => joined(pieces, pieces.map(() => side));
      expect(all("mine")).toBe(one);
      expect(all("theirs")).toBe(other);
    }
  });
  it("joins chosen sides", () => {
    const pieces = diff(lines("a", "b", "c"), lines("x", "b", "y"));
    expect(joined(pieces, ["theirs", "mine"])).toBe(lines("x", "b", "c"));
    expect(joined(pieces, ["both", "theirs"])).toBe(lines("a", "x", "b", "y"));
  });
  it("takes texts that are too different as a whole", () => {
    const [one, other] = [1, 2].map((seed) => Array.from({ length: 5000 }, (_, n) => `${seed} ${n}`).join("\n"));
    const pieces = diff(one!, other!);
    expect(pieces).toHaveLength(1);
    expect(joined(pieces, ["theirs"])).toBe(other);
  });
});

describe("stretch", () => {
  it("is the smallest change", () => {
    expect(stretch("abcd", "abXd")).toEqual({ from: 2, to: 3, insert: "X" });
    expect(stretch("aa", "aaa")).toEqual({ from: 2, to: 2, insert: "a" });
    expect(stretch("same", "same")).toBeNull();
  });
});
