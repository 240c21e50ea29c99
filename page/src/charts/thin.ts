/** Samples of a curve that a picture of it needs: those that are seen, and of many in a column of pixels two. */

const known = new WeakMap<object, boolean>();

/** Whether places never go back, as along a track or over time; found once of each list. */
export function ascends(x: ArrayLike<number> & object): boolean {
  let answer = known.get(x);
  if (answer === undefined) {
    answer = true;
    for (let k = 1; k < x.length && answer; k++) answer = x[k]! >= x[k - 1]!;
    known.set(x, answer);
  }
  return answer;
}

/** First of ascending places that is not below a value. */
function firstFrom(x: ArrayLike<number>, value: number): number {
  let [low, high] = [0, x.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if (x[middle]! < value) low = middle + 1;
    else high = middle;
  }
  return low;
}

/** Samples between two values of ascending places, with a neighbour on each side: first, and behind the last. */
export function seen(x: ArrayLike<number>, low: number, high: number): [number, number] {
  const [from, to] = [firstFrom(x, low), firstFrom(x, high)];
  // Several may lie on the upper end.
  let end = to;
  while (end < x.length && x[end]! <= high) end++;
  return [Math.max(0, from - 1), Math.min(x.length, end + 1)];
}

/**
 * Trace a curve with at most two points in a column of pixels, its lowest and its highest: more of them lie on
 * one another. NaN interrupts it.
 *
 * @param from first sample
 * @param to behind the last sample
 * @param place pixel of a sample
 * @param move begin a line there
 * @param line draw on to there
 */
export function trace(
  [from, to]: [number, number],
  place: (k: number) => [number, number],
  move: (x: number, y: number) => void,
  line: (x: number, y: number) => void,
): void {
  let open = false;
  let column = NaN;
  // Of the column: its lowest and its highest point, and which of them came first.
  let [lowX, lowY, highX, highY, isLowFirst] = [0, 0, 0, 0, true];
  const put = (x: number, y: number) => {
    if (open) line(x, y);
    else move(x, y);
    open = true;
  };
  const flush = () => {
    if (Number.isNaN(column)) return;
    column = NaN;
    if (lowX === highX && lowY === highY) return put(lowX, lowY);
    if (isLowFirst) put(lowX, lowY), put(highX, highY);
    else put(highX, highY), put(lowX, lowY);
  };
  for (let k = from; k < to; k++) {
    const [x, y] = place(k);
    if (Number.isNaN(x) || Number.isNaN(y)) {
      flush();
      open = false;
      continue;
    }
    const of = Math.floor(x);
    if (of !== column) {
      flush();
      column = of;
      [lowX, lowY, highX, highY] = [x, y, x, y];
    } else if (y < lowY) [lowX, lowY, isLowFirst] = [x, y, false];
    else if (y > highY) [highX, highY, isLowFirst] = [x, y, true];
  }
  flush();
}
