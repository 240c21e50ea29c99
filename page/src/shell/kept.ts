/** What the browser remembers of the window, and no more: sizes in px, what is folded, light or dark. */

const NAME = "arcless.window:";

export function kept<Value>(key: string, otherwise: Value, isRight: (found: unknown) => boolean): Value {
  try {
    const found: unknown = JSON.parse(localStorage.getItem(NAME + key) ?? "null");
    return isRight(found) ? (found as Value) : otherwise;
  } catch {
    return otherwise; // a browser that keeps nothing, or what another version kept
  }
}

export function keep(key: string, value: unknown): void {
  try {
    localStorage.setItem(NAME + key, JSON.stringify(value));
  } catch {
    // It holds as long as the window.
  }
}
