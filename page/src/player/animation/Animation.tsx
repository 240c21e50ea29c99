/** Side view, strips and transport in the page of a report. Keys work where the animation has the focus. */
import { useEffect, useRef } from "preact/hooks";
import { camera, fitted, nextExaggeration, zoomed } from "../../drawing/camera.ts";
import { useCanvas } from "../../drawing/canvas.ts";
import { indexOf } from "../../drawing/lineIndex.ts";
import { paintLine } from "../../drawing/linePainter.ts";
import { ghost, layers, moved, shown, sight, whole } from "../../drawing/scene.ts";
import { leave, point } from "../../state/pointing.ts";
import { exaggeration, range } from "../../state/selection.ts";
import { pause, step, toggle } from "../clock.ts";
import { MotionTools } from "../MotionTools.tsx";
import { stepSpan, stepWorst } from "../places.ts";
import { every } from "../player.ts";
import { Transport } from "../Transport.tsx";
import { StripsOfReport } from "../views/Strips.tsx";
import { printing } from "../views/repaint.ts";
import "../player.css";
import "./animation.css";

const ZOOM = 1.3;
const NONE: ReadonlySet<number> = new Set();

function Side() {
  const canvas = useRef<HTMLCanvasElement>(null);
  useCanvas(canvas, ({ context, width, height, colour }) => {
    void printing.value;
    const geometry = shown.value;
    if (!geometry) return;
    const line = indexOf(geometry);
    const [low, high] = line.z;
    const seen = camera({
      range: sight.value, width, height, exaggeration: exaggeration.value, middle: (low + high) / 2,
    });
    const pencil = { context, camera: seen, geometry, line, colour };
    paintLine(pencil, "side", { now: moved.current, ghost: ghost.value, selected: null, marked: NONE });
    for (const layer of layers) if (layer.view === "side") layer.draw(pencil);
  });
  useEffect(() => {
    const geometry = shown.peek();
    const element = canvas.current;
    if (!geometry || !element) return;
    const [low, high] = indexOf(geometry).z;
    exaggeration.value = fitted(sight.peek(), high - low, element.clientWidth, element.clientHeight);
  }, []);
  return (
    <canvas
      ref={canvas}
      class="side"
      role="img"
      aria-label="Side view of the line and the pantographs at the time of the clock"
      onPointerMove={(event) => {
        const [x0, x1] = sight.peek();
        const { clientWidth: width, clientHeight: height } = event.currentTarget;
        point(camera({ range: [x0, x1], width, height, exaggeration: 1, middle: 0 }).metres(event.offsetX));
      }}
      onPointerLeave={leave}
    />
  );
}

/** Keys as in the studio; false where a key means nothing here. */
function keyed(event: KeyboardEvent): boolean {
  const on = event.key === "ArrowRight" ? 1 : -1;
  const line = shown.peek();
  switch (event.key) {
    case " ":
      toggle();
      return true;
    case "ArrowLeft":
    case "ArrowRight":
      if (event.shiftKey) stepSpan(on);
      else step(on, every());
      return true;
    case "j":
    case "k":
      stepWorst(event.key === "j" ? 1 : -1);
      return true;
    case "e":
      exaggeration.value = nextExaggeration(exaggeration.peek(), true);
      return true;
    case "+":
    case "-": {
      const [x0, x1] = sight.peek();
      if (line) range.value = zoomed([x0, x1], event.key === "-" ? ZOOM : 1 / ZOOM, (x0 + x1) / 2, whole(line));
      return true;
    }
    default:
      return false;
  }
}

function printed(): () => void {
  const root = document.documentElement;
  let scheme: string | undefined;
  const before = () => {
    pause();
    scheme = root.dataset["scheme"];
    root.dataset["scheme"] = "light";
    printing.value = true;
  };
  const after = () => {
    if (scheme === undefined) delete root.dataset["scheme"];
    else root.dataset["scheme"] = scheme;
    printing.value = false;
  };
  addEventListener("beforeprint", before);
  addEventListener("afterprint", after);
  return () => {
    removeEventListener("beforeprint", before);
    removeEventListener("afterprint", after);
  };
}

export function Animation() {
  useEffect(printed, []);
  return (
    <div
      class="animated"
      tabIndex={0}
      role="group"
      aria-label="Animation of the line and the pantographs"
      aria-description="Space plays, arrow keys step, Shift with them by a span, J and K go to the worst places, plus and minus zoom, E exaggerates."
      onKeyDown={(event) => {
        const own = event.target as HTMLElement;
        if (event.ctrlKey || event.altKey || event.metaKey || /BUTTON|SELECT|INPUT/.test(own.tagName)) return;
        if (keyed(event)) event.preventDefault();
      }}
    >
      <Side />
      <StripsOfReport />
      <Transport />
      <MotionTools />
    </div>
  );
}
