/** What other rooms ask of studies: a field to vary, a study to show. Loaded with the page; small. */
import { signal } from "@preact/signals";
import { show } from "../shell/panels.ts";

/** Dotted path of a field that shall be varied, until the list of fields is there. */
export const wanted = signal<string | null>(null);
/** Which half of the panel is seen. */
export const face = signal<"define" | "watch">("define");

const PANTOGRAPH = /^pantographs\.\d+\.model\./;

/** Whether a field of a scenario is the one that is asked for: by its own path, that in a variant, in the line, or in the pantograph. */
export const isAsked = (field: string, asked: string): boolean =>
  field === asked || `set.${field}` === asked || field === `line.${asked}` || (PANTOGRAPH.test(field) && field.replace(PANTOGRAPH, "") === asked);

/** Vary a field of the scenario, by its path in the scenario, or in its line or pantograph. */
export function varyField(field: string): void {
  wanted.value = field;
  face.value = "define";
  show("studies");
}

/** Folder of a study that shall be shown, until the panel is there. */
export const opening = signal<string | null>(null);

/** Show a study that was begun, by its folder below that of the project. */
export function showStudy(path: string): void {
  opening.value = path;
  face.value = "watch";
  show("studies");
}
