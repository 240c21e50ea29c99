/** What a chart does: loads its figure, follows ranges and cursors, asks for more samples. */
import { effect, signal, type Signal } from "@preact/signals";
import { newest } from "../connection/http.ts";
import { cursor, range } from "../state/selection.ts";
import { scheme } from "./colours.ts";
import { loadedBy, question, type Loaded } from "./detail.ts";
import { ends, within, type Range } from "./extent.ts";
import type { Figure, Head, Layer, Shown } from "./figure.ts";
import { follow, pressed, type Handle } from "./gestures.ts";
import { Plot } from "./plot.ts";
import { told } from "./pointer.ts";

/** After the last change of a range in ms: sooner, questions are asked that nobody waits for. */
const REST_MS = 80;
/** Charts along the track are those whose axis has this group. */
const TRACK = "track";

interface Shows {
  layers: Signal<Layer[]>;
  readout: Signal<string>;
  hidden: Signal<ReadonlySet<string>>;
  zoomed: Signal<boolean>;
  failed: Signal<boolean>;
}

export class Controller {
  readonly visible = signal(false);
  readonly isTrack: boolean;
  private plot: Plot | null = null;
  private figure: Figure | null = null;
  private loaded: Loaded | null = null;
  private timer: ReturnType<typeof setTimeout> | undefined;
  private readonly ends: (() => void)[] = [];
  private readonly more: (shown: Shown) => Promise<Figure | undefined>;
  private all: Range = [0, 1];
  private pointed: number | null = null;
  private over = false;

  constructor(
    private readonly head: Head,
    ask: (shown: Shown, signal: AbortSignal) => Promise<Figure>,
    private readonly shows: Shows,
    private readonly complain: (error: unknown) => void,
    /** What a chart along the track shows until a range is chosen; null: what the window shows. */
    private opens: Range | null = null,
  ) {
    this.isTrack = head.x.group === TRACK;
    this.more = newest((stop: AbortSignal, shown: Shown) => ask(shown, stop));
  }

  private isHidden = (layer: Layer): boolean =>
    layer.name ? this.shows.hidden.peek().has(layer.name) : layer.hidden;

  /** Load the figure and draw it into an element. */
  async start(into: HTMLElement): Promise<void> {
    const asked = { points: Math.round(6 * Math.max(into.clientWidth, 200)) };
    let figure: Figure | undefined;
    try {
      figure = await this.more(asked);
    } catch (error) {
      this.shows.failed.value = true;
      this.complain(error);
    }
    if (!figure) return;
    this.figure = figure;
    this.loaded = loadedBy(asked, figure);
    this.all = this.head.x.bounds ?? ends(figure.x, figure.layers, "x");
    this.shows.hidden.value = new Set(figure.layers.filter((one) => one.hidden && one.name).map((one) => one.name));
    this.shows.layers.value = figure.layers;
    this.plot = new Plot(into, figure, this.isHidden, {
      box: (x, y) => this.show(x, y),
      pointer: (at) => this.point(at),
    });
    this.ends.push(follow(this.plot.u.over, this.handle));
    const size = new ResizeObserver(() => this.plot?.resize(into.clientWidth));
    size.observe(into);
    this.ends.push(() => size.disconnect(), ...this.effects());
  }

  private effects(): (() => void)[] {
    const redraw = () => effect(() => {
      void scheme.value;
      void this.shows.hidden.value;
      if (this.visible.value) this.plot?.redraw();
    });
    if (!this.isTrack) return [redraw()];
    const before = range.peek();
    const follows = effect(() => {
      if (range.value !== before) this.opens = null;
      const wanted = this.opens ?? range.value;
      this.shows.zoomed.value = wanted !== null;
      if (this.visible.value) this.take(wanted);
    });
    const marks = effect(() => {
      const at = cursor.value;
      if (this.visible.value && !this.over) this.plot?.mark(at);
    });
    return [redraw(), follows, marks];
  }

  private readonly handle: Handle = (() => {
    const chart = this;
    return {
      x: () => chart.plot?.ranges.x ?? chart.all,
      get bounds() {
        return chart.head.x.bounds ?? chart.all;
      },
      get logarithmic() {
        return chart.head.x.logarithmic;
      },
      at: (px: number) => chart.plot?.u.posToVal(px, "x") ?? 0,
      width: () => chart.plot?.u.over.clientWidth ?? 1,
      show: (x: Range) => chart.show(x),
      reset: () => chart.reset(),
      point: (x: number) => chart.pointAt(x),
      pointed: () => (chart.isTrack ? cursor.peek() : chart.pointed),
    };
  })();

  /** Show a range that was asked for on this chart, and on those of the same axis. */
  private show(x: Range, y: Range | null = null): void {
    const inside = within(x, this.handle.bounds);
    if (y) this.plot?.show(inside, y);
    if (this.isTrack) range.value = inside;
    else this.take(inside);
    this.shows.zoomed.value = true;
  }

  private take(x: Range | null): void {
    if (!this.plot) return;
    if (x === null) {
      this.plot.wholeY();
      this.shows.zoomed.value = false;
    }
    this.plot.show(x);
    clearTimeout(this.timer);
    this.timer = setTimeout(() => void this.refine(), REST_MS);
  }

  /** Ask for more samples where those that are there are too few for what is shown. */
  private async refine(): Promise<void> {
    if (!this.plot) return;
    const width = this.plot.u.over.clientWidth;
    const asked = question(this.plot.ranges.x, this.all, width, this.loaded);
    if (!asked) return;
    try {
      const figure = await this.more(asked);
      if (!figure || !this.plot) return;
      this.loaded = loadedBy(asked, figure);
      this.figure = figure;
      this.plot.take(figure);
    } catch (error) {
      this.complain(error);
    }
  }

  private point(at: { x: number; y: number; px: number; py: number } | null): void {
    this.over = at !== null;
    if (!at || !this.plot || !this.figure) return;
    this.pointed = at.x;
    this.plot.mark(null); // uPlot's own cross is there
    if (this.isTrack) cursor.value = at.x;
    const { u } = this.plot;
    const frame = this.plot.frame();
    const to = {
      x: (value: number) => (frame.x(value) - frame.left) / frame.ratio,
      y: (value: number) => (frame.y(value) - frame.top) / frame.ratio,
    };
    this.shows.readout.value = told(this.figure, at, u.cursor.left!, u.cursor.top!, to, this.isHidden);
  }

  /** Put the cursor somewhere by the keyboard: the line stands there, and the numbers of it are told. */
  private pointAt(x: number): void {
    this.pointed = x;
    if (this.isTrack) cursor.value = x;
    this.plot?.mark(x);
    if (!this.figure || !this.plot) return;
    const { y } = this.plot.ranges;
    const frame = this.plot.frame();
    const to = { x: (value: number) => frame.x(value) / frame.ratio, y: () => 0 };
    this.shows.readout.value = told(this.figure, { x, y: (y[0] + y[1]) / 2 }, to.x(x), 0, to, this.isHidden);
  }

  key(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (!pressed(event, this.handle)) return;
    event.preventDefault();
    event.stopPropagation();
  }

  /** Show all of it again. */
  reset(): void {
    this.opens = null;
    if (this.isTrack && range.peek() !== null) range.value = null;
    else this.take(null);
  }

  destroy(): void {
    clearTimeout(this.timer);
    for (const end of this.ends) end();
    this.plot?.destroy();
    this.plot = null;
  }
}
