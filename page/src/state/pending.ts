/** What is typed and not yet on the disk: a run reads the disk, and waits for it. */

const acts: (() => Promise<unknown>)[] = [];

/** Have something done before each run. */
export function beforeRun(act: () => Promise<unknown>): void {
  acts.push(act);
}

/** What is typed counts as entered, and all that was to be done before a run is done. */
export async function settled(): Promise<void> {
  // A field tells its change when it is left; a key that runs does not leave it.
  const field = document.activeElement;
  if (field instanceof HTMLInputElement) field.blur();
  for (const act of acts) await act();
}
