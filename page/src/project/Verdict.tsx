/** Verdict of the run that is shown: met, not met or too close to tell, and σ with its certainty and limit. */
import { useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { ask } from "../connection/http.ts";
import type { Assessed } from "../results/told.ts";
import { entryOf, shownRun, versionOf } from "../results/which.ts";
import { show } from "../shell/panels.ts";
import { verdictOf } from "./words.ts";

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
  const entry = entryOf(run);
  if (run === null || !entry) return null;
  const told = assessed.value;
  const { sign, word, state } = verdictOf(entry.verdict);
  const states = { met: "met", missed: "not-met", open: "open" } as const;
  const spread = told?.criteria.filter((one) => one.title.startsWith("standard deviation"));
  const worst = spread?.find((one) => one.pantograph === entry.worst) ?? spread?.[0];
  return (
    <button class={`verdict-of ${told ? states[told.verdict.state] : state}`} title={told?.verdict.text ?? ""} onClick={() => show("results")}>
      <span class="sign" aria-hidden="true">{told?.verdict.sign ?? sign}</span>
      <strong>{told && told.verdict.state === "open" && entry.verdict !== "not judged" ? "too close to tell" : word}</strong>
      {worst && (
        <span class="numbers">
          σ {worst.value} N{worst.limit && <span class="soft"> (limit {worst.limit.replace(/^[≤≥]\s*/, "")})</span>}
        </span>
      )}
      {told?.other_version && <span class="soft">computed by Arcless {told.version}</span>}
    </button>
  );
}
