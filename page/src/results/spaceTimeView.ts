/** What the space–time view does: asks for the part that is shown, draws it, follows the pointer. */
import { effect, signal, type Signal } from "@preact/signals";
import { scheme } from "../charts/colours.ts";
import { moved, within, type Range } from "../charts/extent.ts";
import { decimals } from "../charts/numbers.ts";
import { askNumbers } from "../connection/numbers.ts";
import { newest, RefusedError, type Complaint } from "../connection/http.ts";
import { clock, cursor, range, source } from "../state/selection.ts";
import { frameOf, paint, type Shown } from "./paint.ts";
import { placesOf, zoomedPart, type About, type Part } from "./view.ts";

/** After the last change of the part in ms. */
const REST_MS = 100;
const NOTCH = 1.2;
const NOTCH_PX = 100;
const STEP = 0.1;
/** A box smaller than this in px is a click. */
const LEAST_BOX = 6;

const ALL: Part = { x: [0, 1], t: [0, 1] };

export class SpaceTimeView {
  readonly shown = signal<Shown | null>(null);
  readonly complaint = signal<Complaint | null>(null);
  /** The motion was not recorded. */
  readonly absent = signal(false);
  readonly readout = signal("");
  /** The part that is shown was asked for, and is not here. */
  readonly waiting = signal(true);
  readonly zoomed = signal(false);
  private readonly part = signal<Part | null>(null);
  private canvas: HTMLCanvasElement | null = null;
  private timer: ReturnType<typeof setTimeout> | undefined;
  private box: { x: number; y: number } | null = null;

  constructor(
    private readonly run: string,
    private readonly waves: Signal<boolean>,
  ) {}

  private readonly answer = newest(async (stop: AbortSignal, part: Part | null): Promise<Shown | null> => {
    const frame = frameOf(this.canvas?.clientWidth ?? 800, this.canvas?.clientHeight ?? 400);
    const query: Record<string, string | number | undefined> = {
      run: this.run,
      width: Math.min(2400, Math.round(frame.width)),
      height: Math.min(1600, Math.round(frame.height)),
      ...(part ? { x0: part.x[0], x1: part.x[1], from: part.t[0], to: part.t[1] } : {}),
    };
    const { values, about } = await askNumbers<About | { recorded: false }>("space_time", query, stop);
    return about.recorded ? { values, about } : null;
  });

  /** Ask for the part that is shown. */
  async ask(): Promise<void> {
    this.waiting.value = true;
    try {
      const found = await this.answer(this.part.peek());
      if (found === undefined) return; // another question followed
      this.waiting.value = false;
      this.absent.value = found === null;
      if (!found) return;
      this.shown.value = found;
      if (!this.part.peek()) this.part.value = { x: found.about.x, t: found.about.t };
    } catch (error) {
      this.waiting.value = false;
      this.complaint.value = error instanceof RefusedError ? error.complaint : { text: "The server did not answer." };
    }
  }

  /** Begin on a canvas; the returned function ends it. */
  start(canvas: HTMLCanvasElement): () => void {
    this.canvas = canvas;
    const size = new ResizeObserver(() => {
      this.draw();
      this.later();
    });
    size.observe(canvas);
    const stop = effect(() => {
      void scheme.value;
      void [this.shown.value, this.part.value, this.waves.value, clock.time_s.value, cursor.value];
      this.draw();
    });
    const follow = effect(() => {
      const wanted = range.value;
      const part = this.part.peek();
      if (wanted && part && (wanted[0] !== part.x[0] || wanted[1] !== part.x[1])) this.show({ x: wanted, t: part.t });
    });
    canvas.addEventListener("wheel", this.wheel, { passive: false });
    canvas.addEventListener("pointerdown", this.down);
    canvas.addEventListener("pointermove", this.move);
    canvas.addEventListener("pointerleave", this.leave);
    void this.ask();
    return () => {
      clearTimeout(this.timer);
      size.disconnect();
      stop();
      follow();
      canvas.removeEventListener("wheel", this.wheel);
    };
  }

  private get whole(): Part {
    const about = this.shown.peek()?.about;
    return about ? { x: about.whole_x, t: about.whole_t } : ALL;
  }

  private draw(): void {
    const marks = { waves: this.waves.peek(), time_s: clock.time_s.peek(), cursor_m: cursor.peek() };
    if (this.canvas && this.shown.peek()) paint(this.canvas, this.part.peek() ?? ALL, this.shown.peek(), marks);
  }

  private later(): void {
    clearTimeout(this.timer);
    this.timer = setTimeout(() => void this.ask(), REST_MS);
  }

