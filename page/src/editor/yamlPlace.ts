/**
 * Where a position of a YAML text is: the path that leads to it, and whether a field or a value is
 * typed there. Works on text that is no YAML yet, as it is while somebody types.
 */

export interface YamlPlace {
  /** Path of the mapping, list or value that is typed in. */
  path: (string | number)[];
  /** A field is typed (its name), or a value (of the field that ends the path). */
  typing: "field" | "value";
  /** What stands from `from` to the position. */
  word: string;
  from: number;
  /** Fields that the mapping has in the text. */
  siblings: string[];
}

const KEY = /^(\s*)((?:-\s+)*)(?:"([^"]*)"|'([^']*)'|([^\s#:,[\]{}"'-][^#:,[\]{}]*?))\s*:(?:\s|$)/;
const ITEM = /^(\s*)((?:-\s+)+|-\s*$)/;

interface Row {
  indent: number;
  /** Items that begin in this row: their indents. */
  items: number[];
  key: string | null;
  /** Column behind the colon. */
  behind: number;
}

function row(line: string): Row {
  const key = KEY.exec(line);
  const item = ITEM.exec(line);
  const dashes = key?.[2] ?? item?.[2] ?? "";
  const indent = /^\s*/.exec(line)![0].length;
  const items = [...dashes.matchAll(/-/g)].map((dash) => indent + dash.index);
  return {
    indent: indent + dashes.length,
    items,
    key: key ? (key[3] ?? key[4] ?? key[5] ?? "") : null,
    behind: key ? key[0].trimEnd().length : 0,
  };
}

const isEmpty = (line: string) => /^\s*(#.*)?$/.test(line);

/** Path of the rows around the key of a row; items of lists that begin there and above are counted. */
function around(lines: string[], last: number): (string | number)[] {
  const path: (string | number)[] = [];
  let limit = row(lines[last]!).indent;
  let counted: { indent: number; count: number } | null = null;
  for (let number = last; number >= 0; number--) {
    if (number < last && isEmpty(lines[number]!)) continue;
    const { indent: own, items, key } = row(lines[number]!);
    for (const dash of [...items].reverse()) {
      if (counted && dash === counted.indent) counted.count++;
      else if (dash < limit && (!counted || dash < counted.indent)) {
        if (counted) path.unshift(counted.count);
        counted = { indent: dash, count: 0 };
        limit = dash;
      }
    }
    // A list may stand as far left as the key that it belongs to.
    const belongs = own < limit || (counted !== null && own === counted.indent && items.length === 0);
    if (key !== null && belongs && number < last) {
      if (counted && own <= counted.indent) {
        path.unshift(counted.count);
        counted = null;
      }
      path.unshift(key);
      limit = own;
    }
  }
  if (counted) path.unshift(counted.count);
  return path;
}

interface Bracket {
  list: boolean;
  index: number;
  key: string | null;
  keys: string[];
}

/** Brackets that are open behind a stretch of text; null where a quote or comment is. */
function brackets(text: string): { open: Bracket[]; word: string } | null {
  const open: Bracket[] = [];
  let word = "";
  for (let at = 0; at < text.length; at++) {
    const letter = text[at]!;
    const top = open.at(-1);
    if ((letter === '"' || letter === "'") && !word.trim()) {
      const end = text.indexOf(letter, at + 1);
      if (end < 0) return null;
      word = text.slice(at + 1, end);
      at = end;
    } else if (letter === "#" && /\s/.test(text[at - 1] ?? " ")) {
      const end = text.indexOf("\n", at);
      if (end < 0) return null;
      at = end;
    } else if ((letter === "{" || letter === "[") && (top || !word.trim())) {
      open.push({ list: letter === "[", index: 0, key: null, keys: [] });
      word = "";
    } else if (letter === "}" || letter === "]") {
      open.pop();
      word = "";
    } else if (top && letter === ",") {
      if (top.list) top.index++;
      top.key = null;
      word = "";
    } else if (top && !top.list && letter === ":" && /[\s,}]|^$/.test(text[at + 1] ?? "")) {
      top.key = word.trim();
      top.keys.push(top.key);
      word = "";
    } else word += letter;
  }
  return { open, word: word.trimStart() };
}

/** Where a position of a text is; null in a comment or a quoted text. */
export function placeAt(text: string, position: number): YamlPlace | null {
  const lines = text.slice(0, position).split("\n");
  const last = lines.length - 1;
  const line = lines[last]!;
  // The row that the position belongs to: brackets may go over several.
  for (let start = last; start >= 0; start--) {
    const own = row(lines[start]!);
    if (own.key === null) continue;
    const tail = [lines[start]!.slice(own.behind), ...lines.slice(start + 1)].join("\n");
    const found = brackets(tail);
    if (!found) return null;
    if (found.open.length) {
      const path = [...around(lines, start), own.key];
      return inBrackets(path, found.open, found.word, position);
    }
    if (start === last) {
      const word = tail.trimStart();
      const path = [...around(lines, start), own.key];
      return { path, typing: "value", word, from: position - word.length, siblings: [] };
    }
    break;
  }
  if (/(^|\s)#/.test(line)) return null;
  const { indent, items } = row(line);
  const word = line.slice(Math.min(indent, line.length)).trimStart();
  const path = around(lines, last);
  const siblings = items.length ? [] : keysBeside(text.split("\n"), last, indent);
  return { path, typing: "field", word, from: position - word.length, siblings };
}

function inBrackets(path: (string | number)[], open: Bracket[], word: string, position: number): YamlPlace {
  const whole = [...path];
  open.forEach((one, number) => {
    if (one.list) whole.push(one.index);
    else if (one.key !== null) whole.push(one.key);
    else if (number < open.length - 1) whole.push("");
  });
  const inner = open.at(-1)!;
  const typing = inner.list || inner.key !== null ? "value" : "field";
  return { path: whole, typing, word, from: position - word.length, siblings: inner.keys };
}

/** Fields of the mapping that a row stands in. */
function keysBeside(lines: string[], number: number, indent: number): string[] {
  const found: string[] = [];
  for (const step of [-1, 1]) {
    for (let at = number + step; at >= 0 && at < lines.length; at += step) {
      if (isEmpty(lines[at]!)) continue;
      const own = row(lines[at]!);
      if (own.indent === indent && own.key !== null) found.push(own.key);
      if (own.indent < indent || (own.items.length > 0 && (step > 0 || own.items[0]! < indent))) break;
    }
  }
  return found;
}
