/** Fields of the file changed by the server: comments, order and units as typed stay. */
import { ask } from "../connection/http.ts";
import { say } from "../shell/messages.ts";
import { beforeRun } from "../state/pending.ts";
import { opened, text } from "./documents.ts";
import { save } from "./saving.ts";

/** A value as typed; null takes the field away. */
export type Value = string | number | boolean | null | Value[] | { [key: string]: Value };

let turn: Promise<unknown> = Promise.resolve();

/** Change fields by dotted path, after the changes before it; a refusal is a `RefusedError`. */
export function patch(changes: Record<string, Value>): Promise<void> {
  const mine = turn.then(() => change(changes));
  turn = mine.catch(() => undefined);
  return mine;
}

beforeRun(() => turn.then(save));

async function change(changes: Record<string, Value>): Promise<void> {
  const document = opened.peek();
  if (!document) return;
  if (!document.writable) {
    say("warning", "A shipped model cannot be changed. Copy it to your folder first.");
    return;
  }
  const { apply } = await import("./session.ts");
  const before = text.peek();
  const answer = await ask<{ text: string }>("patch", { body: { path: document.path, text: before, changes } });
  if (opened.peek()?.path !== document.path) return;
  // Typed meanwhile: the fields are changed in what is there now.
  if (text.peek() !== before) await change(changes);
  else apply(answer.text);
}
