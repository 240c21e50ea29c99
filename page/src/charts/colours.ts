/** Colours by their meaning, as the tokens of reports name them, in the scheme that is shown. */
import { signal } from "@preact/signals";

/** Counts changes of the scheme: what is drawn on a canvas is drawn anew. */
export const scheme = signal(0);

const known = new Map<string, string>();

function changed(): void {
  known.clear();
  scheme.value = scheme.peek() + 1;
}

/** Follow the system and the choice of the user. */
export function followScheme(): void {
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", changed);
  new MutationObserver(changed).observe(document.documentElement, { attributeFilter: ["data-scheme"] });
}

/** The colour of a token: `contact_wire` is `--contact-wire`. */
export function colour(token: string): string {
  let found = known.get(token);
  if (found === undefined) {
    const name = `--${token.replaceAll("_", "-")}`;
    found = getComputedStyle(document.documentElement).getPropertyValue(name).trim() || "#808080";
    known.set(token, found);
  }
  return found;
}

type Channels = [number, number, number];

const channels = (text: string): Channels =>
  [1, 3, 5].map((place) => Number.parseInt(text.slice(place, place + 2), 16)) as Channels;

/** So many shades between the colours of an order, as bytes red, green, blue, opaque. */
export function shades(order: string[], count = 256): Uint32Array {
  const given = order.map(channels);
  const bytes = new Uint8ClampedArray(4 * count);
  for (let place = 0; place < count; place++) {
    const along = (place / (count - 1)) * (given.length - 1);
    const left = Math.min(Math.floor(along), given.length - 2);
    const [a, b] = [given[left]!, given[left + 1]!];
    for (let k = 0; k < 3; k++) bytes[4 * place + k] = Math.round(a[k]! + (along - left) * (b[k]! - a[k]!));
    bytes[4 * place + 3] = 255;
  }
  return new Uint32Array(bytes.buffer);
}

/** A colour `#rrggbb` as the four bytes of a pixel. */
export function pixel(text: string): number {
  return new Uint32Array(new Uint8Array([...channels(text), 255]).buffer)[0]!;
}
