/**
 * The line from the side or in plan. Wheel: zoom about the pointer; drag: move along, or a dropper
 * (in plan the stagger at a support), which is then changed in the text. Keys: see `keys`.
 */
import { useSignal, useSignalEffect } from "@preact/signals";
import { useMemo, useRef } from "preact/hooks";
import { leave, point, pointed } from "../state/pointing.ts";
import { cursor, exaggeration, range, selected } from "../state/selection.ts";
import { inWords, wentTo } from "../state/worst.ts";
import { camera, fitted, kept, zoomed, type Camera } from "./camera.ts";
import { useCanvas } from "./canvas.ts";
import { dragOf, type Drag } from "./drag.ts";
import { look, size } from "./fit.ts";
import { indexOf } from "./lineIndex.ts";
import { paintLine } from "./linePainter.ts";
import { pick, type Picked } from "./pick.ts";
import { ghost, handles, isDraft, isPlayed, layers, marked, moved, redraw, shown, sight, whole, wrong } from "./scene.ts";
import type { View } from "./wirePath.ts";
import { drawingInWords, pickedInWords, placeInWords } from "./words.ts";

// Of one notch of a wheel, and of one key.
const ZOOM = 1.2;
/** A pointer that moved less than this, in px, clicked. */
const CLICK = 4;
const PALE = 0.35;
/** Lateral positions in plan are drawn so many times larger than lengths, up to this. */
const PLAN_LARGEST = 100;

const now = () => (isPlayed.value ? moved.current : null);

function sightOf(view: View, width: number, height: number): Camera | null {
  const geometry = shown.value;
  if (!geometry) return null;
  const line = indexOf(geometry);
  const [low, high] = view === "side" ? line.z : line.y;
  const seen = sight.value;
  const larger =
    view === "side" ? exaggeration.value : Math.min(fitted(seen, high - low, width, height), PLAN_LARGEST);
  const centre = view === "side" ? {} : { centre: 0.5 };
  return camera({ range: seen, width, height, exaggeration: larger, middle: (low + high) / 2, ...centre });
}

export function LineView({ view }: { view: View }) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const eye = useRef<Camera | null>(null);
  const hover = useSignal<Picked | null>(null);
  const drag = useSignal<Drag | null>(null);
  const pointer = useRef<number | null>(null);
  const began = useRef<{ x: number; range: [number, number]; moved: boolean } | null>(null);

  useCanvas(canvas, ({ context, width, height, colour }) => {
    const geometry = shown.value;
    const seen = sightOf(view, width, height);
    eye.current = seen;
    if (view === "side") size.current = [width, height];
    if (!geometry || !seen) return;
    const pencil = { context, camera: seen, geometry, line: indexOf(geometry), colour };
    context.globalAlpha = wrong.value && !isPlayed.value ? PALE : 1;
    paintLine(pencil, view, { now: now(), ghost: ghost.value, selected: selected.value, marked: marked.value });
    context.globalAlpha = 1;
    for (const layer of layers) if (layer.view === view) layer.draw(pencil);
    drag.value?.draw(pencil);
    const at = pointed.value;
    if (at !== null && at >= seen.x0 && at <= seen.x1) {
      context.strokeStyle = colour("accent");
      context.lineWidth = 1;
      context.beginPath();
      context.moveTo(seen.x(at), 18);
      context.lineTo(seen.x(at), height - 18);
      context.stroke();
    }
  });

  // The line moves below a pointer that stands.
  useSignalEffect(() => {
    const seen = sightOf(view, canvas.current?.clientWidth ?? 0, canvas.current?.clientHeight ?? 0);
    if (pointer.current === null || !seen) return;
    point(seen.metres(pointer.current));
    hover.value = null;
  });
  const looked = (event: PointerEvent) => {
    const [geometry, seen] = [shown.peek(), eye.current];
    if (!geometry || !seen) return null;
    const found = { geometry, line: indexOf(geometry), camera: seen, view, now: now() };
    return pick(found, event.offsetX, event.offsetY);
  };
  const act = useMemo(
    () => ({
      move(event: PointerEvent) {
        const [geometry, seen, start] = [shown.peek(), eye.current, began.current];
        if (!geometry || !seen) return;
        pointer.current = event.offsetX;
        point(seen.metres(event.offsetX));
        if (drag.peek()) {
          drag.value = drag.peek()!.to(seen, event.offsetX, event.offsetY);
          redraw();
        } else if (start) {
          if (Math.abs(event.offsetX - start.x) > CLICK) start.moved = true;
          const away = (start.x - event.offsetX) / seen.scale;
          if (start.moved) range.value = kept([start.range[0] + away, start.range[1] + away], whole(geometry));
        } else hover.value = looked(event);
      },
      down(event: PointerEvent) {
        if (event.button !== 0 || !eye.current) return;
        canvas.current?.setPointerCapture(event.pointerId);
        const [found, geometry] = [looked(event), shown.peek()];
        began.current = { x: event.offsetX, range: sight.peek(), moved: false };
        const can = found && geometry && !isPlayed.peek() && !wrong.peek() ? handles.peek() : null;
        drag.value = can && found && geometry ? dragOf(found, can, geometry, view, event.offsetX) : null;
      },
      up(event: PointerEvent) {
        const [start, held] = [began.current, drag.peek()];
        began.current = null;
        drag.value = null;
        if (held?.moved) void held.drop();
        else if (start && !start.moved) choose(looked(event));
        redraw();
      },
      leave() {
        pointer.current = null;
        hover.value = null;
        leave();
      },
      cancel() {
        began.current = null;
        drag.value = null;
        redraw();
      },
      wheel(event: WheelEvent) {
        const [geometry, seen] = [shown.peek(), eye.current];
        if (!geometry || !seen || !event.deltaY) return;
        event.preventDefault();
        const factor = event.deltaY > 0 ? ZOOM : 1 / ZOOM;
        look(zoomed(sight.peek(), factor, seen.metres(event.offsetX), whole(geometry)));
      },
      key(event: KeyboardEvent) {
        const [geometry, seen] = [shown.peek(), eye.current];
        if (!geometry || !seen || event.ctrlKey || event.metaKey || event.altKey) return;
        if (keys(event, geometry, seen)) event.preventDefault();
      },
    }),
    [view],
  );
  const geometry = shown.value;
  const title = view === "side" ? "Side view" : "Plan";
  const label = geometry ? `${title}: ${drawingInWords(geometry, indexOf(geometry))}` : title;
  const at = pointed.value;
  const told =
    geometry &&
    (hover.value
      ? pickedInWords(geometry, hover.value, now(), isDraft.value)
      : view === "plan"
        ? ""
        : at === null || isDraft.value
          ? markInWords()
          : placeInWords(geometry, indexOf(geometry), at));
  return (
    <div class={`line-view ${view}`}>
      <canvas
        ref={canvas}
        role="img"
        aria-label={label}
        aria-description="Arrow keys move the cursor, Shift by a span; plus and minus zoom; F shows all; E changes the exaggeration of heights; Enter selects."
        tabIndex={0}
        onPointerMove={act.move}
        onPointerDown={act.down}
        onPointerUp={act.up}
        onPointerLeave={act.leave}
        onPointerCancel={act.cancel}
        onWheel={act.wheel}
        onKeyDown={act.key}
        onBlur={leave}
      />
      <div class="foot">
        <p class="told" aria-live="polite">
          {drag.value?.told ?? told}
        </p>
        {view === "side" && (
          <span class="key">
            <i aria-hidden="true" /> slack dropper
          </span>
        )}
      </div>
    </div>
  );
}

