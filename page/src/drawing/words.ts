/** What stands at a position of the line, in words and numbers with units. */
import type { Geometry } from "./geometry.ts";
import { valueAt, type LineIndex } from "./lineIndex.ts";
import { forceOf } from "./linePainter.ts";
import { spanAt, type Picked } from "./pick.ts";
import type { Moved } from "./scene.ts";

const metres = (value: number, digits = 3) => `${value.toFixed(digits)} m`;

/** A position: its span, the heights of the contact wires and of what they hang from, each by its name. */
export function placeInWords(geometry: Geometry, line: LineIndex, x: number): string {
  const span = spanAt(geometry, x);
  const parts = [span ? `span ${span.number}` : "beyond the line", metres(x, 2)];
  for (const kind of ["contact", "messenger"]) {
    for (const wire of line.wires) {
      const height = wire.kind === kind ? valueAt(wire, "z", x) : null;
      if (height === null) continue;
      parts.push(`${wire.name} ${metres(height)}`);
      if (kind === "contact" && geometry.spatial) parts.push(`lateral ${metres(valueAt(wire, "y", x) ?? 0)}`);
    }
  }
  return parts.join(" · ");
}

/** A dropper, support or span that was picked. Numbers of a draft are not told. */
export function pickedInWords(geometry: Geometry, picked: Picked, now: Moved | null, isDraft: boolean): string {
  if (picked.kind === "span") {
    const span = geometry.spans.find((one) => one.number === picked.number);
    return span ? `span ${span.number}: ${metres(span.end_m - span.start_m, 2)} long` : "";
  }
  if (picked.kind === "support") {
    const support = geometry.supports[picked.index];
    if (!support) return "";
    const stagger = geometry.spatial ? `, stagger ${metres(support.stagger_m)}` : "";
    return `${support.name} at ${metres(support.x_m, 2)}${stagger}`;
  }
  const dropper = geometry.droppers[picked.index];
  if (!dropper) return "";
  const force = forceOf(dropper, picked.index, now);
  const at = `${dropper.name} at ${metres(dropper.x_m, 2)}`;
  if (isDraft) return at;
  const told = force === null ? "" : force === 0 ? ", slack" : `, ${force.toFixed(1)} N`;
  return `${at}: ${metres(dropper.length_m)} between clamps${told}`;
}

/** The whole drawing, for those who cannot see it. */
export function drawingInWords(geometry: Geometry, line: LineIndex): string {
  const slack = geometry.droppers.filter((dropper) => dropper.force_N === 0).length;
  const droppers = `${geometry.droppers.length} droppers${slack ? `, ${slack} of them slack at rest` : ""}`;
  const [low, high] = line.z;
  return (
    `Line ${geometry.name} with ${geometry.spans.length} spans and ${droppers}; ` +
    `wires between ${metres(low, 2)} and ${metres(high, 2)} above rail`
  );
}
