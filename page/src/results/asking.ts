/** Questions of the panels of results. */
import { figureOf, type Figure, type Shown } from "../charts/figure.ts";
import { ask } from "../connection/http.ts";
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

export const askComparison = (subjects: string[], signal: AbortSignal): Promise<Comparison> =>
  ask("compare", { body: { subjects }, signal });

export async function askOverlay(subjects: string[], key: string, shown: Shown, signal: AbortSignal): Promise<Figure> {
  return figureOf(await ask("compare", { body: { subjects, figure: key, ...shown }, signal }));
}

export const askExplanation = (run: string, signal: AbortSignal): Promise<Explanation> =>
  ask("explain", { query: { run }, signal });
