/** Figures by the sections of a report; each loads when it comes near. */
import { useMemo } from "preact/hooks";
import { Chart, type Ask } from "../charts/Chart.tsx";
import type { Range } from "../charts/extent.ts";
import type { Figure, Head, Section, Shown } from "../charts/figure.ts";

type AskFigure = (key: string, shown: Shown, signal: AbortSignal) => Promise<Figure>;

function One({ head, ask, version, opens }: { head: Head; ask: AskFigure; version: string; opens: Range | undefined }) {
  const mine = useMemo<Ask>(() => (shown, signal) => ask(head.key, shown, signal), [head.key, version]);
  return <Chart key={`${head.key} ${version}`} head={head} ask={mine} opens={opens} />;
}

/**
 * @param version changes when the figures are of other data
 * @param opens part of the track in m that figures along it show at first, whatever the window shows
 */
export function FigureSections({ sections, ask, version, opens }: { sections: Section[]; ask: AskFigure; version: string; opens?: Range }) {
  return (
    <>
      {sections.map((section) => (
        <section key={section.key} aria-labelledby={`figures-${section.key}`}>
          <h3 id={`figures-${section.key}`}>{section.title}</h3>
          {section.rows.flat().map((head) => (
            <One key={head.key} head={head} ask={ask} version={version} opens={opens} />
          ))}
        </section>
      ))}
    </>
  );
}
