/** Forces of the last seconds, for the strip. Times in s of the session, forces in N. */

/** What the strip shows, in s. */
export const SHOWN = 6;
/** Moments that are kept: more than come in `SHOWN` at the slowest rate that is still followed. */
const MOST = 4096;

export class Trace {
  readonly times: number[] = [];
  readonly forces: number[][] = [];

  add(time: number, forces: number[]): void {
    this.times.push(time);
    this.forces.push(forces);
    const old = this.times.findIndex((one) => one >= time - SHOWN);
    const cut = Math.max(old, this.times.length - MOST);
    if (cut > 0) {
      this.times.splice(0, cut);
      this.forces.splice(0, cut);
    }
  }

  clear(): void {
    this.times.length = this.forces.length = 0;
  }

  /** Highest force that is kept, N. */
  highest(): number {
    // Of a pantograph beside the wire it is NaN, which is not higher than anything.
    return this.forces.flat().reduce((most, one) => (one > most ? one : most), 0);
  }
}
