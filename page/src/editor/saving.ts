/** Texts to and from the disk: saved a moment after the last change, conflicts shown. */
import { batch } from "@preact/signals";
import { ask, RefusedError } from "../connection/http.ts";
import { hear, whenOpen } from "../connection/stream.ts";
import { complain } from "../shell/messages.ts";
import { beforeRun } from "../state/pending.ts";
import { project } from "../state/project.ts";
import { conflict, opened, saving, text, type FileAnswer } from "./documents.ts";
import { draftOf, keepDraft } from "./drafts.ts";

/** After the last change, in ms: shorter, and each key is a file; longer, and a run takes an old one. */
export const SAVE_AFTER = 400;

let timer: ReturnType<typeof setTimeout> | undefined;
/** Puts another text in the place of the one that is edited, as a change that can be undone. */
let replace: (content: string) => void = (content) => (text.value = content);
const folder = () => project.peek()?.folder ?? "";

export function replaceBy(act: typeof replace): void {
  replace = act;
}

/** A file from the disk becomes the one that is edited; a draft of it that was not saved goes on. */
export async function read(path: string): Promise<{ answer: FileAnswer; content: string }> {
  const answer = await ask<FileAnswer>("file", { query: { path } });
  const draft = answer.writable ? draftOf(folder(), path) : null;
  return { answer, content: draft && draft.text !== answer.text ? draft.text : answer.text };
}

/** After `read`: what is known of the disk; a draft of an older version is a conflict. */
export function begin(answer: FileAnswer, content: string): void {
  const { path, writable, version } = answer;
  batch(() => {
    opened.value = { path, writable, saved: { text: answer.text, version } };
    text.value = content;
    saving.value = "saved";
    conflict.value = null;
  });
  if (content === answer.text) return;
  if (draftOf(folder(), path)?.version === version) changed();
  else collide(path, content, answer);
}

function collide(path: string, mine: string, theirs: { text: string; version: string } | null): void {
  saving.value = "conflict";
  conflict.value = { path, mine, theirs: theirs && { text: theirs.text, version: theirs.version } };
}

/** The text was changed: keep it at once, and save it soon. */
export function changed(): void {
  const document = opened.peek();
  if (!document?.writable) return;
  if (text.peek() === document.saved.text && saving.peek() !== "conflict") {
    keepDraft(folder(), document.path, null);
    clearTimeout(timer);
    if (saving.peek() !== "saving") saving.value = "saved";
    return;
  }
  keepDraft(folder(), document.path, { text: text.peek(), version: document.saved.version });
  if (saving.peek() === "conflict") return;
  saving.value = "waiting";
  clearTimeout(timer);
  timer = setTimeout(() => void save(), SAVE_AFTER);
}

let current: Promise<void> = Promise.resolve();

/** Save now, after what is being saved; done when the text is on the disk, or it is said why not. */
export function save(): Promise<void> {
  clearTimeout(timer);
  current = current.then(put);
  return current;
}

beforeRun(save);

async function put(): Promise<void> {
  const document = opened.peek();
  const content = text.peek();
  if (!document?.writable || content === document.saved.text || conflict.peek()) return;
  const { path } = document;
  saving.value = "saving";
  try {
    const body = { path, text: content, version: document.saved.version };
    const { version } = await ask<{ version: string }>("file", { method: "PUT", body });
    if (opened.peek()?.path === path) {
      opened.value = { ...opened.peek()!, saved: { text: content, version } };
      saving.value = "saved";
      changed(); // what was typed meanwhile
    } else keepDraft(folder(), path, null);
  } catch (error) {
    if (opened.peek()?.path !== path) return;
    if (error instanceof RefusedError && error.status === 409) {
      const { current: theirs } = error.answer as { current?: { text: string; version: string } | null };
      collide(path, text.peek(), theirs ?? null);
    } else {
      saving.value = "not saved";
      if (error instanceof RefusedError) complain(error); // without a server the banner says it
    }
  }
}

/** End a conflict with a text: it replaces what is on the disk. */
export function settle(content: string): void {
  const [found, document] = [conflict.peek(), opened.peek()];
  if (!found || document?.path !== found.path) return;
  const { theirs } = found;
  opened.value = { ...document, saved: { text: theirs?.text ?? "", version: theirs?.version ?? null } };
  conflict.value = null;
  saving.value = "waiting";
  replace(content);
  if (content === theirs?.text) {
    saving.value = "saved";
    keepDraft(folder(), found.path, null);
  } else void save();
}

/** A file was written, by whoever it was. */
async function written(path: string): Promise<void> {
  await current;
  const document = opened.peek();
  if (document?.path !== path) return;
  let disk: FileAnswer | null;
  try {
    disk = await ask<FileAnswer>("file", { query: { path } });
  } catch (error) {
    if (!(error instanceof RefusedError)) return;
    disk = null;
  }
  const now = opened.peek();
  if (now?.path !== path || disk?.version === now.saved.version) return;
  if (!disk || (text.peek() !== now.saved.text && text.peek() !== disk.text)) {
    collide(path, text.peek(), disk);
    return;
  }
  opened.value = { ...now, saved: { text: disk.text, version: disk.version } };
  if (text.peek() !== disk.text) replace(disk.text);
  changed();
}

/** Follow the disk, and save what waits when the server is there again. */
export function followFiles(): void {
  hear("file", ({ path }) => void written(String(path)));
  whenOpen(() => {
    const document = opened.peek();
    if (!document) return;
    void written(document.path).then(() => (saving.peek() === "not saved" ? save() : undefined));
  });
}
