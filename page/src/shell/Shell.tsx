/** The window: six slots, and in each what the rooms of the page put there. */
import { useSignal } from "@preact/signals";
import type { ComponentType } from "preact";
import { useEffect } from "preact/hooks";
import { connection } from "../connection/stream.ts";
import { dismiss, messages } from "./messages.ts";
import { panels, show, shown, type Panel, type Slot } from "./panels.ts";

function Loaded({ panel }: { panel: Panel }) {
  const found = useSignal<ComponentType | null>(null);
  useEffect(() => {
    let wanted = true;
    void panel.load().then((component) => wanted && (found.value = component));
    return () => void (wanted = false);
  }, [panel.id]);
  const Component = found.value;
  return Component ? <Component /> : null;
}

const offered = (slot: Slot) =>
  panels.value.filter((panel) => panel.slot === slot && (panel.when?.value ?? true));

function Tabs({ slot, label }: { slot: Slot; label: string }) {
  const all = offered(slot);
  const current = all.find((panel) => panel.id === shown.value[slot]) ?? all[0];
  if (!current) return null;
  return (
    <section class={`slot ${slot}`} aria-label={label}>
      <div role="tablist" aria-label={label}>
        {all.map((panel) => (
          <button
            key={panel.id}
            role="tab"
            id={`tab-${panel.id}`}
            aria-selected={panel === current}
            aria-controls={`panel-${slot}`}
            onClick={() => show(panel.id)}
          >
            {panel.title}
          </button>
        ))}
      </div>
      <div role="tabpanel" id={`panel-${slot}`} aria-labelledby={`tab-${current.id}`} tabIndex={0}>
        <Loaded key={current.id} panel={current} />
      </div>
    </section>
  );
}

function All({ slot }: { slot: Slot }) {
  return (
    <>
      {offered(slot).map((panel) => (
        <Loaded key={panel.id} panel={panel} />
      ))}
    </>
  );
}

function Messages() {
  return (
    <ul class="messages" role="status" aria-label="Messages">
      {messages.value.map(({ id, level, text }) => (
        <li key={id} class={level}>
          {text}
          <button aria-label="Dismiss" onClick={() => dismiss(id)}>
            ×
          </button>
        </li>
      ))}
    </ul>
  );
}

export function Shell() {
  return (
    <>
      {connection.value === "lost" && (
        <p class="lost" role="alert">
          The server does not answer. Nothing that you typed is lost; trying again.
        </p>
      )}
      <header class="slot top">
        <All slot="top" />
      </header>
      <nav class="slot left" aria-label="Project">
        <All slot="left" />
      </nav>
      <main>
        <Tabs slot="main" label="Views" />
        <div class="slot below">
          <All slot="below" />
        </div>
      </main>
      <Tabs slot="right" label="Inspector" />
      <footer class="slot bottom">
        <All slot="bottom" />
      </footer>
      <Messages />
    </>
  );
}
