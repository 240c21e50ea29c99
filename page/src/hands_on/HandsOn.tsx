/** Hands on: the line moves in real time, with a hand on the static force of each pantograph. */
import { useEffect } from "preact/hooks";
import { LineView } from "../drawing/LineView.tsx";
import "../drawing/drawing.css";
import { subject, told as named } from "../state/subject.ts";
import { ForceNumber, Strip } from "./Forces.tsx";
import "./handsOn.css";
import { begun, blow, gust, laps, moment, offsets, phase, rate, reached, setOffset, setRate, start, stop } from "./session.ts";

/** Largest offset of the slider in N, and its step. */
const MOST = 100;
const RATES = [0.05, 0.1, 0.25, 0.5, 1];
/** The machine keeps pace when it reaches this share of the rate: moments are counted, not weighed. */
const KEPT = 0.95;

function Start() {
  const path = subject.value;
  return (
    <div class="start">
      <p>
        A session steps a scenario in real time. You change the static force of its pantographs while it runs, and let gusts
        blow. Nothing is stored. At the end of the line it begins anew.
      </p>
      <button class="main" disabled={path === null || phase.value !== "off"} onClick={start}>
        {phase.value === "starting" ? "Finding the line at rest …" : "Start the session"}
      </button>
      <p class="soft">{path === null ? "Choose a scenario on the left first." : `Scenario: ${named(path)}`}</p>
    </div>
  );
}

function Offset({ number }: { number: number }) {
  const own = begun.value!.pantographs[number]!;
  const offset = offsets.value[number] ?? 0;
  const added = moment.value?.added[number] ?? offset;
  const id = `offset-${number}`;
  const set = (text: string) => {
    const value = Number(text);
    if (text.trim() !== "" && Number.isFinite(value)) setOffset(number, Math.min(Math.max(value, -MOST), MOST));
  };
  return (
    <div class="offset">
      <label for={id}>Static force of {own.name}</label>
      <input id={id} type="range" min={-MOST} max={MOST} step={1} value={offset}
        aria-valuetext={`${signed(offset)} N`} onInput={(event) => set(event.currentTarget.value)} />
      <input type="number" aria-label={`Offset of ${own.name} in N`} min={-MOST} max={MOST} step={1} value={offset}
        onChange={(event) => set(event.currentTarget.value)} />
      <span class="unit">N</span>
      <span class="sum">
        {own.static_force_N.toFixed(0)} {signed(added)} N
      </span>
    </div>
  );
}

const signed = (value: number) => `${value < 0 ? "−" : "+"} ${Math.abs(Math.round(value))}`;

function Gust() {
  const { wind_m_s, duration_s } = gust.value;
  const field = (name: "wind_m_s" | "duration_s", label: string, unit: string, value: number, least: number, most: number) => (
    <label>
      {label}{" "}
      <input type="number" value={value} min={least} max={most} step="any"
        onChange={(event) => {
          const given = event.currentTarget.valueAsNumber;
          if (given >= least && given <= most) gust.value = { ...gust.peek(), [name]: given };
          else event.currentTarget.value = String(value);
        }} />{" "}
      {unit}
    </label>
  );
  return (
    <div class="gust" role="group" aria-label="Gust">
      <button onClick={blow} title="G">
        Gust <kbd>G</kbd>
      </button>
      {field("wind_m_s", "Wind", "m/s", wind_m_s, 0, 60)}
      {field("duration_s", "for", "s", duration_s, 0.05, 60)}
    </div>
  );
}

function Pace() {
  const slow = reached.value !== null && rate.value > 0 && reached.value < KEPT * rate.value;
  return (
    <span class="pace">
      <label>
        Pace{" "}
        <select value={String(rate.value)} onChange={(event) => setRate(Number(event.currentTarget.value))}>
          {RATES.map((one) => (
            <option key={one} value={String(one)}>{one === 1 ? "real time" : `${one} × real time`}</option>
          ))}
          <option value="0">paused</option>
        </select>
      </label>
      <span role="status">{slow ? ` This machine reaches ${reached.value!.toFixed(2)} × real time: the session is slowed down.` : ""}</span>
    </span>
  );
}

function Running() {
  const told = begun.value!;
  return (
    <>
      <div class="bar">
        <button onClick={stop}>Stop</button>
        <Pace />
        <span class="soft">
          Train at {(3.6 * told.speed_m_s).toFixed(0)} km/h{laps.value > 0 && ` · begun anew at the end of the line: ${laps.value} ×`}
        </span>
      </div>
      {told.notes.map((note) => (
        <p class="note" key={note}>{note.charAt(0).toUpperCase() + note.slice(1)}.</p>
      ))}
      <p class="note">
        The slider adds to the static force of the pantograph, in N. It acts on the lowest mass of the model, where the static force acts. A gust is a head wind that rises and
        falls as 1 − cos: the lift that it adds acts at the same place. Wires feel no wind.
      </p>
      <div class="hands">
        <div class="controls">
          {told.pantographs.map((_, number) => (
            <Offset key={number} number={number} />
          ))}
          <Gust />
        </div>
        <div class="forces">
          {told.pantographs.map((_, number) => (
            <ForceNumber key={number} number={number} />
          ))}
        </div>
      </div>
      <LineView view="side" />
      <Strip />
    </>
  );
}

export function HandsOn() {
  // A session that nobody sees would keep a core busy.
  useEffect(() => stop, []);
  return <div class="hands-on">{phase.value === "on" ? <Running /> : <Start />}</div>;
}
