/** Rows of the open study as a table: only those in sight are in the page, however many there are. */
import { useSignal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { errorOf, statusOf, variantOf, type Order } from "./columns.ts";
import { picked, rows } from "./open.ts";
import { columns, criteria, inOrder, isJudged, order } from "./selection.ts";
import { SHAPES, verdictOf, verdictOn } from "./verdicts.ts";

/** Height of a row in px until one is there to be measured; rows above and below the sight that are kept ready. */
const GUESS = 24;
const SPARE = 8;

const sign = (at: Order, by: string) => (at.by !== by ? "none" : at.down ? "descending" : "ascending");

/** Outputs first, then what was varied: what came of a variant is in sight without scrolling. */
const inTable = () => [...columns.value].sort((a, b) => Number(a.kind === "variable") - Number(b.kind === "variable"));

function Title({ by, text, unit, kept }: { by: string; text: string; unit?: string; kept?: string }) {
  const at = order.value;
  const act = () => (order.value = { by, down: at.by === by && !at.down });
  const arrow = at.by !== by ? "" : at.down ? " ↓" : " ↑";
  return (
    <th aria-sort={sign(at, by)} scope="col" class={kept}>
      <button class="plain" onClick={act}>
        {text}{arrow}
        {unit && <small> {unit}</small>}
      </button>
    </th>
  );
}

/** A verdict by its sign; with its word where it stands alone. */
export function Verdict({ word, isWord = false }: { word: string | null; isWord?: boolean }) {
  const shape = word === null ? undefined : SHAPES[word];
  if (!shape) return isWord ? <span class="soft">{word}</span> : null;
  return (
    <span class={shape.state} title={word!}>
      <span aria-hidden="true">{shape.sign}</span> {isWord ? word : <span class="unseen">{word}</span>}
    </span>
  );
}

export function Table() {
  const box = useRef<HTMLDivElement>(null);
  const top = useSignal(0);
  const height = useSignal(300);
  const tall = useSignal(GUESS);
  useEffect(() => {
    const seen = new ResizeObserver(() => (height.value = box.current?.clientHeight ?? 300));
    if (box.current) seen.observe(box.current);
    return () => seen.disconnect();
  }, []);
  useEffect(() => {
    const row = box.current?.querySelector<HTMLElement>("tbody tr:not([aria-hidden])");
    if (row?.offsetHeight) tall.value = row.offsetHeight;
  });
  const rowHeight = tall.value;
  const all = inOrder.value;
  const first = Math.max(0, Math.floor(top.value / rowHeight) - SPARE);
  const end = Math.min(all.length, Math.ceil((top.value + height.value) / rowHeight) + SPARE);
  const step = (by: number) => {
    const now = all.findIndex((at) => variantOf(rows[at]!) === picked.value);
    const next = Math.min(Math.max(now + by, 0), all.length - 1);
    const row = rows[all[next] ?? -1];
    if (!row || !box.current) return;
    picked.value = variantOf(row);
    const y = next * rowHeight;
    if (y < box.current.scrollTop) box.current.scrollTop = y;
    const lowest = y - box.current.clientHeight + 3 * rowHeight;
    if (lowest > box.current.scrollTop) box.current.scrollTop = lowest;
  };
  const keys: Record<string, number> = { ArrowDown: 1, ArrowUp: -1, PageDown: 10, PageUp: -10 };
  return (
    <div class="rows" ref={box} tabIndex={0} role="region" aria-label="Rows of the study"
      onScroll={(event) => (top.value = event.currentTarget.scrollTop)}
      onKeyDown={(event) => {
        const by = keys[event.key];
        if (by === undefined) return;
        event.preventDefault();
        step(by);
      }}>
      <table aria-rowcount={all.length + 1}>
        <thead>
          <tr>
            <Title by="variant" text="Variant" kept="kept" />
            {isJudged.value && <Title by="verdict" text="Verdict" kept="kept second" />}
            {inTable().map(({ name, label, unit }) => <Title key={name} by={name} text={label} unit={unit} />)}
            <Title by="status" text="State" />
            <th scope="col">Error</th>
          </tr>
        </thead>
        <tbody>
          {first > 0 && <tr aria-hidden="true" style={{ height: `${first * rowHeight}px` }} />}
          {all.slice(first, end).map((at, place) => {
            const row = rows[at]!;
            const variant = variantOf(row);
            return (
              <tr key={variant} aria-rowindex={first + place + 2} class={variant === picked.value ? "picked" : statusOf(row)}
                aria-current={variant === picked.value ? "true" : undefined} onClick={() => (picked.value = variant)}>
                <td class="kept">{variant}</td>
                {isJudged.value && <td class="words kept second"><Verdict word={verdictOf(row)} isWord /></td>}
                {inTable().map((column) => (
                  <td key={column.name}><Verdict word={verdictOn(column, row, criteria.value)} /> {column.text(row)}</td>
                ))}
                <td class="words">{statusOf(row)}</td>
                <td class="words error" title={errorOf(row)}>{errorOf(row)}</td>
              </tr>
            );
          })}
          {end < all.length && <tr aria-hidden="true" style={{ height: `${(all.length - end) * rowHeight}px` }} />}
        </tbody>
      </table>
    </div>
  );
}