/** The worst place that is marked, in words: the mark has its number alone. */
function markInWords(): string {
  const place = wentTo.value;
  return place && isPlayed.value ? `worst place ${inWords(place)} · ${place.position_m.toFixed(2)} m` : "";
}

function choose(found: Picked | null): void {
  const geometry = shown.peek();
  if (!geometry || !found) return;
  if (found.kind === "span") selected.value = found;
  else {
    const one = found.kind === "dropper" ? geometry.droppers[found.index] : geometry.supports[found.index];
    if (one) selected.value = { kind: found.kind, name: one.name, x_m: one.x_m };
  }
}

/** Keys of a view: true where the key means something. */
function keys(event: KeyboardEvent, geometry: NonNullable<typeof shown.value>, seen: Camera): boolean {
  const all = whole(geometry);
  const at = cursor.peek() ?? (seen.x0 + seen.x1) / 2;
  const side = event.key === "ArrowLeft" ? -1 : 1;
  switch (event.key) {
    case "ArrowLeft":
    case "ArrowRight": {
      const starts = [...geometry.spans.map((span) => span.start_m), geometry.spans.at(-1)?.end_m ?? 0];
      const next = side < 0 ? starts.findLast((x) => x < at - 0.01) : starts.find((x) => x > at + 0.01);
      const to = event.shiftKey ? (next ?? at) : at + side / seen.scale;
      point(Math.min(Math.max(to, all[0]), all[1]), "keys");
      const [start, end] = sight.peek();
      if (cursor.peek()! < start || cursor.peek()! > end) {
        range.value = kept([cursor.peek()! - (end - start) / 2, cursor.peek()! + (end - start) / 2], all);
      }
      return true;
    }
    case "+":
    case "-":
      look(zoomed(sight.peek(), event.key === "-" ? ZOOM : 1 / ZOOM, at, all));
      return true;
    case "Enter": {
      const y = (seen.y(indexOf(geometry).z[0]) + seen.y(indexOf(geometry).z[1])) / 2;
      const line = { geometry, line: indexOf(geometry), camera: seen, view: "side" as const, now: now() };
      choose(pick(line, seen.x(at), y));
      return true;
    }
    default:
      return false;
  }
}
