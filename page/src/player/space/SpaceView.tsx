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

function canDraw(): boolean {
  return document.createElement("canvas").getContext("webgl2") !== null;
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
    const place = stage.project(x, z + 0.6, -y, width, height);
    const free = place && taken.every(([left, top]) => Math.abs(left - place[0]) > WIDE || Math.abs(top - place[1]) > HIGH);
    name.hidden = !free;
    if (!place || !free) return;
    taken.push(place);
    name.textContent = `${support.name} · ${support.x_m.toFixed(0)} m`;
    name.style.transform = `translate(${place[0].toFixed(0)}px, ${place[1].toFixed(0)}px) translate(-50%, -100%)`;
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
      <p class="scale">Displacements × {exaggeration.value}, the line at rest to scale</p>
    </div>
  );
}
