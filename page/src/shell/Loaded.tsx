/** What a slot offers, and a panel whose code is loaded when it is first shown. */
import { useSignal } from "@preact/signals";
import type { ComponentType } from "preact";
import { useEffect } from "preact/hooks";
import { complain } from "./messages.ts";
import { panels, type Panel, type Slot } from "./panels.ts";

export function Loaded({ panel }: { panel: Panel }) {
  const found = useSignal<ComponentType | null>(null);
  useEffect(() => {
    let wanted = true;
    panel.load().then((component) => void (wanted && (found.value = component)), complain);
    return () => void (wanted = false);
  }, [panel.id]);
  const Component = found.value;
  return Component ? <Component /> : null;
}

export const offered = (slot: Slot) =>
  panels.value.filter((panel) => panel.slot === slot && (panel.when?.value ?? true));
