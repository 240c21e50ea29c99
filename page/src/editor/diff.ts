/** Differences of two texts, line by line: the longest common lines stay. */

export interface Piece {
  /** Lines that both have, or those of either side. */
  same: boolean;
  mine: string[];
  theirs: string[];
}

// Above so many cells of the table the middle is taken as changed as a whole: 60 MB, 0.1 s.
const MOST_CELLS = 16_000_000;

/** Pieces of two texts in their order; the lines of `mine` together are the one, of `theirs` the other. */
export function diff(mine: string, theirs: string): Piece[] {
  const [a, b] = [mine.split("\n"), theirs.split("\n")];
  let start = 0;
  while (start < a.length && start < b.length && a[start] === b[start]) start++;
  let end = 0;
  while (end < a.length - start && end < b.length - start && a.at(-1 - end) === b.at(-1 - end)) end++;
  const pieces: Piece[] = [];
  add(pieces, true, a.slice(0, start), b.slice(0, start));
  between(pieces, a.slice(start, a.length - end), b.slice(start, b.length - end));
  add(pieces, true, a.slice(a.length - end), b.slice(b.length - end));
  return pieces;
}

function add(pieces: Piece[], same: boolean, mine: string[], theirs: string[]): void {
  if (!mine.length && !theirs.length) return;
  const last = pieces.at(-1);
  if (last?.same === same) {
    last.mine.push(...mine);
    last.theirs.push(...theirs);
  } else pieces.push({ same, mine: [...mine], theirs: [...theirs] });
}

function between(pieces: Piece[], a: string[], b: string[]): void {
  const wide = b.length + 1;
  if ((a.length + 1) * wide > MOST_CELLS) {
    add(pieces, false, a, b);
    return;
  }
  // Length of the longest common lines of what is left of both.
  const left = new Uint32Array((a.length + 1) * wide);
  for (let i = a.length - 1; i >= 0; i--) {
    for (let j = b.length - 1; j >= 0; j--) {
      const here = i * wide + j;
      left[here] = a[i] === b[j] ? left[here + wide + 1]! + 1 : Math.max(left[here + wide]!, left[here + 1]!);
    }
  }
  let [i, j] = [0, 0];
  while (i < a.length || j < b.length) {
    if (i < a.length && j < b.length && a[i] === b[j]) add(pieces, true, [a[i++]!], [b[j++]!]);
    else if (j >= b.length || (i < a.length && left[(i + 1) * wide + j]! >= left[i * wide + j + 1]!)) {
      add(pieces, false, [a[i++]!], []);
    } else add(pieces, false, [], [b[j++]!]);
  }
}

/** The text of chosen sides: for each piece that differs "mine", "theirs", or "both", mine first. */
export function joined(pieces: Piece[], sides: readonly ("mine" | "theirs" | "both")[]): string {
  let number = 0;
  return pieces
    .flatMap((piece) => {
      if (piece.same) return piece.mine;
      const side = sides[number++] ?? "mine";
      return side === "both" ? [...piece.mine, ...piece.theirs] : piece[side];
    })
    .join("\n");
}

/** The smallest stretch that differs: [from, to] of the old text becomes `insert`. */
export function stretch(old: string, now: string): { from: number; to: number; insert: string } | null {
  if (old === now) return null;
  let from = 0;
  while (from < old.length && from < now.length && old[from] === now[from]) from++;
  let end = 0;
  while (end < old.length - from && end < now.length - from && old.at(-1 - end) === now.at(-1 - end)) end++;
  return { from, to: old.length - end, insert: now.slice(from, now.length - end) };
}
