/** What a tab keeps over a reload of its page: plain values by a name. */

/** The value that was kept; null where there is none, or where its form is not that of this version. */
export function keptInTab<Value>(name: string, isRight: (found: Value) => boolean): Value | null {
  try {
    const found = JSON.parse(sessionStorage.getItem(name) ?? "null") as Value | null;
    return found !== null && isRight(found) ? found : null;
  } catch {
    return null;
  }
}

export function keepInTab(name: string, value: unknown): void {
  try {
    sessionStorage.setItem(name, JSON.stringify(value));
  } catch {
    // A browser that keeps nothing.
  }
}
