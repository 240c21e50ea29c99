/** What a slot offers, and a panel whose code is loaded when it is first shown. */
import { useSignal } from "@preact/signals";
import type { ComponentType } from "preact";
import { useEffect } from "preact/hooks";
import { whenOpen } from "../connection/stream.ts";
import { complain } from "./messages.ts";
import { panels, type Panel, type Slot } from "./panels.ts";

export function Loaded({ panel }: { panel: Panel }) {
  const found = useSignal<ComponentType | null>(null);
  useEffect(() => {
    let [wanted, failed] = [true, false];
    const load = () => {
      failed = false;
      panel.load().then(
        (component) => void (wanted && (found.value = component)),
        (error: unknown) => {
          failed = true;
          if (wanted) complain(error);
        },
      );
    };
    load();
    // What a server that is gone did not send is asked for again when there is one.
    const end = whenOpen(() => failed && load());
    return () => {
      wanted = false;
      end();
    };
  }, [panel.id]);
  const Component = found.value;
  return Component ? <Component /> : null;
}

export const offered = (slot: Slot) =>
  panels.value.filter((panel) => panel.slot === slot && (panel.when?.value ?? true));
