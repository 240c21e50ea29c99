/** The edge between two parts of the window: dragged, moved by arrow keys, reset by a double click. */
import { LIMITS, resize, sizeOf, type Side } from "./layout.ts";

const STEP = 16; // px a key

const LABELS: Record<Side, string> = { left: "Width of the project", right: "Width of the inspector", below: "Height of the strips" };

export function Splitter({ side }: { side: Side }) {
  const across = side !== "below";
  // A size grows to the right on the left side, and against the axis elsewhere.
  const sign = side === "left" ? 1 : -1;
  const drag = (event: PointerEvent) => {
    const handle = event.currentTarget as HTMLElement;
    const [start, size] = [across ? event.clientX : event.clientY, sizeOf(side)];
    handle.setPointerCapture(event.pointerId);
    handle.onpointermove = (moved) => resize(side, size + sign * ((across ? moved.clientX : moved.clientY) - start));
    handle.onlostpointercapture = () => (handle.onpointermove = null);
  };
  const press = (event: KeyboardEvent) => {
    const [less, more] = across ? ["ArrowLeft", "ArrowRight"] : ["ArrowUp", "ArrowDown"];
    if (event.key !== less && event.key !== more) return;
    event.preventDefault();
    event.stopPropagation();
    resize(side, sizeOf(side) + sign * (event.key === more ? STEP : -STEP));
  };
  return (
    <div
      class={`splitter at-${side}`}
      role="separator"
      tabIndex={0}
      aria-label={LABELS[side]}
      aria-orientation={across ? "vertical" : "horizontal"}
      aria-valuenow={sizeOf(side)}
      aria-valuemin={LIMITS[side].least}
      aria-valuemax={LIMITS[side].most}
      onPointerDown={drag}
      onKeyDown={press}
      onDblClick={() => resize(side, LIMITS[side].first)}
    />
  );
}
