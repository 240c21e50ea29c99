/** Questions of the panels of results. */
import { figureOf, type Figure, type Shown } from "../charts/figure.ts";
import { ask } from "../connection/http.ts";
import type { Alone } from "./MeasuredForm.tsx";
import type { MeasuredAs } from "./measuredAs.ts";
import type { Assessed, Comparison, Explanation, Figures } from "./told.ts";

/** Verdict and numbers of a run, and the heads of its figures. */
export async function askRun(run: string, signal: AbortSignal): Promise<Assessed & Figures> {
  const [assessed, figures] = await Promise.all([
    ask<Assessed>("assessed", { query: { run }, signal }),
    ask<Figures>("figures", { query: { run }, signal }),
  ]);
  return { ...assessed, ...figures };
}

export async function askFigure(run: string, key: string, shown: Shown, signal: AbortSignal): Promise<Figure> {
  return figureOf(await ask("figure", { query: { run, key, ...shown }, signal }));
}

/** What is compared: paths, what each is called, and what was given of measured files. */
export interface Compares {
  subjects: string[];
  names: string[];
  measured: Record<string, MeasuredAs>;
}

export const askComparison = (what: Compares, signal: AbortSignal): Promise<Comparison> => ask("compare", { body: what, signal });

export const askMeasurement = (path: string, as: MeasuredAs, signal: AbortSignal): Promise<Alone> =>
  ask("measurement", { body: { path, as }, signal });

export async function askOverlay(what: Compares, key: string, shown: Shown, signal: AbortSignal): Promise<Figure> {
  return figureOf(await ask("compare", { body: { ...what, figure: key, ...shown }, signal }));
}

export const askExplanation = (run: string, signal: AbortSignal): Promise<Explanation> =>
  ask("explain", { query: { run }, signal });
