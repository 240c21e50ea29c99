import { describe, expect, it } from "vitest";
import { inWords, offers } from "./completion.ts";
import { about, at, fields, type Schema } from "./schema.ts";
import { placeAt } from "./yamlPlace.ts";

const force: Schema = {
  type: "string",
  pattern: "N|kN",
  description: "number and unit: a force (N, kN, daN)",
};
const amount: Schema = { anyOf: [{ type: "number", minimum: 0.001, maximum: 1e9 }, { $ref: "#/$defs/a-force" }] };
const wrapped: Schema = {
  type: "object",
  properties: { value: amount, mark: { enum: ["A", "C*"] }, source: { type: "string" }, note: { type: "string" } },
  required: ["value"],
};
const top: Schema = {
  $defs: {
    "a-force": force,
    Wire: {
      type: "object",
      description: "A wire.",
      required: ["tension"],
      properties: {
        tension: { description: "Tension.", unit: "N", anyOf: [amount, wrapped] },
        ends: { enum: ["fixed", "free"], default: "free", description: "Its ends." },
        twin: { type: "boolean" },
      },
    },
    Scenario: {
      type: "object",
      properties: {
        line: { anyOf: [{ type: "string" }, { $ref: "#/$defs/Line" }] },
        pantographs: { type: "array", items: { type: "object", properties: { model: { type: "string" } } } },
      },
    },
    Line: { type: "object", properties: { contact_wire: { anyOf: [{ $ref: "#/$defs/Wire" }, { type: "null" }] } } },
  },
};
const models = {
  models: [{ path: "lines/own.yaml", kind: "line" as const, name: "own", description: "Mine" }],
  library: [
    { path: "shipped:line/ac", kind: "line" as const, name: "ac", description: "AC" },
    { path: "shipped:pantograph/dsa", kind: "pantograph" as const, name: "dsa", description: "" },
  ],
};

const labels = (marked: string, kind: "Line" | "Scenario" = "Line") => {
  const place = placeAt(marked.replace("|", ""), marked.indexOf("|"));
  const found = offers(place!, top.$defs![kind]!, top, models);
  return { ...found, labels: found.offers.map((one) => one.label) };
};

describe("completion", () => {
  it("offers the fields of a place that are not there yet, required ones first", () => {
    const found = labels("contact_wire:\n  ends: fixed\n  |");
    expect(found.labels).toEqual(["tension", "twin"]);
    expect(found.offers[0]).toMatchObject({ apply: "tension: ", detail: "required, N" });
    expect(found.offers[0]!.rank).toBeGreaterThan(found.offers[1]!.rank);
  });
  it("offers units behind a number, and a space before them", () => {
    const found = labels("contact_wire:\n  tension: 22|");
    expect(found.labels).toEqual(["N", "kN", "daN"]);
    expect(found.offers[1]!.apply).toBe(" kN");
    expect(found.from).toBe("contact_wire:\n  tension: 22".length);
    expect(labels("contact_wire:\n  tension: {value: 22 k|").offers[1]!.apply).toBe("kN");
  });
  it("offers words", () => {
    expect(labels("contact_wire:\n  ends: |").labels).toEqual(["fixed", "free"]);
    expect(labels("contact_wire:\n  twin: t|").labels).toEqual(["true", "false"]);
    expect(labels("contact_wire:\n  tension: {value: 1, mark: |").labels).toEqual(["A", "C*"]);
  });
  it("offers fields of the source of a value behind it", () => {
    expect(labels("contact_wire:\n  tension: {value: 1 N, |").labels).toEqual(["mark", "source", "note"]);
  });
  it("offers shipped names and files of the folder of the kind that is meant", () => {
    expect(labels("line: |", "Scenario").labels).toEqual(["lines/own.yaml", "ac"]);
    expect(labels("pantographs:\n  - model: |", "Scenario").labels).toEqual(["dsa"]);
  });
  it("offers nothing where nothing is known", () => {
    expect(labels("nothing:\n  |").labels).toEqual([]);
  });
});

describe("schema", () => {
  it("tells description, unit, limits and what holds without", () => {
    const place = placeAt("contact_wire:\n  tension: 2", 25)!;
    const words = inWords(place, top.$defs!["Line"]!, top);
    expect(words).toEqual(["Tension.", "Unit: N (or kN, daN).", "Limits: at least 0.001 N, at most 1000000000 N."]);
    const ends = at(["contact_wire", "ends"], top.$defs!["Line"]!, top);
    expect(about(ends, top)).toMatchObject({ words: ["fixed", "free"], default: "free" });
  });
  it("ends where references go in a circle", () => {
    const circle: Schema = { $defs: { A: { anyOf: [{ $ref: "#/$defs/A" }], properties: { a: {} } } } };
    expect([...fields([], { $ref: "#/$defs/A" }, circle).keys()]).toEqual(["a"]);
  });
});
