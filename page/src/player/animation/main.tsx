/** The animation of a report: the studio's player on the motion that the page carries. */
import { render } from "preact";
import { Animation } from "./Animation.tsx";
import { start } from "./start.ts";
import type { Packed } from "./unpack.ts";

const place = document.getElementById("animation");
const data = document.getElementById("animation-data")?.textContent;
if (place && data) {
  start(JSON.parse(data) as Packed);
  render(<Animation />, place);
}
