/** Colour by a value: a scale that is read in print and by the colour-blind, from dark to bright. */

/** After viridis (Smith and van der Walt, 2015; values from memory, C), without its brightest end, which is lost on white. */
const STOPS = [[68, 1, 84], [59, 82, 139], [33, 145, 140], [94, 201, 98], [190, 200, 40]] as const;
/** Steps of the scale: lines of one step are drawn at once. */
export const BUCKETS = 16;

export function bucketOf(value: number | null, [low, high]: readonly [number, number]): number {
  if (value === null) return -1;
  return Math.min(BUCKETS - 1, Math.max(0, Math.floor(((value - low) / (high - low)) * BUCKETS)));
}

export function colourOfBucket(bucket: number): string {
  const at = (bucket / (BUCKETS - 1)) * (STOPS.length - 1);
  const first = Math.min(Math.floor(at), STOPS.length - 2);
  const mixed = [0, 1, 2].map((part) => {
    const [one, other] = [STOPS[first]![part]!, STOPS[first + 1]![part]!];
    return Math.round(one + (at - first) * (other - one));
  });
  return `rgb(${mixed.join(" ")})`;
}
