/** The transport bar: play, rate, scrubber, where the first pantograph is, the newest frame. */
import { useEffect } from "preact/hooks";
import { useSignal } from "@preact/signals";
import { clock } from "../state/selection.ts";
import { worst } from "../state/worst.ts";
import { follow, growing, jump, pause, RATES, step, toggle } from "./clock.ts";
import { stepSpan, stepWorst } from "./places.ts";
import { every, scene, state, viewers, waiting } from "./player.ts";
import "./player.css";

/** Where the first pantograph is: span, position in m. */
function where(): string {
  const x = state.current.pantographs[0]?.position ?? NaN;
  const spans = scene.peek()?.geometry.spans ?? [];
  if (!Number.isFinite(x)) return "";
  const span = spans.find((one) => x >= one.start_m && x < one.end_m);
  return `${span ? `span ${span.number}` : "beside the line"} · ${x.toFixed(1)} m`;
}

export const rateText = (rate: number): string => `${rate}×`;

/** Paths in a square of 16: fonts of many systems have no such signs. */
const ICONS = {
  start: "M3 3h2v10H3zM13 3v10L6 8z",
  back: "M12 3v10L5 8z",
  play: "M4 2v12l10-6z",
  pause: "M4 3h3v10H4zM9 3h3v10H9z",
  on: "M4 3v10l7-5z",
} as const;

function Icon({ name }: { name: keyof typeof ICONS }) {
  return (
    <svg viewBox="0 0 16 16" width="14" height="14" aria-hidden="true" fill="currentColor">
      <path d={ICONS[name]} />
    </svg>
  );
}

/** The bar; nothing without something to play. */
export function Transport() {
  const place = useSignal("");
  useEffect(() => {
    const view = () => void (place.value = where());
    viewers.add(view);
    view(); // frames may have come before the code of the bar
    return () => void viewers.delete(view);
  }, []);
  if (!scene.value) return null;
  const { time_s, start_s, end_s, playing, rate, live } = clock;
  const time = time_s.value;
  const readout = `${time.toFixed(2)} s`;
  return (
    <div class="transport" role="group" aria-label="Player">
      <button aria-label="To the start" title="To the start" onClick={() => jump(start_s.peek())}><Icon name="start" /></button>
      <button aria-label="One step back" title="One step back, ←" onClick={() => step(-1, every())}><Icon name="back" /></button>
      <button class="play" aria-label={playing.value ? "Pause" : "Play"} title="Space" onClick={toggle}>
        <Icon name={playing.value ? "pause" : "play"} />
      </button>
      <button aria-label="One step on" title="One step on, →" onClick={() => step(1, every())}><Icon name="on" /></button>
      <label>
        <span class="unseen">Rate</span>
        <select value={String(rate.value)} onChange={(event) => (rate.value = Number(event.currentTarget.value))}>
          {RATES.map((one) => <option key={one} value={String(one)}>{rateText(one)}</option>)}
        </select>
      </label>
      <input
        type="range"
        aria-label="Time"
        aria-valuetext={`${readout}${place.value ? `, ${place.value}` : ""}`}
        min={start_s.value}
        max={Math.max(end_s.value, start_s.value + 1e-3)}
        step="any"
        value={time}
        onInput={(event) => (pause(), jump(Number(event.currentTarget.value)))}
        onKeyDown={scrubbed}
      />
      <output class="where">{place.value ? `${place.value} · ` : ""}{readout}</output>
      {scene.value.search !== null && <span class="attempt" role="status">Search for the static force, attempt {scene.value.search}</span>}
      <span class="waiting" role="status">{waiting.value && playing.value ? "loading" : ""}</span>
      {worst.value.length > 0 && (
        <button title="K and J: previous and next" onClick={() => stepWorst(1)}>Next worst place</button>
      )}
      {growing.value && (
        <button class="live" aria-pressed={live.value} onClick={follow}>● Live</button>
      )}
    </div>
  );
}

/** Keys of the scrubber: as everywhere, an arrow is a step, with Shift a span. */
function scrubbed(event: KeyboardEvent): void {
  const direction = { ArrowLeft: -1, ArrowDown: -1, ArrowRight: 1, ArrowUp: 1 }[event.key] as 1 | -1 | undefined;
  if (!direction) return;
  event.preventDefault();
  event.stopPropagation();
  if (event.shiftKey) stepSpan(direction);
  else step(direction, every());
}
