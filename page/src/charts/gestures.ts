/** Wheel, drag with Shift or the middle button, and keys on a chart → ranges of its first axis. */
import { moved, within, zoomed, type Range } from "./extent.ts";

/** What gestures need of a chart. */
export interface Handle {
  x: () => Range;
  bounds: Range | null;
  logarithmic: boolean;
  /** Place of a pixel of the frame along the first axis. */
  at: (px: number) => number;
  /** Width of the frame in px. */
  width: () => number;
  show: (x: Range) => void;
  reset: () => void;
  /** The keyboard's cursor goes to a place. */
  point: (x: number) => void;
  pointed: () => number | null;
}

/** One notch of a wheel, and one press of a key, make a range so many times larger or smaller. */
const NOTCH = 1.2;
/** Part of the range by which an arrow moves, and by which the cursor goes with Shift. */
const STEP = 0.1;
const FINE = 0.01;
/** Lines of a wheel that counts in lines, in px, and px of a notch. */
const LINE_PX = 33;
const NOTCH_PX = 100;

function scaled(handle: Handle, around: number, factor: number): void {
  handle.show(within(zoomed(handle.x(), around, factor, handle.logarithmic), handle.bounds));
}

/** Follow the pointer on a frame; the returned function ends it. */
export function follow(over: HTMLElement, handle: Handle): () => void {
  const wheel = (event: WheelEvent) => {
    // A wheel alone scrolls the page; with Ctrl or Alt, or pinched on a pad, it zooms.
    if (!event.ctrlKey && !event.altKey) return;
    event.preventDefault();
    const lines = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? LINE_PX : 1;
    const px = event.clientX - over.getBoundingClientRect().left;
    scaled(handle, handle.at(px), NOTCH ** ((event.deltaY * lines) / NOTCH_PX));
  };
  const down = (event: PointerEvent) => {
    if (!(event.button === 1 || (event.button === 0 && event.shiftKey))) return;
    event.preventDefault();
    event.stopImmediatePropagation();
    over.setPointerCapture(event.pointerId);
    const [from, start] = [event.clientX, handle.x()];
    const move = (now: PointerEvent) =>
      handle.show(within(moved(start, (from - now.clientX) / handle.width()), handle.bounds));
    const up = () => {
      over.removeEventListener("pointermove", move);
      over.removeEventListener("pointerup", up);
      over.removeEventListener("pointercancel", up);
    };
    over.addEventListener("pointermove", move);
    over.addEventListener("pointerup", up);
    over.addEventListener("pointercancel", up);
  };
  // uPlot begins its box at the mouse event that follows.
  const still = (event: MouseEvent) => {
    if (event.shiftKey || event.button === 1) event.stopImmediatePropagation();
  };
  over.addEventListener("wheel", wheel, { passive: false });
  over.addEventListener("pointerdown", down, true);
  over.addEventListener("mousedown", still, true);
  return () => {
    over.removeEventListener("wheel", wheel);
    over.removeEventListener("pointerdown", down, true);
    over.removeEventListener("mousedown", still, true);
  };
}

/** Act on a key pressed on a chart; true where it had a meaning. */
export function pressed(event: KeyboardEvent, handle: Handle): boolean {
  const [low, high] = handle.x();
  const middle = handle.logarithmic ? Math.sqrt(low * high) : (low + high) / 2;
  const way = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
  if (way && event.shiftKey) {
    const from = handle.pointed() ?? middle;
    handle.point(Math.min(Math.max(from + way * FINE * (high - low), low), high));
  } else if (way && !handle.logarithmic) handle.show(within(moved([low, high], way * STEP), handle.bounds));
  else if (event.key === "+" || event.key === "=") scaled(handle, handle.pointed() ?? middle, 1 / NOTCH);
  else if (event.key === "-") scaled(handle, handle.pointed() ?? middle, NOTCH);
  else if (event.key === "0" || event.key === "Home") handle.reset();
  else return false;
  return true;
}
