import { describe, expect, it } from "vitest";
import { placeAt } from "./yamlPlace.ts";

/** The place at the mark `|` of a text. */
const at = (marked: string) => placeAt(marked.replace("|", ""), marked.indexOf("|"));

describe("place in a YAML text", () => {
  it("is a field at the left", () => {
    expect(at("format: x\nna|")).toMatchObject({ path: [], typing: "field", word: "na", siblings: ["format"] });
  });
  it("is a field of the mapping above", () => {
    const place = at("contact_wire:\n  mass: 1\n  ten|\n  ends: fixed\nspans: []\n");
    expect(place).toMatchObject({ path: ["contact_wire"], typing: "field", word: "ten" });
    expect(place?.siblings.sort()).toEqual(["ends", "mass"]);
  });
  it("is a field in an empty row by its indent", () => {
    expect(at("a:\n  b:\n    c: 1\n  |")).toMatchObject({ path: ["a"], typing: "field", word: "" });
    expect(at("a:\n  b:\n    c: 1\n    |")).toMatchObject({ path: ["a", "b"], typing: "field" });
  });
  it("is the value of a field", () => {
    expect(at("contact_wire:\n  tension: 22 k|")).toMatchObject({
      path: ["contact_wire", "tension"],
      typing: "value",
      word: "22 k",
    });
  });
  it("counts items of lists", () => {
    expect(at("pantographs:\n  - model: a\n  - model: b|")).toMatchObject({ path: ["pantographs", 1, "model"] });
    expect(at("pantographs:\n- model: a\n- model: b\n  he|")).toMatchObject({ path: ["pantographs", 1], typing: "field" });
    expect(at("x:\n  - - 1\n    - 2\ny: |")).toMatchObject({ path: ["y"] });
  });
  it("is inside of brackets, over rows too", () => {
    expect(at("ice: {mass: 1 kg/m, th|")).toMatchObject({ path: ["ice"], typing: "field", word: "th", siblings: ["mass"] });
    expect(at("a:\n  b: {value: [1 m, 2 |")).toMatchObject({ path: ["a", "b", "value", 1], typing: "value", word: "2 " });
    expect(at("spans: [{type: a, count: 2},\n  {ty|")).toMatchObject({ path: ["spans", 1], typing: "field" });
    expect(at("a: {b: {c: 1}, d: |")).toMatchObject({ path: ["a", "d"], typing: "value" });
  });
  it("is nowhere in comments and quotes", () => {
    expect(at("a: 1 # comm|")?.typing ?? null).not.toBe("field");
    expect(at("# comm|")).toBeNull();
    expect(at('a: {note: "one, tw|')).toBeNull();
  });
  it("is below a row with brackets that are closed", () => {
    expect(at("a: {b: 1}\nc|")).toMatchObject({ path: [], typing: "field", word: "c" });
  });
});
