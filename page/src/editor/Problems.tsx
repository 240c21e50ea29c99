/** Errors and warnings of the file: each leads to its place. */
import { selected } from "../state/selection.ts";
import { findings, type Finding } from "./checking.ts";
import { text, writable } from "./documents.ts";

function go(finding: Finding): void {
  if (finding.field) selected.value = { kind: "field", field: finding.field.join(".") };
}

export function Problems() {
  if (!text.value) return null;
  if (!findings.value.length) return <p class="problems none">{writable.value ? "No errors, no warnings." : ""}</p>;
  return (
    <ul class="problems" aria-label="Errors and warnings">
      {findings.value.map(({ level, finding }, number) => (
        <li key={number} class={level}>
          <strong>{level === "error" ? "Error" : "Warning"}</strong> {finding.text}
          {finding.field && (
            <button onClick={() => go(finding)}>{finding.line ? `Line ${finding.line}` : "Show the field"}</button>
          )}
        </li>
      ))}
    </ul>
  );
}
