/** Parallel coordinates on a canvas: an axis for each column, a line for each row. */
import type { Sheet } from "../drawing/canvas.ts";
import { BUCKETS, bucketOf, colourOfBucket } from "./colours.ts";
import { extent, shown, variantOf, type Brushes, type Column } from "./columns.ts";
import type { Criterion, Row } from "./open.ts";
import { SHAPES, judgementsOf, verdictOn, type Limit, type Shape } from "./verdicts.ts";

/** Room in px above and below the axes, for numbers that lie beyond the shapes at their ends. */
export const TOP = 26;
export const BOTTOM = 26;
/** From the end of an axis to its number, in px: beyond the shape of the picked row. */
const CLEAR = 10;
/** Half the width in px of a limit across its axis, and of a shape on it. */
const [BAR, SHAPE] = [11, 3.5];
/** With more rows than this shapes lie over each other; that of the picked row stays. */
const MOST_SHAPES = 300;
/** A limit up to so many ranges of the values beyond them lengthens the axis; one further away would press them together. */
const REACH = 0.5;

export interface Picture {
  columns: Column[];
  rows: readonly Row[];
  /** Places of the rows that are not pale. */
  places: readonly number[];
  brushes: Brushes;
  coloured: Column | null;
  picked: number | null;
  criteria: readonly Criterion[];
  /** By column. */
  limits: Readonly<Record<string, readonly Limit[]>>;
}

export interface Layout {
  x(axis: number): number;
  y(axis: number, value: number): number;
  value(axis: number, y: number): number;
  extents: ([number, number] | null)[];
}

/** Ends of an axis: of its values, and of limits that are not far from them. */
function ends(column: Column, { rows, limits }: Picture): [number, number] | null {
  const found = extent(column, rows);
  if (!found) return null;
  const reach = REACH * (found[1] - found[0]);
  const near = (limits[column.name] ?? []).flatMap(({ low, high }) => [low, high])
    .filter((one) => one >= found[0] - reach && one <= found[1] + reach);
  return [Math.min(found[0], ...near), Math.max(found[1], ...near)];
}

export function layout(picture: Picture, width: number, height: number): Layout {
  const { columns } = picture;
  const extents = columns.map((column) => ends(column, picture));
  const room = height - TOP - BOTTOM;
  const of = (axis: number) => extents[axis] ?? [0, 1];
  return {
    extents,
    // Below the middle of its head, all of which are as wide.
    x: (axis) => ((axis + 0.5) * width) / columns.length,
    y: (axis, value) => TOP + room * (1 - (value - of(axis)[0]) / (of(axis)[1] - of(axis)[0])),
    value: (axis, y) => of(axis)[0] + (1 - (y - TOP) / room) * (of(axis)[1] - of(axis)[0]),
  };
}

function trace(context: CanvasRenderingContext2D, on: Layout, columns: readonly Column[], row: Row): void {
  let joined = false;
  columns.forEach((column, axis) => {
    const value = column.number(row);
    // A line ends where its row has no value.
    if (value === null) joined = false;
    else if (joined) context.lineTo(on.x(axis), on.y(axis, value));
    else {
      context.moveTo(on.x(axis), on.y(axis, value));
      joined = true;
    }
  });
}

function lines(sheet: Sheet, on: Layout, picture: Picture): void {
  const { context, colour } = sheet;
  const { columns, rows, places, coloured } = picture;
  context.lineWidth = 1;
  if (places.length < rows.length) {
    context.strokeStyle = colour("grid");
    context.beginPath();
    for (const row of rows) trace(context, on, columns, row);
    context.stroke();
  }
  const range = coloured && extent(coloured, rows);
  const buckets = Array.from({ length: BUCKETS + 1 }, () => [] as Row[]);
  for (const at of places) {
    const row = rows[at]!;
    buckets[coloured && range ? bucketOf(coloured.number(row), range) + 1 : 0]!.push(row);
  }
  // Many lines are a texture: the more there are, the paler each is.
  context.globalAlpha = Math.min(1, Math.max(0.15, 30 / Math.sqrt(places.length * 10)));
  buckets.forEach((own, bucket) => {
    if (!own.length) return;
    context.strokeStyle = bucket ? colourOfBucket(bucket - 1) : colour(coloured ? "raw" : "accent");
    context.beginPath();
    for (const row of own) trace(context, on, columns, row);
    context.stroke();
  });
  context.globalAlpha = 1;
}

function axes(sheet: Sheet, on: Layout, picture: Picture): void {
  const { columns, brushes } = picture;
  const { context, colour, height } = sheet;
  context.font = `12px ${colour("font-text")}`;
  context.textAlign = "center";
  columns.forEach((column, axis) => {
    const x = on.x(axis);
    context.strokeStyle = colour("soft");
    context.lineWidth = 1;
    context.beginPath();
    context.moveTo(x, TOP);
    context.lineTo(x, height - BOTTOM);
    context.stroke();
    const ends = on.extents[axis];
    context.fillStyle = colour("ink");
    if (ends) {
      context.textBaseline = "bottom";
      context.fillText(shown(ends[1]), x, TOP - CLEAR);
      context.textBaseline = "top";
      context.fillText(shown(ends[0]), x, height - BOTTOM + CLEAR);
    }
    limits(sheet, on, axis, picture.limits[column.name] ?? []);
    const range = brushes[column.name];
    if (!range) return;
    const [top, bottom] = [on.y(axis, range[1]), on.y(axis, range[0])].map((y) => Math.min(Math.max(y, TOP), height - BOTTOM)) as [number, number];
    context.fillStyle = context.strokeStyle = colour("accent");
    context.globalAlpha = 0.25;
    context.fillRect(x - 7, top, 14, bottom - top);
    context.globalAlpha = 1;
    context.strokeRect(x - 7, top, 14, bottom - top);
  });
}

