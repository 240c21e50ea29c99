/** Measured CSV files → files of the folder, ticked beside the run that is shown. */
import { signal } from "@preact/signals";
import { ask } from "../connection/http.ts";
import { complain, say } from "../shell/messages.ts";
import { show } from "../shell/panels.ts";
import { ticked } from "../state/selection.ts";
import { chosenMeasured } from "./measuredAs.ts";
import { baseline, shownRun } from "./which.ts";

const ENDINGS = [".csv", ".tsv", ".txt", ".dat", ".asc"];
/** A file is held over the page. */
export const held = signal(false);

export const isMeasured = (name: string): boolean => ENDINGS.some((ending) => name.toLowerCase().endsWith(ending));

/** Compare measured files with the run that is shown, and with nothing else. */
export function compareMeasured(paths: string[]): void {
  const run = shownRun.peek();
  ticked.value = run === null ? paths : [run, ...paths];
  baseline.value = run;
  chosenMeasured.value = paths.at(-1) ?? null;
  show("compare");
}

/** Show how a measured file was measured; one that is not ticked is compared with the run that is shown. */
export function openMeasured(path: string): void {
  if (!ticked.peek().includes(path)) return compareMeasured([path]);
  chosenMeasured.value = path;
  show("compare");
}

/** Keep files in the folder, and compare the run that is shown with them. */
export async function take(files: Iterable<File>): Promise<void> {
  const taken: string[] = [];
  for (const file of files) {
    if (!isMeasured(file.name)) {
      say("warning", `${file.name} is no measurement: a file that ends in ${ENDINGS.join(", ")} is expected.`);
      continue;
    }
    try {
      const { path } = await ask<{ path: string }>("measured", { method: "POST", raw: file, query: { name: file.name } });
      taken.push(path);
    } catch (error) {
      complain(error);
    }
  }
  if (taken.length) compareMeasured(taken);
}

/** Take files that are dropped anywhere on the page. */
export function acceptDrops(): void {
  const carriesFiles = (event: DragEvent) => event.dataTransfer?.types.includes("Files") ?? false;
  addEventListener("dragover", (event) => {
    if (!carriesFiles(event)) return;
    event.preventDefault();
    held.value = true;
  });
  addEventListener("dragleave", (event) => {
    if (event.relatedTarget === null) held.value = false;
  });
  addEventListener("drop", (event) => {
    held.value = false;
    if (!carriesFiles(event)) return;
    event.preventDefault();
    void take(event.dataTransfer?.files ?? []);
  });
}
