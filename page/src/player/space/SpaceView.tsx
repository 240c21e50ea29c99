/** The line in space: drag turns, right drag moves, wheel and + − zoom, arrows turn, Shift with arrows moves. */
import { effect, useSignal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { colours } from "../../drawing/canvas.ts";
import { isPlayed, shown } from "../../drawing/scene.ts";
import { exaggeration } from "../../state/selection.ts";
import { newState } from "../motion/state.ts";
import { state, viewers } from "../player.ts";
import { following } from "../views/camera.ts";
import { Stage } from "./stage.ts";
import "./space.css";

/** Labels of supports at most: more hide one another. */
const LABELS = 12;
/** Labels nearer than so many px to one another would cover one another: the nearer support has it. */
const WIDE = 130;
const HIGH = 18;
/** A mast that is lower than this on the screen has no label, px. */
const ROOM = 4 * HIGH;
/** Between a mast and its label, px. */
const GAP = 4;

function canDraw(): boolean {
  return document.createElement("canvas").getContext("webgl2") !== null;
}

/** Left end of a label right of its mast, or left of it where it would be cut; `null` where it is cut there too. px */
export function beside(mast: number, label: number, width: number): number | null {
  if (mast < 0 || mast > width) return null;
  if (mast + GAP + label <= width) return mast + GAP;
  return mast - GAP - label >= 0 ? mast - GAP - label : null;
}

const still = newState({ wires: [], spatial: false, droppers: 0, supports: 0, pantographs: 0 });

function label(stage: Stage, names: HTMLElement, width: number, height: number): void {
  const line = shown.peek();
  const near = (stage.section?.supports ?? [])
    .map((number) => line!.supports[number]!)
    .sort((a, b) => Math.abs(a.x_m - stage.looked) - Math.abs(b.x_m - stage.looked))
    .slice(0, LABELS);
  const taken: [number, number][] = [];
  near.forEach((support, at) => {
    const name = (names.children[at] ?? names.appendChild(document.createElement("span"))) as HTMLElement;
    const [x, y, z] = support.arms[0]?.to ?? [support.x_m, 0, 6];
    // Low at the mast, where no wire is; a far mast has no room for it.
    const [foot, top] = [0, z].map((up) => stage.project(x, up, -y, width, height));
    const place = foot && top && foot[1] - top[1] > ROOM ? stage.project(x, z / 3, -y, width, height) : null;
    name.hidden = false; // what is hidden has no width
    name.textContent = `${support.name} · ${support.x_m.toFixed(0)} m`;
    const left = place && beside(place[0], name.offsetWidth, width);
    const isIn = place !== null && left !== null && place[1] > HIGH / 2 && place[1] < height - HIGH;
    name.hidden = !isIn || taken.some(([x, y]) => Math.abs(x - left) <= WIDE && Math.abs(y - place[1]) <= HIGH);
    if (!isIn || name.hidden) return;
    taken.push([left, place[1]]);
    name.style.transform = `translate(${left.toFixed(0)}px, ${place[1].toFixed(0)}px) translate(0, -50%)`;
  });
  for (let at = near.length; at < names.children.length; at++) (names.children[at] as HTMLElement).hidden = true;
}

export function SpaceView() {
  const canvas = useRef<HTMLCanvasElement>(null);
  const names = useRef<HTMLDivElement>(null);
  const missing = useSignal(false);
  useEffect(() => {
    const element = canvas.current;
    const texts = names.current;
    if (!element || !texts) return;
    if (!canDraw()) return void (missing.value = true);
    let asked = false;
    const draw = () => {
      asked = false;
      const line = shown.peek();
      if (!line) return;
      stage.show(line, isPlayed.peek() ? state.current : still, exaggeration.peek(), following.peek());
      stage.render();
      label(stage, texts, element.clientWidth, element.clientHeight);
    };
    const ask = () => {
      if (!asked) requestAnimationFrame(draw);
      asked = true;
    };
    const stage = new Stage(element, colours(element), ask);
    const sized = new ResizeObserver(() => {
      stage.size(element.clientWidth, element.clientHeight);
      ask();
    });
    sized.observe(element);
    viewers.add(ask);
    const end = effect(() => {
      void [shown.value, isPlayed.value, exaggeration.value, following.value];
      ask();
    });
    const key = (event: KeyboardEvent) => {
      if (event.ctrlKey || event.altKey || event.metaKey || !stage.key(event)) return;
      event.preventDefault();
      event.stopPropagation();
    };
    element.addEventListener("keydown", key);
    return () => {
      viewers.delete(ask);
      end();
      sized.disconnect();
      stage.close();
    };
  }, []);
  if (missing.value) {
    return <p class="no-space">This browser offers no WebGL, so that there is no 3-D view. Side view and plan show the same line.</p>;
  }
  return (
    <div class="space">
      <canvas
        ref={canvas}
        role="img"
        tabIndex={0}
        aria-label="The line in space, with pantographs"
        aria-description="Arrow keys turn, Shift with arrow keys moves, plus and minus zoom."
      />
      <div class="names" ref={names} aria-hidden="true" />
      <p class="scale">Displacements × {exaggeration.value}, the line at rest to scale · <i class="slack" aria-hidden="true" /> slack dropper</p>
    </div>
  );
}
