/** An answer of the server as a component needs it: waiting, there, or refused. */
import { useSignal, type Signal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { RefusedError, type Complaint } from "../connection/http.ts";

export interface Answer<Value> {
  value: Value | null;
  waiting: boolean;
  complaint: Complaint | null;
}

/**
 * Ask when something changes; an answer to an old question is dropped.
 *
 * @param key what the question is about; null: there is none to ask
 */
export function useAnswer<Value>(key: string | null, ask: (signal: AbortSignal) => Promise<Value>): Signal<Answer<Value>> {
  const found = useSignal<Answer<Value>>({ value: null, waiting: key !== null, complaint: null });
  useEffect(() => {
    if (key === null) {
      found.value = { value: null, waiting: false, complaint: null };
      return;
    }
    const stop = new AbortController();
    found.value = { value: null, waiting: true, complaint: null };
    ask(stop.signal).then(
      (value) => !stop.signal.aborted && (found.value = { value, waiting: false, complaint: null }),
      (error: unknown) => {
        if (stop.signal.aborted) return;
        const complaint = error instanceof RefusedError ? error.complaint : { text: "The server did not answer." };
        found.value = { value: null, waiting: false, complaint };
      },
    );
    return () => stop.abort();
  }, [key]);
  return found;
}
