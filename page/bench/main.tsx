/** The player on synthetic motion: `?view=side|space&points=16000`; `window.bench()` measures 5 s of playing. */
import { render } from "preact";
import "virtual:tokens.css";
import "../src/look/base.css";
import "../src/drawing/drawing.css";
import { LineView } from "../src/drawing/LineView.tsx";
import { play, setEnds } from "../src/player/clock.ts";
import { MotionTools } from "../src/player/MotionTools.tsx";
import { history, present, store, viewers } from "../src/player/player.ts";
import { register } from "../src/player/register.ts";
import { SpaceView } from "../src/player/space/SpaceView.tsx";
import { Transport } from "../src/player/Transport.tsx";
import { Strips } from "../src/player/views/Strips.tsx";
import { clock, range } from "../src/state/selection.ts";
import { fill, lineOf } from "./synthetic.ts";

const SECONDS = 4;
const asked = new URLSearchParams(location.search);
const line = lineOf(Number(asked.get("points") ?? 16000));
const space = asked.get("view") === "space";

register();
fill(store, line, SECONDS, 60);
for (const [name, track] of store.tracks) {
  const number = Number(name.split(".")[1]);
  for (const [piece] of track.entries) if (name.startsWith("pantograph")) history.addPantograph(number, piece!.values);
}
present(
  { geometry: line, row_s: 1 / 60, wires: true, search: null, pantographs: [{ name: "P1", masses: ["1", "2", "3"] }, { name: "P2", masses: ["1", "2", "3"] }] },
  0, SECONDS, false,
);
if (asked.has("whole")) range.value = [0, line.spans.at(-1)!.end_m];

declare global {
  interface Window {
    bench: () => Promise<{ frames_per_s: number; longest_ms: number }>;
  }
}

/** Plays for 5 s, again from the start where the motion ends. */
window.bench = () =>
  new Promise((resolve) => {
    let [frames, longest] = [0, 0];
    const begin = performance.now();
    let before = begin;
    const again = () => {
      if (!clock.playing.peek()) play();
    };
    viewers.add(again);
    play();
    const count = (now: number) => {
      frames++;
      longest = Math.max(longest, now - before);
      before = now;
      if (now - begin < 5000) return void requestAnimationFrame(count);
      viewers.delete(again);
      setEnds(0, SECONDS, false);
      resolve({ frames_per_s: (1000 * frames) / (now - begin), longest_ms: longest });
    };
    requestAnimationFrame(count);
  });

function Bench() {
  return (
    <div style={{ width: "1200px" }}>
      <div style={{ height: "600px", display: "grid" }}>{space ? <SpaceView /> : <LineView view="side" />}</div>
      <MotionTools />
      {!space && <Strips />}
      <Transport />
    </div>
  );
}
render(<Bench />, document.getElementById("bench")!);
