/**
 * A figure of a report on the page: zoomed by a box, Ctrl and wheel, or keys, moved with Shift, and
 * tied to range and cursor of the window where its axis is the track.
 */
import { useSignal } from "@preact/signals";
import { useEffect, useMemo, useRef } from "preact/hooks";
import { complain } from "../shell/messages.ts";
import { cursor } from "../state/selection.ts";
import { Controller } from "./controller.ts";
import type { Range } from "./extent.ts";
import type { Head, Layer, Shown, Figure } from "./figure.ts";
import { Legend } from "./Legend.tsx";
import { ScaleKey } from "./ScaleKey.tsx";
import "./charts.css";

export type Ask = (shown: Shown, signal: AbortSignal) => Promise<Figure>;

/** Charts a screen away are loaded before they are seen. */
const AHEAD = "600px";

export function Chart({ head, ask, opens }: { head: Head; ask: Ask; opens?: Range | undefined }) {
  const into = useRef<HTMLDivElement>(null);
  const layers = useSignal<Layer[]>([]);
  const readout = useSignal("");
  const hidden = useSignal<ReadonlySet<string>>(new Set());
  const zoomed = useSignal(false);
  const failed = useSignal(false);
  const controller = useMemo(
    () => new Controller(head, ask, { layers, readout, hidden, zoomed, failed }, complain, opens ?? null),
    [head, ask],
  );
  useEffect(() => {
    const element = into.current!;
    let started = false;
    const seen = new IntersectionObserver(
      (entries) => {
        const visible = entries.some((entry) => entry.isIntersecting);
        if (visible && !started) {
          started = true;
          void controller.start(element);
        }
        controller.visible.value = visible;
      },
      { rootMargin: AHEAD },
    );
    seen.observe(element);
    return () => {
      seen.disconnect();
      controller.destroy();
    };
  }, [controller]);
  const id = `chart-${head.key}`;
  return (
    <figure class="chart">
      <div class="chart-head">
        <h4 id={id}>{head.title}</h4>
        {zoomed.value && <button onClick={() => controller.reset()}>Show all</button>}
      </div>
      <Legend layers={layers.value} hidden={hidden} />
      <div
        ref={into}
        class="chart-frame"
        role="application"
        aria-labelledby={id}
        aria-describedby={`${id}-alt`}
        aria-keyshortcuts="+ - 0 ArrowLeft ArrowRight Shift+ArrowLeft Shift+ArrowRight"
        tabIndex={0}
        style={{ minHeight: `${head.height}px` }}
        onKeyDown={(event) => controller.key(event)}
        onDblClick={() => controller.reset()}
        onPointerLeave={() => {
          readout.value = "";
          if (controller.isTrack) cursor.value = null;
        }}
      />
      {failed.value && <p class="chart-failed">This figure could not be read.</p>}
      {head.scale && <ScaleKey scale={head.scale} />}
      <output class="chart-readout" aria-live="polite">
        {readout.value}
      </output>
      <p id={`${id}-alt`} class="chart-alt">
        {head.alt}
      </p>
      {head.caption && <figcaption>{head.caption}</figcaption>}
    </figure>
  );
}
