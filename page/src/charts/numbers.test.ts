import { describe, expect, it } from "vitest";
import { decimals, formed, logarithmicTicks, powered, stepped } from "./numbers.ts";

describe("numbers", () => {
  it("have a real minus, and none at zero", () => {
    expect(decimals(-1.25, 1)).toBe("−1.3");
    expect(decimals(-0.04, 1)).toBe("0.0");
  });
  it("have the decimals of a form", () => {
    expect(formed(3.14159, "0.00")).toBe("3.14");
    expect(formed(3.6, "0")).toBe("4");
    expect(formed(0.00123, "0.00e+0")).toBe("1.23e−3");
    expect(formed(NaN, "0.0")).toBe("–");
  });
  it("tell steps apart, and no more", () => {
    expect(stepped(12.5, 0.5)).toBe("12.5");
    expect(stepped(1200, 200)).toBe("1200");
    expect(stepped(0.05, 0.01)).toBe("0.05");
  });
});

describe("logarithmic axes", () => {
  it("have ticks at powers, with 2 and 5 between where these are few", () => {
    expect(logarithmicTicks(0.37, 25)).toEqual([0.5, 1, 2, 5, 10, 20]);
    expect(logarithmicTicks(0.0009, 12000)).toEqual([0.001, 0.01, 0.1, 1, 10, 100, 1000, 10000]);
  });
  it("write large numbers as powers, so that they do not reach the title", () => {
    const beside = [0.001, 1, 10000];
    expect(beside.map((one) => powered(one, beside))).toEqual(["10⁻³", "10⁰", "10⁴"]);
    expect(powered(20, [0.5, 20])).toBe("20");
  });
});
