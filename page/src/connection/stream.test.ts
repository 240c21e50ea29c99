// @vitest-environment happy-dom
import { afterEach, beforeEach, expect, it, vi } from "vitest";
import { connect, connection, hear, whenOpen } from "./stream.ts";

class Fake {
  static readonly OPEN = 1;
  static all: Fake[] = [];
  readonly readyState = 1;
  binaryType = "";
  onopen?: () => void;
  onclose?: () => void;
  onmessage?: (event: { data: string }) => void;
  constructor() {
    Fake.all.push(this);
  }
  say(topic: string): void {
    this.onmessage?.({ data: JSON.stringify({ topic }) });
  }
}

beforeEach(() => {
  vi.useFakeTimers();
  vi.stubGlobal("WebSocket", Fake);
});
afterEach(() => void vi.useRealTimers());

it("says that a silent server does not answer, and goes on when it does", () => {
  const asked = vi.fn();
  whenOpen(asked);
  connect();
  Fake.all[0]!.onopen!();
  expect(asked).toHaveBeenCalledTimes(1);
  for (let second = 0; second < 20; second += 2) {
    vi.advanceTimersByTime(2000);
    Fake.all[0]!.say("beat");
  }
  expect(connection.value).toBe("open");
  vi.advanceTimersByTime(4500);
  expect(connection.value).toBe("open");
  vi.advanceTimersByTime(2500);
  expect(connection.value).toBe("lost");
  const heard = vi.fn();
  hear("job", heard);
  Fake.all[0]!.say("job");
  expect(connection.value).toBe("open");
  // What was asked for is asked again, and what came is not lost.
  expect(asked).toHaveBeenCalledTimes(2);
  expect(heard).toHaveBeenCalledTimes(1);
  expect(Fake.all).toHaveLength(1);
});
