/** A slot that shows one of its panels; arrow keys go from tab to tab. */
import { Loaded, offered } from "./Loaded.tsx";
import { show, standing, type Slot } from "./panels.ts";

export function Tabs({ slot, label }: { slot: Slot; label: string }) {
  const all = offered(slot);
  const current = standing(slot);
  if (!current) return null;
  const press = (event: KeyboardEvent) => {
    const by = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
    if (by === undefined) return;
    event.preventDefault();
    const next = all[(all.indexOf(current) + by + all.length) % all.length]!;
    show(next.id);
    document.getElementById(`tab-${next.id}`)?.focus();
  };
  return (
    <section class={`slot ${slot}`} aria-label={label}>
      <div role="tablist" aria-label={label} onKeyDown={press}>
        {all.map((panel) => (
          <button
            key={panel.id}
            role="tab"
            id={`tab-${panel.id}`}
            aria-selected={panel === current}
            aria-controls={`panel-${slot}`}
            tabIndex={panel === current ? 0 : -1}
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
