/**
 * Verdict of the run that is shown, and the criterion behind it with value and limit: the one that is
 * missed worst, else one that is too close to tell; σ where all are met. It names the run, and says
 * where that is not what the run bar would run now.
 */
import { useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { ask } from "../connection/http.ts";
import { changes } from "../state/changes.ts";
import { project } from "../state/project.ts";
import { scenario } from "../state/selection.ts";
import type { Assessed } from "../results/told.ts";
import { entryOf, shownRun, versionOf } from "../results/which.ts";
import { show } from "../shell/panels.ts";
import { markOf, runWords } from "./standing.ts";
import { leadingWords, verdictOf } from "./words.ts";

const STATES = { met: "met", missed: "not-met", open: "open" } as const;

/** Whether the run would be computed the same now; null where that is not known. */
function useCurrent(run: string | null, version: string): boolean | null {
  const found = useSignal<boolean | null>(null);
  const [chosen, changed, view] = [scenario.value, changes.value, project.value];
  useEffect(() => void (found.value = null), [run, version, chosen, changed]);
  useEffect(() => {
    if (run === null || chosen === null) return;
    const controller = new AbortController();
    const body = { run, scenario: chosen, changes: changed };
    // Of a scenario that is wrong the tree and the editor say so.
    ask<{ current: boolean }>("run/current", { body, signal: controller.signal }).then(
      ({ current }) => (found.value = current),
      () => undefined,
    );
    return () => controller.abort();
  }, [run, version, chosen, changed, view]);
  return found.value;
}

export function Verdict() {
  const run = shownRun.value;
  const version = run === null ? "" : versionOf([run]);
  const assessed = useSignal<Assessed | null>(null);
  useEffect(() => {
    assessed.value = null;
    if (run === null) return;
    const controller = new AbortController();
    // A run that cannot be read says so in its panel.
    ask<Assessed>("assessed", { query: { run }, signal: controller.signal }).then(
      (found) => (assessed.value = found),
      () => undefined,
    );
    return () => controller.abort();
  }, [run, version]);
  const isCurrent = useCurrent(run, version);
  const entry = entryOf(run);
  if (run === null || !entry) return null;
  const told = assessed.value;
  const { sign, word, state } = verdictOf(entry.verdict);
  const lead = told?.leading && leadingWords(told.leading, told.criteria, told.pantographs.length > 1);
  const view = project.value;
  // Of one that was just written the name is not known yet.
  const chosen = [...(view?.models ?? []), ...(view?.library ?? [])].find(({ path }) => path === scenario.value)?.name ?? null;
  const mark = markOf(entry, chosen, changes.value, isCurrent);
  const name = runWords(entry);
  return (
    <button
      class={`verdict-of ${told ? STATES[told.verdict.state] : state} ${mark && "pale"}`}
      title={`${name}${mark && `: ${mark}`}\n${told?.verdict.text ?? ""}`}
      onClick={() => show("results")}
    >
      {mark && <em class="mark">{mark}</em>}
      <span class="of">{name}</span>
      <span class="sign" aria-hidden="true">{told?.verdict.sign ?? sign}</span>
      <strong>{lead && entry.verdict !== "stopped early" ? lead.verdict : word}</strong>
      {lead && (
        <>
          <span class={lead.isSign ? "criterion sign" : "criterion"}>{lead.title}</span>
          <span class="numbers">
            {lead.value} {lead.limit && !mark && <span class="soft">(limit {lead.limit})</span>}
          </span>
          {lead.more > 0 && <span class="more soft">and {lead.more} more</span>}
        </>
      )}
      {told?.other_version && <span class="soft">computed by Arcless {told.version}</span>}
    </button>
  );
}
