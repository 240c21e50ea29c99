/**
 * Lowest and highest contact force by position along the track, of all frames that were received:
 * what strips show of a run that is being computed. Positions in m, forces in N.
 */

/** Width of a bucket in m: finer than a pixel of a span that fills the window. */
const WIDTH = 0.1;
/** Buckets of a pantograph at most, 4 MB: then they become twice as wide. */
const MOST = 500_000;

export class Buckets {
  width = WIDTH;
  private start = NaN;
  private low = new Float32Array(0);
  private high = new Float32Array(0);

  add(x: number, value: number): void {
    if (!Number.isFinite(x) || !Number.isFinite(value)) return;
    if (Number.isNaN(this.start)) this.start = Math.floor(x / this.width) * this.width;
    let at = Math.floor((x - this.start) / this.width);
    if (at < 0) {
      this.grow(this.low.length - at, -at);
      this.start += at * this.width;
      at = 0;
    }
    while (at >= MOST) {
      this.halve();
      at = Math.floor((x - this.start) / this.width);
    }
    if (at >= this.low.length) this.grow(Math.max(2 * this.low.length, at + 1, 1024), 0);
    if (!(this.low[at]! <= value)) this.low[at] = value;
    if (!(this.high[at]! >= value)) this.high[at] = value;
  }

  /** Lowest and highest value between two positions; `null` where nothing was received. */
  ends(from: number, to: number): [number, number] | null {
    const first = Math.max(0, Math.floor((from - this.start) / this.width));
    const last = Math.min(this.low.length - 1, Math.floor((to - this.start) / this.width));
    let [low, high] = [Infinity, -Infinity];
    for (let at = first; at <= last; at++) {
      if (this.low[at]! < low) low = this.low[at]!;
      if (this.high[at]! > high) high = this.high[at]!;
    }
    return low <= high ? [low, high] : null;
  }

  private grow(size: number, shift: number): void {
    const moved = (old: Float32Array): Float32Array<ArrayBuffer> => {
      const next = new Float32Array(size).fill(NaN);
      next.set(old, shift);
      return next;
    };
    [this.low, this.high] = [moved(this.low), moved(this.high)];
  }

  private halve(): void {
    const half = Math.ceil(this.low.length / 2);
    const joined = (old: Float32Array, better: (a: number, b: number) => boolean): Float32Array<ArrayBuffer> => {
      const next = new Float32Array(half).fill(NaN);
      for (let at = 0; at < old.length; at++) {
        const value = old[at]!;
        if (!Number.isNaN(value) && !better(next[at >> 1]!, value)) next[at >> 1] = value;
      }
      return next;
    };
    this.low = joined(this.low, (a, b) => a <= b);
    this.high = joined(this.high, (a, b) => a >= b);
    this.width *= 2;
  }
}

export class History {
  /** By pantograph. */
  readonly force: Buckets[] = [];
  /** Largest uplift at each support in m, of what was received; NaN before. */
  uplift = new Float32Array(0);

  addPantograph(number: number, values: Float32Array): void {
    (this.force[number] ??= new Buckets()).add(values[0]!, values[1]!);
  }

  addSupports(first: number, values: Float32Array): void {
    if (this.uplift.length < first + values.length) {
      const next = new Float32Array(first + values.length).fill(NaN);
      next.set(this.uplift);
      this.uplift = next;
    }
    values.forEach((value, at) => {
      if (!(this.uplift[first + at]! >= value) && !Number.isNaN(value)) this.uplift[first + at] = value;
    });
  }

  clear(): void {
    this.force.length = 0;
    this.uplift = new Float32Array(0);
  }
}
