/** Mark of the worst place that somebody went to: a line there, its number and the force. */
import { inWords, wentTo } from "../state/worst.ts";
import { isPlayed, type Pencil } from "./scene.ts";

const TOP = 20; // px, below the numbers of spans
const HEAD = 6; // px, half the width of the triangle at the top

export function drawPlace({ context, camera, colour }: Pencil): void {
  const place = wentTo.value;
  if (!place || !isPlayed.value) return;
  // At a high speed a second is more than what is seen: the edge then tells where the place is.
  const x = camera.x(Math.min(Math.max(place.position_m, camera.x0), camera.x1));
  const way = place.position_m > camera.x1 ? " →" : place.position_m < camera.x0 ? " ←" : "";
  const text = `${inWords(place)}${way}`;
  const isRight = x > camera.width / 2;
  context.save();
  context.strokeStyle = context.fillStyle = colour("not_met");
  context.lineWidth = 1.5;
  if (!way) there(context, x, camera.height);
  context.font = `600 13px ${colour("font-text")}`;
  context.textBaseline = "top";
  context.textAlign = isRight ? "right" : "left";
  const at = x + (isRight ? -HEAD - 4 : HEAD + 4);
  context.strokeStyle = colour("paper");
  context.lineWidth = 4;
  context.lineJoin = "round";
  context.strokeText(text, at, TOP);
  context.fillText(text, at, TOP);
  context.restore();
}

/** A dashed line at the place, and a triangle at its top. */
function there(context: CanvasRenderingContext2D, x: number, height: number): void {
  context.setLineDash([3, 3]);
  context.beginPath();
  context.moveTo(x, TOP);
  context.lineTo(x, height - TOP);
  context.stroke();
  context.setLineDash([]);
  context.beginPath();
  context.moveTo(x - HEAD, TOP);
  context.lineTo(x + HEAD, TOP);
  context.lineTo(x, TOP + 1.5 * HEAD);
  context.fill();
}
