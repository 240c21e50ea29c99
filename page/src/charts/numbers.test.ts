import { describe, expect, it } from "vitest";
import { decimals, formed, stepped } from "./numbers.ts";

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
