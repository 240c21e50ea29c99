/** The text of the model file. CodeMirror lives in a shadow tree: there its styles need no leave. */
import { EditorView } from "@codemirror/view";
import { effect } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { selectedField } from "../drawing/scene.ts";
import { selected } from "../state/selection.ts";
import { checked, fieldAt, findings, placeOf } from "./checking.ts";
import { opened } from "./documents.ts";
import { offset, showFindings } from "./extensions.ts";
import { attach } from "./session.ts";

/** Put the cursor on a field, and show it. */
function jump(view: EditorView, field: string): void {
  const place = placeOf(field, checked.peek()?.found.fields ?? {});
  if (!place) return;
  const at = offset(view.state.doc, place.line, place.column);
  if (view.state.doc.lineAt(view.state.selection.main.head).number === view.state.doc.lineAt(at).number) return;
  view.dispatch({ selection: { anchor: at }, effects: EditorView.scrollIntoView(at, { y: "center" }) });
}

/** The field under the cursor becomes the one that is selected. */
function look(view: EditorView): void {
  const { doc, selection } = view.state;
  const line = doc.lineAt(selection.main.head);
  const field = fieldAt(line.number, selection.main.head - line.from + 1, checked.peek()?.found.fields ?? {});
  const now = selected.peek();
  if (field && !(now?.kind === "field" && now.field === field)) selected.value = { kind: "field", field };
}

export function YamlView() {
  const place = useRef<HTMLDivElement>(null);
  const path = opened.value?.path;
  useEffect(() => {
    const host = place.current;
    if (!host || path === undefined) return;
    const root = host.shadowRoot ?? host.attachShadow({ mode: "open" });
    const state = attach(null);
    if (!state) return;
    const view = new EditorView({ state, parent: root, root });
    attach(view);
    view.scrollDOM.tabIndex = 0; // long texts are scrolled by keys, read-only ones too
    const follow = () => view.hasFocus && look(view);
    root.addEventListener("keyup", follow);
    root.addEventListener("pointerup", follow);
    // Errors come and go below it: what is typed stays in sight.
    const sized = new ResizeObserver(() => {
      const { head } = view.state.selection.main;
      if (view.hasFocus) view.dispatch({ effects: EditorView.scrollIntoView(head, { y: "nearest", yMargin: 40 }) });
    });
    sized.observe(host);
    // From outside a shadow tree looks like no field: what is typed there is no command.
    const typed = (event: KeyboardEvent) => {
      if (event.defaultPrevented || !(event.ctrlKey || event.metaKey || event.altKey)) event.stopPropagation();
    };
    host.addEventListener("keydown", typed);
    const ends = [
      effect(() => {
        void findings.value;
        queueMicrotask(() => showFindings(view));
      }),
      effect(() => {
        const field = selectedField.value;
        void checked.value;
        if (field !== null && !view.hasFocus) queueMicrotask(() => jump(view, field));
      }),
    ];
    return () => {
      for (const end of ends) end();
      sized.disconnect();
      host.removeEventListener("keydown", typed);
      root.removeEventListener("keyup", follow);
      root.removeEventListener("pointerup", follow);
      attach(null);
      view.destroy();
    };
  }, [path]);
  return <div class="yaml" ref={place} />;
}
