/** One channel of a motion, sorted by time in s: what was received of it and is still kept. */

/** Values of a channel at one time, of which the first one has the number `first`. */
export interface Piece {
  first: number;
  values: Float32Array;
}

/** Memory of a piece beside its values: array, buffer, object, entry of lists; measured in V8. */
const PIECE_BYTES = 240;

export const bytesOf = (piece: Piece): number => piece.values.byteLength + PIECE_BYTES;

/** The number of the last time that is at most `time`, or -1. */
export function lastAt(times: ArrayLike<number>, time: number): number {
  let low = 0;
  let high = times.length;
  while (low < high) {
    const middle = (low + high) >>> 1;
    if (times[middle]! <= time) low = middle + 1;
    else high = middle;
  }
  return low - 1;
}

export class Track {
  readonly times: number[] = [];
  readonly entries: Piece[][] = [];
  bytes = 0;

  /** Keep a piece; one that begins at the same number at the same time is replaced. */
  add(time: number, piece: Piece): void {
    const at = lastAt(this.times, time);
    if (at >= 0 && this.times[at] === time) {
      const pieces = this.entries[at]!;
      const same = pieces.findIndex((one) => one.first === piece.first);
      if (same >= 0) this.bytes -= bytesOf(pieces[same]!);
      pieces.splice(same >= 0 ? same : pieces.length, same >= 0 ? 1 : 0, piece);
      pieces.sort((a, b) => a.first - b.first);
    } else {
      this.times.splice(at + 1, 0, time);
      this.entries.splice(at + 1, 0, [piece]);
    }
    this.bytes += bytesOf(piece);
  }

  /** Forget what is earlier than `from` or later than `to`. */
  keep(from: number, to: number): void {
    const first = lastAt(this.times, from) + (this.times[lastAt(this.times, from)] === from ? 0 : 1);
    const last = lastAt(this.times, to) + 1;
    for (let at = 0; at < this.times.length; at++) {
      if (at < first || at >= last) for (const piece of this.entries[at]!) this.bytes -= bytesOf(piece);
    }
    this.times.splice(last);
    this.entries.splice(last);
    this.times.splice(0, first);
    this.entries.splice(0, first);
  }
}
