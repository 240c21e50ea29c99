/** Mark of a run that failed: a line where each pantograph was. Positions in m. */
import { failure } from "../state/failure.ts";
import type { Pencil } from "./scene.ts";

const TOP = 20; // px, of the line and of its words
const LINE = 16; // px, of two words below one another: pantographs may be nearer than words are long

export function drawFailed({ context, camera, colour }: Pencil): void {
  Object.entries(failure.value?.positions_m ?? {}).forEach(([name, position], number) => {
    if (!(position >= camera.x0 && position <= camera.x1)) return;
    const x = camera.x(position);
    const isRight = x > camera.width / 2;
    context.save();
    context.strokeStyle = context.fillStyle = colour("limit");
    context.lineWidth = 2;
    context.setLineDash([6, 4]);
    context.beginPath();
    context.moveTo(x, TOP);
    context.lineTo(x, camera.height - TOP);
    context.stroke();
    context.font = `600 13px ${colour("font-text")}`;
    context.textBaseline = "top";
    context.textAlign = isRight ? "right" : "left";
    context.fillText(`✖ ${name} when the run failed`, x + (isRight ? -6 : 6), TOP + 2 + LINE * number);
    context.restore();
  });
}
