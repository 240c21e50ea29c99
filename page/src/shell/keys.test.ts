// @vitest-environment happy-dom
import { signal } from "@preact/signals";
import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import { commandOf, followKeys, nameOf, typedEarly, written } from "./keys.ts";
import { addCommand, commands } from "./panels.ts";

const key = (key: string, more: Partial<KeyboardEvent> = {}) =>
  ({ key, ctrlKey: false, metaKey: false, altKey: false, shiftKey: false, ...more }) as KeyboardEvent;

describe("names of keys", () => {
  it("knows letters, signs and arrows", () => {
    expect(nameOf(key("f"))).toBe("F");
    expect(nameOf(key("F", { shiftKey: true }))).toBe("Shift+F");
    expect(nameOf(key("?", { shiftKey: true }))).toBe("?");
    expect(nameOf(key(" "))).toBe("Space");
    expect(nameOf(key("ArrowRight", { shiftKey: true }))).toBe("Shift+ArrowRight");
    expect(nameOf(key("Enter", { metaKey: true }))).toBe("Ctrl+Enter");
    expect(written("Shift+ArrowRight")).toEqual(["Shift", "→"]);
  });
});

describe("commands of keys", () => {
  let end = () => {};
  beforeEach(() => (commands.value = []));
  afterEach(() => end());

  it("takes the last one that is offered", () => {
    const offered = signal(false);
    addCommand({ id: "a", title: "A", keys: ["F"], act: () => undefined });
    addCommand({ id: "b", title: "B", keys: ["F"], act: () => undefined, when: offered });
    expect(commandOf("F")?.id).toBe("a");
    offered.value = true;
    expect(commandOf("F")?.id).toBe("b");
    expect(commandOf("G")).toBeUndefined();
  });

  it("leaves a letter to the field where it is typed", () => {
    const act = vi.fn();
    addCommand({ id: "a", title: "A", keys: ["F", "Ctrl+Enter"], act });
    end = followKeys();
    document.body.innerHTML = "<input><button>b</button>";
    const press = (at: Element, name: string, ctrlKey = false) =>
      at.dispatchEvent(new KeyboardEvent("keydown", { key: name, ctrlKey, bubbles: true, cancelable: true }));
    press(document.querySelector("input")!, "f");
    expect(act).toHaveBeenCalledTimes(0);
    press(document.querySelector("input")!, "Enter", true);
    press(document.querySelector("button")!, "f");
    expect(act).toHaveBeenCalledTimes(2);
  });

  it("leaves Space to a button that was reached by keys, and takes it after a click", () => {
    const act = vi.fn();
    addCommand({ id: "a", title: "A", keys: ["Space"], act });
    end = followKeys();
    document.body.innerHTML = "<button>b</button>";
    const button = document.querySelector("button")!;
    const press = () => button.dispatchEvent(new KeyboardEvent("keydown", { key: " ", bubbles: true, cancelable: true }));
    button.focus();
    press();
    expect(act).toHaveBeenCalledTimes(0);
    button.dispatchEvent(new PointerEvent("pointerdown", { bubbles: true }));
    press();
    expect(act).toHaveBeenCalledTimes(1);
  });

  it("keeps letters for a dialog that has not come yet", () => {
    const act = vi.fn();
    let isOver = false;
    addCommand({ id: "a", title: "A", keys: ["E"], act });
    addCommand({ id: "b", title: "B", keys: ["Ctrl+K"], act: () => (isOver = true) });
    end = followKeys(() => isOver);
    document.body.innerHTML = "<p></p>";
    const press = (key: string, ctrlKey = false) =>
      document.body.dispatchEvent(new KeyboardEvent("keydown", { key, ctrlKey, bubbles: true, cancelable: true }));
    press("k", true);
    for (const letter of "exe") press(letter);
    expect(typedEarly()).toBe("exe");
    expect(act).not.toHaveBeenCalled();
    expect(typedEarly()).toBe("");
  });
});
