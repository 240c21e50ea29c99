/** The study that is being defined, kept over a reload of the page in the same tab: it stands in no file yet. */
import { batch, type Signal } from "@preact/signals";
import { project } from "../state/project.ts";
import { keepInTab, keptInTab } from "../state/tab.ts";
import { aims, expressions, name, outputs, sample, scenario, size, varied, way, withChanges } from "./defining.ts";

const NAME = "arcless.study";
const parts: Record<string, Signal<unknown>> = { scenario, name, varied, way, sample, size, outputs, aims, expressions, withChanges };

type Draft = Record<string, unknown> & { folder: string };

function keep(): void {
  const folder = project.peek()?.folder;
  if (folder === undefined || scenario.peek() === null) return;
  keepInTab(NAME, { folder, ...Object.fromEntries(Object.entries(parts).map(([part, { value }]) => [part, value])) });
}

/** Take back what was kept of this folder, unless a study is being defined already; keep it when the page, or the panel, is left. */
export function followDraft(): () => void {
  // Of another version some part may be missing.
  const draft = keptInTab<Draft>(NAME, (found) => Object.keys(parts).every((part) => part in found));
  if (draft && scenario.peek() === null && draft.folder === project.peek()?.folder) {
    batch(() => Object.entries(parts).forEach(([part, own]) => (own.value = draft[part])));
  }
  addEventListener("pagehide", keep);
  return () => (keep(), removeEventListener("pagehide", keep));
}
