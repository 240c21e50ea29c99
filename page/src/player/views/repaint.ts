/** Changes where all canvases must be drawn at once, before the browser goes on: for print. */
import { signal } from "@preact/signals";

export const printing = signal(false);
