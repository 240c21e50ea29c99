/** What was typed and is not saved yet, kept in the browser: a server that is gone loses nothing. */

export interface Draft {
  text: string;
  /** Of the file that was changed. */
  version: string | null;
}

const NAME = "arcless.draft:";

/** Keep a draft of a file of a folder; null: nothing is unsaved any more. */
export function keepDraft(folder: string, path: string, draft: Draft | null): void {
  try {
    if (draft) localStorage.setItem(`${NAME}${folder}:${path}`, JSON.stringify(draft));
    else localStorage.removeItem(`${NAME}${folder}:${path}`);
  } catch {
    // A browser that keeps nothing, or is full: the text is still in the window.
  }
}

export function draftOf(folder: string, path: string): Draft | null {
  try {
    const found: unknown = JSON.parse(localStorage.getItem(`${NAME}${folder}:${path}`) ?? "null");
    const draft = found as Draft | null;
    return typeof draft?.text === "string" ? draft : null;
  } catch {
    return null;
  }
}
