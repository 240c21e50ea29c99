import { afterEach, describe, expect, it, vi } from "vitest";
import { messages } from "../shell/messages.ts";
import { source, ticked } from "../state/selection.ts";
import { isMeasured, take } from "./measured.ts";

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
  it("are refused in words where they are none", async () => {
    await take([new File(["x"], "t.png")]);
    expect(messages.value[0]!.text).toMatch(/^t\.png is no measurement/);
    vi.stubGlobal("fetch", async () => Response.json({ error: { text: "too large" } }, { status: 413 }));
    await take([new File(["x"], "t.csv")]);
    expect(messages.value[1]!.text).toBe("too large");
    expect(ticked.value).toEqual([]);
  });
});
