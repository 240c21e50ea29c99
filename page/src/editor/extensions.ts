/** How YAML is edited: colours, completion, hover, errors. The state belongs to `session`. */
import { autocompletion, closeBrackets, closeBracketsKeymap, completionKeymap } from "@codemirror/autocomplete";
import type { Completion, CompletionContext, CompletionResult } from "@codemirror/autocomplete";
import { defaultKeymap, historyKeymap, indentWithTab } from "@codemirror/commands";
import { yaml } from "@codemirror/lang-yaml";
import { bracketMatching, foldGutter, foldKeymap, HighlightStyle, indentUnit, syntaxHighlighting } from "@codemirror/language";
import { lintGutter, lintKeymap, setDiagnostics, type Diagnostic } from "@codemirror/lint";
import { highlightSelectionMatches, searchKeymap } from "@codemirror/search";
import type { EditorState, Extension, Text } from "@codemirror/state";
import {
  drawSelection, EditorView, highlightActiveLine, highlightActiveLineGutter, hoverTooltip, keymap, lineNumbers, type Tooltip,
} from "@codemirror/view";
import { tags } from "@lezer/highlight";
import { project } from "../state/project.ts";
import { findings, type Finding } from "./checking.ts";
import { inWords, offers } from "./completion.ts";
import { kindOf } from "./documents.ts";
import { rootOf, schemaOf } from "./schema.ts";
import { sourceAt } from "./typedLike.ts";
import { placeAt } from "./yamlPlace.ts";

async function known(state: EditorState, position: number) {
  const content = state.doc.toString();
  const kind = kindOf(content) ?? "line";
  const place = placeAt(content, position);
  if (!place) return null;
  const top = await schemaOf(kind).catch(() => null); // without a server nothing is offered
  return top && { place, top, root: rootOf(top, kind) };
}

const TYPES = { field: "property", word: "enum", model: "constant", unit: "keyword" } as const;

async function complete({ state, pos, explicit }: CompletionContext): Promise<CompletionResult | null> {
  const found = await known(state, pos);
  if (!found) return null;
  const { place, root, top } = found;
  if (!explicit && place.typing === "field" && !place.word) return null;
  const { from, offers: all } = offers(place, root, top, project.peek());
  const options: Completion[] = all.map(({ label, apply, detail, info, kind, rank }) => ({
    label,
    apply,
    detail,
    boost: rank,
    type: TYPES[kind],
    ...(info ? { info } : {}),
  }));
  return options.length ? { from, options, validFor: /^[\w.²³/·*-]*$/ } : null;
}

async function hover(view: EditorView, position: number): Promise<Tooltip | null> {
  const line = view.state.doc.lineAt(position);
  const word = /^[^:]*:?/.exec(view.state.sliceDoc(position, line.to))?.[0] ?? "";
  // On the name of a field: behind its colon stands its value, whose path it is.
  const found = await known(view.state, word.endsWith(":") ? position + word.length : position);
  if (!found) return null;
  const { path } = found.place;
  const words = inWords(found.place, found.root, found.top);
  if (!words.length) return null;
  words.push(...(await sourceAt(view.state.doc.toString(), path)));
  const dom = document.createElement("div");
  dom.className = "cm-about";
  const title = document.createElement("code");
  title.textContent = path.join(".");
  dom.append(title, ...words.map((text) => Object.assign(document.createElement("p"), { textContent: text })));
  return { pos: position, create: () => ({ dom }) };
}

/** Offset of a place counted from 1, inside of the text. */
export function offset(doc: Text, line: number, column: number): number {
  const own = doc.line(Math.min(Math.max(line, 1), doc.lines));
  return Math.min(own.from + Math.max(column - 1, 0), own.to);
}

function diagnostic(doc: Text, level: "error" | "warning", finding: Finding): Diagnostic {
  const from = offset(doc, finding.line ?? 1, finding.column ?? 1);
  const end = finding.end_line ? offset(doc, finding.end_line, finding.end_column ?? 1) : doc.lineAt(from).to;
  return { from, to: Math.max(from, end), severity: level, message: finding.text };
}

/** Show what the last check found. */
export function showFindings(view: EditorView): void {
  const { doc } = view.state;
  const all = findings.peek().map(({ level, finding }) => diagnostic(doc, level, finding));
  view.dispatch(setDiagnostics(view.state, all));
}

const colours = HighlightStyle.define([
  { tag: [tags.propertyName, tags.definition(tags.propertyName)], color: "var(--accent)" },
  { tag: [tags.string, tags.content], color: "var(--ink)" },
  { tag: [tags.comment, tags.lineComment], color: "var(--soft)", fontStyle: "italic" },
  { tag: [tags.punctuation, tags.separator, tags.bracket], color: "var(--soft)" },
]);

const look = EditorView.theme({
  "&": { height: "100%", color: "var(--ink)", backgroundColor: "var(--paper)", fontSize: "var(--size-small)" },
  ".cm-scroller": { fontFamily: "var(--font-code)", lineHeight: "1.5" },
  ".cm-gutters": { backgroundColor: "var(--panel)", color: "var(--soft)", border: "none" },
  ".cm-activeLine, .cm-activeLineGutter": { backgroundColor: "color-mix(in srgb, var(--accent) 8%, transparent)" },
  ".cm-cursor": { borderLeftColor: "var(--ink)" },
  "&.cm-focused": { outline: "none" },
  "& .cm-selectionBackground, &.cm-focused > .cm-scroller > .cm-selectionLayer .cm-selectionBackground": {
    background: "color-mix(in srgb, var(--accent) 25%, transparent)",
  },
  ".cm-tooltip": { backgroundColor: "var(--panel)", color: "var(--ink)", border: "1px solid var(--rule)", maxWidth: "420px" },
  ".cm-tooltip-autocomplete ul li[aria-selected]": { backgroundColor: "var(--accent)", color: "var(--paper)" },
  ".cm-completionDetail": { color: "var(--soft)" },
  "li[aria-selected] .cm-completionDetail": { color: "inherit" },
  ".cm-about": { padding: "6px 8px", fontFamily: "var(--font-text)" },
  ".cm-about p": { margin: "2px 0" },
  ".cm-panels": { backgroundColor: "var(--panel)", color: "var(--ink)" },
  ".cm-diagnostic": { whiteSpace: "pre-wrap" },
  ".cm-searchMatch": { backgroundColor: "var(--open-fill)" },
});

export const extensions: Extension = [
  lineNumbers(),
  highlightActiveLineGutter(),
  highlightActiveLine(),
  foldGutter(),
  lintGutter(),
  drawSelection(),
  bracketMatching(),
  closeBrackets(),
  highlightSelectionMatches(),
  indentUnit.of("  "),
  yaml(),
  syntaxHighlighting(colours),
  autocompletion({ override: [complete], icons: false }),
  hoverTooltip(hover),
  EditorView.contentAttributes.of({
    "aria-label": "Text of the model file",
    "aria-description": "Control and space offers what may stand here; Escape, then Tab, leaves the text",
  }),
  EditorView.lineWrapping,
  look,
  keymap.of([
    ...closeBracketsKeymap, ...defaultKeymap, ...searchKeymap, ...historyKeymap, ...foldKeymap, ...completionKeymap,
    ...lintKeymap, indentWithTab,
  ]),
];
