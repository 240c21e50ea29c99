/** Whether the server has another page than this one: Arcless was updated while it was open. */
import { signal } from "@preact/signals";
import { whenOpen } from "./stream.ts";

export const updated = signal(false);

/** The names of built files hold a digest of what is in them: those of another page are other ones. */
const own = () => document.querySelector("script[type=module]")?.getAttribute("src");

/** Look whether the page of the server is this one. */
export async function look(): Promise<boolean> {
  const name = own();
  try {
    const answer = await fetch(new URL(".", document.baseURI), { credentials: "same-origin", cache: "no-store" });
    if (name && answer.ok) updated.value = !(await answer.text()).includes(`"${name}"`);
  } catch {
    // A server that is gone; the banner says it.
  }
  return updated.peek();
}

/** In the words of Chromium and Firefox, of Safari, and of Vite for a style sheet. */
const MISSING = /dynamically imported module|module script failed|Unable to preload CSS/i;

/** Whether something failed because a part of the page could not be fetched. */
export const isMissingPart = (error: unknown): boolean => error instanceof Error && MISSING.test(error.message);

/** Look whenever the server is there again, and where a part of the page is missing. */
export function followVersion(): void {
  let isFirst = true;
  whenOpen(() => {
    if (!isFirst) void look();
    isFirst = false;
  });
  addEventListener("unhandledrejection", (event) => {
    if (!isMissingPart(event.reason)) return;
    event.preventDefault();
    void look();
  });
}
