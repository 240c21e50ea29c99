import { computed, effect } from "@preact/signals";
import { addLayer, isPlayed, shown, showing, type Pencil } from "../drawing/scene.ts";
import { addCommand, addPanel } from "../shell/panels.ts";
import { followPointing } from "../state/pointing.ts";
import { clock, range } from "../state/selection.ts";
import { worst } from "../state/worst.ts";
import { changeRate, follow, growing, jump, step, toggle } from "./clock.ts";
import { followSource } from "./opened.ts";
import { stepSpan, stepWorst } from "./places.ts";
import { every, scene, viewers, wake } from "./player.ts";
import { followWorst } from "./worst.ts";
import { followCamera, startFollowing } from "./views/camera.ts";
import { drawPlan, drawSide } from "./views/pantographs.ts";
import { followSeries } from "./views/series.ts";
import { byVelocity, drawVelocity } from "./views/velocity.ts";

const playing = computed(() => scene.value !== null);
/** Pantographs and forces are of the run: over the line of the file they would be of another one. */
const seen = computed(() => scene.value !== null && isPlayed.value);
const ifPlayed = (draw: (pencil: Pencil) => void) => (pencil: Pencil) => {
  if (isPlayed.peek()) draw(pencil);
};

function commands(): void {
  const add = (id: string, title: string, keys: string[], act: () => void) =>
    addCommand({ id: `player.${id}`, title, keys, act, when: playing });
  add("toggle", "Play or pause", ["Space"], toggle);
  add("back", "One step back", ["ArrowLeft"], () => step(-1, every()));
  add("on", "One step on", ["ArrowRight"], () => step(1, every()));
  add("span back", "One span back", ["Shift+ArrowLeft"], () => stepSpan(-1));
  add("span on", "One span on", ["Shift+ArrowRight"], () => stepSpan(1));
  add("slower", "Slower", ["<"], () => changeRate(-1));
  add("faster", "Faster", [">"], () => changeRate(1));
  add("start", "To the start of the run", ["Home"], () => jump(clock.start_s.peek()));
  add("follow", "Follow the first pantograph", [], startFollowing);
  add("velocity", "Velocity of the wires as colour", [], () => (byVelocity.value = !byVelocity.peek()));
  const places = computed(() => playing.value && worst.value.length > 0);
  addCommand({ id: "player.next", title: "Next worst place", keys: ["J"], act: () => stepWorst(1), when: places });
  addCommand({ id: "player.previous", title: "Previous worst place", keys: ["K"], act: () => stepWorst(-1), when: places });
  const live = computed(() => playing.value && growing.value);
  addCommand({ id: "player.live", title: "Follow the run that is computed", keys: ["End"], act: follow, when: live });
}

export function register(): void {
  addPanel({ id: "space", slot: "main", title: "3-D", order: 2, load: async () => (await import("./space/SpaceView.tsx")).SpaceView, when: computed(() => shown.value !== null) });
  addPanel({ id: "motion tools", slot: "below", title: "Motion", order: 0, load: async () => (await import("./MotionTools.tsx")).MotionTools, when: seen });
  addPanel({ id: "strips", slot: "below", title: "Strips", order: 1, load: async () => (await import("./views/Strips.tsx")).Strips, when: seen });
  addPanel({ id: "transport", slot: "bottom", title: "Player", order: 0, load: async () => (await import("./Transport.tsx")).Transport });
  addLayer({ id: "velocity", order: 0, view: "side", draw: ifPlayed(drawVelocity) });
  addLayer({ id: "pantographs", order: 1, view: "side", draw: ifPlayed(drawSide) });
  addLayer({ id: "pantographs in plan", order: 1, view: "plan", draw: ifPlayed(drawPlan) });
  viewers.add(followCamera);
  // Whoever plays wants to see the run, and no longer the line that was edited meanwhile.
  effect(() => {
    if (clock.playing.value) showing.value = "played";
  });
  // Whoever moves the range of a clock that stands leaves the pantograph, too.
  effect(() => {
    void range.value;
    wake();
  });
  commands();
  followSource();
  followWorst();
  followPointing();
  followSeries();
}
