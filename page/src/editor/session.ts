/** States of CodeMirror, one for each file: text, undo history and selection outlive the view. */
import { history, isolateHistory, redo as redoState, undo as undoState } from "@codemirror/commands";
import { EditorState, type TransactionSpec } from "@codemirror/state";
import { EditorView } from "@codemirror/view";
import { complain } from "../shell/messages.ts";
import { file } from "../state/selection.ts";
import { opened, text } from "./documents.ts";
import { stretch } from "./diff.ts";
import { begin, changed, read, replaceBy, save } from "./saving.ts";
import { extensions } from "./extensions.ts";

const states = new Map<string, EditorState>();
let view: EditorView | null = null;

const stateOf = (path: string) => states.get(path);

function created(path: string, content: string, writable: boolean): EditorState {
  const state = EditorState.create({
    doc: content,
    extensions: [
      history(),
      EditorState.readOnly.of(!writable),
      EditorView.updateListener.of((update) => follow(path, update.state)),
      extensions,
    ],
  });
  states.set(path, state);
  return state;
}

/** Open the file that is selected; the one before is saved, and its history kept. */
export async function open(path: string): Promise<void> {
  if (opened.peek()?.path === path) return;
  await save();
  try {
    const { answer, content } = await read(path);
    if (file.peek() !== path) return;
    const state = stateOf(path) ?? created(path, content, answer.writable);
    view?.setState(state);
    begin(answer, content);
    // Changed on the disk since it was open here: one more change, which can be undone.
    if (state.doc.toString() !== content) apply(content);
  } catch (error) {
    if (file.peek() === path) complain(error);
  }
}

function dispatch(spec: TransactionSpec): void {
  const path = opened.peek()?.path;
  const state = path === undefined ? undefined : stateOf(path);
  if (path === undefined || !state) return;
  if (view) view.dispatch(spec);
  else follow(path, state.update(spec).state);
}

/** Take the state that the view has now. */
export function follow(path: string, state: EditorState): void {
  states.set(path, state);
  const content = state.doc.toString();
  if (content === text.peek() || path !== opened.peek()?.path) return;
  text.value = content;
  changed();
}

/** Replace the text by another one; only the stretch that differs is a change, which can be undone. */
export function apply(content: string): void {
  const path = opened.peek()?.path;
  const state = path === undefined ? undefined : stateOf(path);
  const change = state && stretch(state.doc.toString(), content);
  if (change) dispatch({ changes: change, annotations: isolateHistory.of("full") });
}

export function undo(): void {
  step(undoState);
}

export function redo(): void {
  step(redoState);
}

function step(command: typeof undoState): void {
  const path = opened.peek()?.path;
  const state = path === undefined ? undefined : stateOf(path);
  if (path === undefined || !state) return;
  command({ state, dispatch: (transaction) => (view ? view.dispatch(transaction) : follow(path, transaction.state)) });
}

/** The view that shows the file; null: none does. */
export function attach(mounted: EditorView | null): EditorState | null {
  view = mounted;
  const path = opened.peek()?.path;
  return path === undefined ? null : (stateOf(path) ?? null);
}

export function currentView(): EditorView | null {
  return view;
}

replaceBy(apply);
