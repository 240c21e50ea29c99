/** Over the window: the server is gone, or it was started anew and does not know this browser. */
import { signal } from "@preact/signals";
import { connection } from "../connection/stream.ts";
import { updated } from "../connection/version.ts";

/** The server answers, but refuses: its cookie is another one. */
export const refused = signal(false);

// In ms; a page that waits behind a closed laptop for a night should not make a machine warm.
const ASK_EVERY = 2000;

let isAsking = false;

async function ask(): Promise<void> {
  // A server that is stopped answers all that waits once it goes on: one question is enough.
  if (isAsking) return;
  isAsking = true;
  try {
    refused.value = (await fetch("api/jobs", { credentials: "same-origin" })).status === 403;
  } catch {
    refused.value = false;
  } finally {
    isAsking = false;
  }
}

/** While there is no connection, find out why. */
export function followServer(): void {
  let timer: ReturnType<typeof setInterval> | undefined;
  connection.subscribe((state) => {
    clearInterval(timer);
    if (state !== "lost") return void (refused.value = false);
    timer = setInterval(() => void ask(), ASK_EVERY);
    void ask();
  });
}

export function Banner() {
  if (connection.value !== "lost") return updated.value ? <Updated /> : null;
  return (
    <p class="lost" role="alert">
      <span class="sign" aria-hidden="true">▲</span>
      {refused.value
        ? "The server was started anew. Open the address that it printed, in this browser; this page then goes on. Nothing that you typed is lost."
        : "The server does not answer. Nothing that you typed is lost; the page tries again by itself."}
    </p>
  );
}

function Updated() {
  return (
    <p class="lost" role="alert">
      <span class="sign" aria-hidden="true">▲</span>
      Arcless was updated. Reload the page to go on; what you typed in files, and for the next run, is kept.{" "}
      <button onClick={() => location.reload()}>Reload the page</button>
    </p>
  );
}
