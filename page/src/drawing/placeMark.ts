/** Mark of the worst place that somebody went to: a line there, its number and the force. */
import { inWords, wentTo } from "../state/worst.ts";
import { isPlayed, type Pencil } from "./scene.ts";

const TOP = 20; // px, below the numbers of spans
const HEAD = 6; // px, half the width of the triangle at the top

export function drawPlace({ context, camera, colour }: Pencil): void {
  const place = wentTo.value;
  if (!place || !isPlayed.value || !(place.position_m >= camera.x0 && place.position_m <= camera.x1)) return;
  const x = camera.x(place.position_m);
  const isRight = x > camera.width / 2;
  context.save();
  context.strokeStyle = context.fillStyle = colour("not_met");
  context.lineWidth = 1.5;
  context.setLineDash([3, 3]);
  context.beginPath();
  context.moveTo(x, TOP);
  context.lineTo(x, camera.height - TOP);
  context.stroke();
  context.setLineDash([]);
  context.beginPath();
  context.moveTo(x - HEAD, TOP);
  context.lineTo(x + HEAD, TOP);
  context.lineTo(x, TOP + 1.5 * HEAD);
  context.fill();
  context.font = `600 13px ${colour("font-text")}`;
  context.textBaseline = "top";
  context.textAlign = isRight ? "right" : "left";
  const at = x + (isRight ? -HEAD - 4 : HEAD + 4);
  context.strokeStyle = colour("paper");
  context.lineWidth = 4;
  context.lineJoin = "round";
  context.strokeText(inWords(place), at, TOP);
  context.fillText(inWords(place), at, TOP);
  context.restore();
}