/** Limits of an output across its axis: a bar, or a band where they go with the variants. */
function limits({ context, colour, height }: Sheet, on: Layout, axis: number, all: readonly Limit[]): void {
  const x = on.x(axis);
  context.fillStyle = colour("limit");
  for (const limit of all) {
    const [top, bottom] = [on.y(axis, limit.high), on.y(axis, limit.low)];
    if (bottom < TOP || top > height - BOTTOM) continue;
    const [from, to] = [Math.max(top, TOP), Math.min(bottom, height - BOTTOM)];
    context.globalAlpha = 0.3;
    context.fillRect(x - BAR, from, 2 * BAR, to - from);
    context.globalAlpha = 1;
    for (const y of [top, bottom]) if (y >= TOP - 1 && y <= height - BOTTOM + 1) context.fillRect(x - BAR, y - 1.5, 2 * BAR, 3);
  }
}

function shape(context: CanvasRenderingContext2D, drawn: Shape["drawn"], x: number, y: number, size: number): void {
  context.beginPath();
  if (drawn === "circle") context.arc(x, y, size, 0, 2 * Math.PI);
  else {
    const corners: [number, number][] = drawn === "diamond"
      ? [[0, -1.3], [1.3, 0], [0, 1.3], [-1.3, 0]]
      : drawn === "up" ? [[0, -1.3], [1.2, 1], [-1.2, 1]] : [[0, 1.3], [1.2, -1], [-1.2, -1]];
    for (const [right, down] of corners) context.lineTo(x + right * size, y + down * size);
  }
  context.fill();
}

/** Where a row meets the axis of an output that is judged: a shape by the verdict. */
function verdicts({ context, colour }: Sheet, on: Layout, picture: Picture, row: Row, size: number): void {
  picture.columns.forEach((column, axis) => {
    const [value, verdict] = [column.number(row), verdictOn(column, row, picture.criteria)];
    const own = verdict === null ? undefined : SHAPES[verdict];
    if (value === null || !own) return;
    context.fillStyle = colour(own.colour);
    shape(context, own.drawn, on.x(axis), on.y(axis, value), size);
  });
}

/** The limit that holds for a row itself. */
function ownLimits({ context, colour }: Sheet, on: Layout, { columns, criteria }: Picture, row: Row): void {
  context.fillStyle = colour("limit");
  for (const [number, , limit] of judgementsOf(row)) {
    const axis = columns.findIndex(({ name }) => name === criteria[number]?.output);
    if (axis < 0 || limit === null) continue;
    context.fillRect(on.x(axis) - BAR - 4, on.y(axis, limit) - 2.5, 2 * BAR + 8, 5);
  }
}

export function paint(sheet: Sheet, picture: Picture): void {
  const on = layout(picture, sheet.width, sheet.height);
  lines(sheet, on, picture);
  const own = picture.rows.find((row) => variantOf(row) === picture.picked);
  if (own) {
    sheet.context.strokeStyle = sheet.colour("highlight");
    sheet.context.lineWidth = 3;
    sheet.context.beginPath();
    trace(sheet.context, on, picture.columns, own);
    sheet.context.stroke();
  }
  axes(sheet, on, picture);
  if (own) ownLimits(sheet, on, picture, own);
  if (picture.places.length <= MOST_SHAPES) {
    for (const at of picture.places) verdicts(sheet, on, picture, picture.rows[at]!, SHAPE);
  }
  if (own) verdicts(sheet, on, picture, own, 2 * SHAPE);
}

/** The axis near a point; null where none is. */
export function axisAt(picture: Picture, width: number, height: number, x: number): number | null {
  const on = layout(picture, width, height);
  const at = picture.columns.findIndex((_, axis) => Math.abs(on.x(axis) - x) <= 14);
  return at < 0 ? null : at;
}

/** The variant with the value nearest to a height on an axis; null where no row has one. */
export function pointAt(picture: Picture, width: number, height: number, axis: number, y: number): number | null {
  const on = layout(picture, width, height);
  let [best, least] = [null as number | null, Infinity];
  for (const at of picture.places) {
    const row = picture.rows[at]!;
    const value = picture.columns[axis]?.number(row) ?? null;
    const distance = value === null ? Infinity : Math.abs(on.y(axis, value) - y);
    if (distance < least) [best, least] = [variantOf(row), distance];
  }
  return best;
}

/** The variant whose line passes nearest to a point between two axes; null beside them. */
export function lineAt(picture: Picture, width: number, height: number, x: number, y: number): number | null {
  const on = layout(picture, width, height);
  const axis = picture.columns.findIndex((_, one) => x >= on.x(one) && x <= on.x(one + 1) && one + 1 < picture.columns.length);
  const [left, right] = [picture.columns[axis], picture.columns[axis + 1]];
  if (!left || !right) return null;
  const share = (x - on.x(axis)) / (on.x(axis + 1) - on.x(axis));
  let [best, least] = [null as number | null, Infinity];
  for (const at of picture.places) {
    const row = picture.rows[at]!;
    const [one, other] = [left.number(row), right.number(row)];
    if (one === null || other === null) continue;
    const distance = Math.abs(on.y(axis, one) + share * (on.y(axis + 1, other) - on.y(axis, one)) - y);
    if (distance < least) [best, least] = [variantOf(row), distance];
  }
  return best;
}
