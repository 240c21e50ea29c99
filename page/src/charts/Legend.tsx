/** The legend of a chart: an entry for each name, the layer on top first; a press hides and shows. */
import type { Signal } from "@preact/signals";
import type { Layer } from "./figure.ts";
import { scheme, colour } from "./colours.ts";

export interface Entry {
  name: string;
  colour: string;
  alpha: number;
  sign: string;
}

/** The sign of a layer in the legend. */
function sign(layer: Layer): string {
  if (layer.kind === "curve" || layer.kind === "rules") return layer.dash === "solid" ? "line" : layer.dash;
  if (layer.kind === "segments") return "line";
  if (layer.kind === "points") return { down: "triangle", cross: "dot", circle: "dot" }[layer.shape as string] ?? layer.shape;
  return "area";
}

export function entries(layers: Layer[]): Entry[] {
  const found = new Map<string, Entry>();
  for (const layer of [...layers].reverse()) {
    if (!layer.name || found.has(layer.name)) continue;
    found.set(layer.name, { name: layer.name, colour: layer.colour, alpha: layer.alpha, sign: sign(layer) });
  }
  return [...found.values()];
}

export function Legend({ layers, hidden }: { layers: Layer[]; hidden: Signal<ReadonlySet<string>> }) {
  const all = entries(layers);
  void scheme.value; // colours are those of the scheme
  if (!all.length) return <ul class="chart-legend" />;
  const toggle = (name: string) => {
    const next = new Set(hidden.peek());
    if (!next.delete(name)) next.add(name);
    hidden.value = next;
  };
  return (
    <ul class="chart-legend">
      {all.map((one) => (
        <li key={one.name}>
          <button aria-pressed={!hidden.value.has(one.name)} onClick={() => toggle(one.name)}>
            <span class={`chart-sign ${one.sign}`} style={{ color: colour(one.colour), opacity: Math.max(one.alpha, 0.35) }} />
            {one.name}
          </button>
        </li>
      ))}
    </ul>
  );
}