  private show(part: Part): void {
    const whole = this.whole;
    const next = { x: within(part.x, whole.x), t: within(part.t, whole.t) };
    const before = this.part.peek();
    this.part.value = next;
    this.zoomed.value = true;
    // The other views show the same part of the track.
    if (before && (before.x[0] !== next.x[0] || before.x[1] !== next.x[1])) range.value = next.x;
    this.later();
  }

  reset(): void {
    this.part.value = this.whole;
    this.zoomed.value = false;
    if (range.peek() !== null) range.value = null;
    this.later();
  }

  private at(event: MouseEvent): { x: number; t: number; px: number; py: number } {
    const rect = this.canvas!.getBoundingClientRect();
    const [px, py] = [event.clientX - rect.left, event.clientY - rect.top];
    const places = placesOf(this.part.peek() ?? ALL, frameOf(rect.width, rect.height));
    return { x: places.backX(px), t: places.backT(py), px, py };
  }

  private readonly wheel = (event: WheelEvent): void => {
    if (!event.ctrlKey && !event.altKey) return;
    event.preventDefault();
    this.zoom(this.at(event), NOTCH ** (event.deltaY / NOTCH_PX));
  };

  private zoom(at: { x: number; t: number }, factor: number): void {
    const part = this.part.peek();
    if (part) this.show(zoomedPart(part, at, factor, this.whole));
  }

  private readonly down = (event: PointerEvent): void => {
    if (event.button !== 0 || !this.canvas) return;
    this.canvas.setPointerCapture(event.pointerId);
    const { px, py, x, t } = this.at(event);
    this.box = { x: px, y: py };
    const up = (end: PointerEvent) => {
      this.canvas?.removeEventListener("pointerup", up);
      this.box = null;
      const to = this.at(end);
      if (Math.abs(to.px - px) < LEAST_BOX && Math.abs(to.py - py) < LEAST_BOX) this.setClock(to.x, to.t);
      else this.show({ x: sorted(x, to.x, this.part.peek()!.x), t: sorted(t, to.t, this.part.peek()!.t) });
    };
    this.canvas.addEventListener("pointerup", up);
  };

  private readonly move = (event: PointerEvent): void => {
    const at = this.at(event);
    this.tell(at.x, at.t);
    cursor.value = at.x;
    if (!this.box || !this.canvas) return;
    this.draw();
    const context = this.canvas.getContext("2d");
    context?.strokeRect(this.box.x, this.box.y, at.px - this.box.x, at.py - this.box.y);
  };

  private readonly leave = (): void => {
    cursor.value = null;
    this.readout.value = "";
  };

  private tell(x: number, t: number): void {
    const found = this.shown.peek();
    if (!found) return;
    const { about, values } = found;
    const column = Math.floor(((x - about.x[0]) / (about.x[1] - about.x[0])) * about.columns);
    const row = Math.floor(((t - about.t[0]) / (about.t[1] - about.t[0])) * about.rows);
    const inside = column >= 0 && column < about.columns && row >= 0 && row < about.rows;
    const value = inside ? values[row * about.columns + column]! : NaN;
    const text = Number.isNaN(value) ? "not recorded here" : `${decimals(value, 3)} m/s`;
    this.readout.value = `${decimals(x, 1)} m · ${decimals(t, 3)} s · ${text}`;
  }

  private setClock(x: number, t: number): void {
    const played = source.peek();
    if (!(played && "run" in played && played.run === this.run)) source.value = { run: this.run };
    clock.playing.value = false;
    clock.time_s.value = t;
    cursor.value = x;
  }

  key(event: KeyboardEvent): void {
    const part = this.part.peek();
    if (!part || event.ctrlKey || event.metaKey || event.altKey) return;
    const middle = (range: Range) => (range[0] + range[1]) / 2;
    const centre = { x: middle(part.x), t: middle(part.t) };
    const arrows: Record<string, Part> = {
      ArrowLeft: { x: moved(part.x, -STEP), t: part.t },
      ArrowRight: { x: moved(part.x, STEP), t: part.t },
      ArrowUp: { x: part.x, t: moved(part.t, STEP) },
      ArrowDown: { x: part.x, t: moved(part.t, -STEP) },
    };
    const to = arrows[event.key];
    if (to) this.show(to);
    else if (event.key === "+" || event.key === "=") this.zoom(centre, 1 / NOTCH);
    else if (event.key === "-") this.zoom(centre, NOTCH);
    else if (event.key === "0" || event.key === "Home") this.reset();
    else if (event.key === "Enter") this.setClock(cursor.peek() ?? centre.x, centre.t);
    else return;
    event.preventDefault();
    event.stopPropagation();
  }
}

/** A range between two places; the one there was where they are too close to be meant. */
function sorted(a: number, b: number, before: Range): Range {
  const least = (before[1] - before[0]) / 500;
  return Math.abs(a - b) < least ? before : [Math.min(a, b), Math.max(a, b)];
}
