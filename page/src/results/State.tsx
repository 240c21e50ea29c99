/** What a panel shows in place of an answer: nothing chosen, waiting, or why there is none. */
import type { ComponentChildren } from "preact";
import type { Complaint } from "../connection/http.ts";
import { below } from "../state/project.ts";

export function Nothing({ children }: { children: ComponentChildren }) {
  return <div class="nothing">{children}</div>;
}

export function Waiting({ what }: { what: string }) {
  return (
    <p class="nothing" role="status">
      Loading {what} …
    </p>
  );
}

/** A complaint of the server: what, where, what was given and expected, and its hint. */
export function Refusal({ complaint, what }: { complaint: Complaint; what: string }) {
  return (
    <div class="nothing" role="alert">
      <p>
        <strong>{what}</strong>
      </p>
      <p>{below(complaint.text)}</p>
    </div>
  );
}
