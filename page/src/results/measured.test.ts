import { afterEach, describe, expect, it, vi } from "vitest";
import { messages } from "../shell/messages.ts";
import { source, ticked } from "../state/selection.ts";
import { isMeasured, openMeasured, take } from "./measured.ts";
import { chosenMeasured, give, givenAmong } from "./measuredAs.ts";
import { baseline } from "./which.ts";

afterEach(() => {
  vi.unstubAllGlobals();
  messages.value = [];
  ticked.value = [];
  source.value = null;
});

describe("measured files", () => {
  it("are known by their endings", () => {
    expect(isMeasured("Line Test.CSV")).toBe(true);
    expect(isMeasured("result.nc")).toBe(false);
  });
  it("are kept in the folder, and ticked behind the run that is shown", async () => {
    const asked = vi.fn(async (_address: string) => Response.json({ path: "measured/t.csv" }));
    vi.stubGlobal("fetch", asked);
    source.value = { run: "runs/a" };
    await take([new File(["x"], "t.csv")]);
    expect(asked.mock.calls[0]![0]).toBe("api/measured?name=t.csv");
    expect(ticked.value).toEqual(["runs/a", "measured/t.csv"]);
    await take([new File(["x"], "t.csv")]);
    expect(ticked.value).toEqual(["runs/a", "measured/t.csv"]);
  });
  it("are compared with the run that is shown, and with nothing else that was ticked", async () => {
    vi.stubGlobal("fetch", async () => Response.json({ path: "measured/t.csv" }));
    ticked.value = ["runs/c", "measured/old.csv", "runs/b"];
    source.value = { run: "runs/a" };
    await take([new File(["x"], "t.csv")]);
    expect(ticked.value).toEqual(["runs/a", "measured/t.csv"]);
    expect(baseline.value).toBe("runs/a");
  });
  it("show their form where they are clicked, without unticking what they are compared with", () => {
    ticked.value = ["runs/c", "measured/t.csv"];
    openMeasured("measured/t.csv");
    expect(ticked.value).toEqual(["runs/c", "measured/t.csv"]);
    expect(chosenMeasured.value).toBe("measured/t.csv");
    source.value = { run: "runs/a" };
    openMeasured("measured/other.csv");
    expect(ticked.value).toEqual(["runs/a", "measured/other.csv"]);
  });
  it("have the unit beside the field where a bare number is given", () => {
    give("measured/t.csv", { speed: "250", supply: "AC 25 kV", head_mass: "5.2", head_lift: "0.002 N/(m/s)2" });
    expect(givenAmong(["measured/t.csv", "runs/a"])).toEqual({
      "measured/t.csv": { speed: "250 km/h", supply: "AC 25 kV", head_mass: "5.2 kg", head_lift: "0.002 N/(m/s)2" },
    });
  });
  it("are refused in words where they are none", async () => {
    await take([new File(["x"], "t.png")]);
    expect(messages.value[0]!.text).toMatch(/^t\.png is no measurement/);
    vi.stubGlobal("fetch", async () => Response.json({ error: { text: "too large" } }, { status: 413 }));
    await take([new File(["x"], "t.csv")]);
    expect(messages.value[1]!.text).toBe("too large");
    expect(ticked.value).toEqual([]);
  });
});
