/** Speed of the newest frame of a run that is being computed, in s of the run in a second. */

/** Share of the newest speed in the mean: more follows each bundle of frames, less lags behind. */
const NEWEST = 0.2;
/** Two words of the edge that are nearer than so many ms tell no speed. */
const APART = 50;

export class Pace {
  /** 1 before it is known. */
  value = 1;
  private last: { end: number; at: number } | null = null;
  private known = false;

  /** The newest frame is at `end` s, told at `at` ms of the clock on the wall. */
  reached(end: number, at: number): void {
    const { last } = this;
    this.last = { end, at };
    if (!last || at - last.at <= APART) return;
    const speed = (1000 * (end - last.end)) / (at - last.at);
    // The first speed counts whole: a mean that begins at 1 is behind a fast run for seconds.
    this.value += (this.known ? NEWEST : 1) * (speed - this.value);
    this.known = true;
  }

  forget(): void {
    [this.value, this.last, this.known] = [1, null, false];
  }
}
