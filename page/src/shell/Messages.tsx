/** What the user is told: errors and warnings stay until they are dismissed, notes for a while. */
import { useEffect } from "preact/hooks";
import { dismiss, messages, type Told } from "./messages.ts";
import { listed } from "./window.ts";

// In ms: long enough to read two lines, short enough not to cover the view for long.
const NOTE = 8000;
const MOST = 3; // newest ones over the view; the others are in the list
const WORDS: Record<Told["level"], [string, string]> = { error: ["✖", "Error"], warning: ["▲", "Warning"], note: ["ℹ", "Note"] };

function One({ told }: { told: Told }) {
  const [sign, word] = WORDS[told.level];
  useEffect(() => {
    if (told.level !== "note") return;
    const timer = setTimeout(() => dismiss(told.id), NOTE);
    return () => clearTimeout(timer);
  }, [told.id]);
  return (
    <li class={told.level}>
      <span class="sign" aria-hidden="true">{sign}</span>
      <p>
        <span class="unseen">{word}: </span>
        {told.text}
        {told.action && (
          <button class="plain" onClick={() => (dismiss(told.id), told.action!.act())}>
            {told.action.label}
          </button>
        )}
      </p>
      <button class="quiet" aria-label="Dismiss" onClick={() => dismiss(told.id)}>
        ×
      </button>
    </li>
  );
}

export function Messages() {
  const all = messages.value;
  const shown = listed.value ? all : all.slice(-MOST);
  return (
    <div class="messages" role="log" aria-label="Messages">
      {listed.value && (
        <p class="head">
          <strong>Messages</strong>
          <span>{all.length === 0 ? "There is nothing to tell." : `${all.length}`}</span>
          {all.length > 0 && <button class="quiet" onClick={() => (messages.value = [])}>Dismiss all</button>}
          <button class="quiet" aria-label="Close the list" onClick={() => (listed.value = false)}>×</button>
        </p>
      )}
      <ul>
        {shown.map((told) => (
          <One key={told.id} told={told} />
        ))}
      </ul>
    </div>
  );
}
