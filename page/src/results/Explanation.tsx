/** Why σ is as it is: shares of what repeats, deviation by span, and places to look at. */
import { decimals } from "../charts/numbers.ts";
import { useAnswer } from "./answer.ts";
import { askExplanation, askFigure, askRun } from "./asking.ts";
import { FigureSections } from "./FigureSections.tsx";
import { NoRun } from "./RunList.tsx";
import { Refusal, Waiting } from "./State.tsx";
import type { Explanation as Explained, Figures, Place } from "./told.ts";
import { shownRun, versionOf } from "./which.ts";
import { goTo } from "./place.ts";
import "./results.css";

type Pantograph = Explained["pantographs"][number];

function Shares({ of }: { of: Pantograph }) {
  const sum = of.groups.reduce((total, one) => total + one.share_percent, 0);
  return (
    <>
      <div class="shares" role="list" aria-label={`Shares of the variance of the force of ${of.name}`}>
        {of.groups.map((one) => (
          <div key={one.key} role="listitem" style={{ display: "contents" }}>
            <span>{one.name}</span>
            <span class="bar" aria-hidden="true">
              <i style={{ width: `${Math.min(Math.max(one.share_percent, 0), 100)}%` }} />
            </span>
            <span class="number">
              {decimals(one.share_percent, 1)}
              {one.uncertainty_percent === null ? "" : ` ± ${decimals(one.uncertainty_percent, 1)}`} %
            </span>
          </div>
        ))}
      </div>
      <p class="soft">
        Parts of the variance σ², {decimals(sum, 0)} % together; σ is {decimals(of.std_force_N, 1)} N.
      </p>
    </>
  );
}

function Places({ run, places, title, of }: { run: string; places: Place[]; title: string; of: string }) {
  if (!places.length) return null;
  const asBuilt = places.some((place) => place.as_built !== null);
  return (
    <div class="wide" tabIndex={0} role="region" aria-label={title}>
      <table>
        <caption>{title}</caption>
        <thead>
          <tr>
            <th scope="col">place</th>
            <th scope="col" class="number">position, m</th>
            <th scope="col" class="number">force, N</th>
            <th scope="col" class="number">{of}, N</th>
            {asBuilt && <th scope="col">not as designed</th>}
          </tr>
        </thead>
        <tbody>
          {places.map((place) => (
            <tr key={place.position_m}>
              <th scope="row">
                <button class="place" onClick={() => goTo(run, place)} title="Show it in the player, from a second before">
                  {place.span === null ? "" : `span ${place.span}, `}
                  {place.where}
                </button>
              </th>
              <td class="number">{decimals(place.position_m, 1)}</td>
              <td class="number">{decimals(place.force_N, 1)}</td>
              <td class="number">{(place.deviation_N > 0 ? "+" : "") + decimals(place.deviation_N, 1)}</td>
              {asBuilt && <td>{place.as_built ?? ""}</td>}
            </tr>
          ))}
        </tbody>
      </table>
    </div>
  );
}

/** Figures of the explanation among those of the run. */
const OURS = /^(by-span|contributions|irregular)-/;

function ours({ sections }: Figures): Figures["sections"] {
  const found = sections.flatMap((one) => one.rows.flat()).filter((head) => OURS.test(head.key));
  return found.length ? [{ key: "explained", title: "By span, and what repeats", rows: [found] }] : [];
}

export function Explanation() {
  const run = shownRun.value;
  const version = run === null ? "" : versionOf([run]);
  const key = run === null ? null : version;
  const found = useAnswer(key, async (signal) => ({
    explained: await askExplanation(run!, signal),
    figures: await askRun(run!, signal),
  })).value;
  if (run === null) return <NoRun then="this says why its σ is as it is." />;
  if (found.complaint) return <Refusal complaint={found.complaint} what={`σ of ${run} cannot be explained`} />;
  if (found.waiting || !found.value) return <Waiting what={run} />;
  const { explained, figures } = found.value;
  if (explained.refused) return <Refusal complaint={explained.refused} what={`σ of ${run} cannot be explained`} />;
  return (
    <article class="results">
      <h2>Why σ is as it is: {figures.title}</h2>
      <ul>
        {explained.sentences.map((text) => (
          <li key={text}>{text}</li>
        ))}
      </ul>
      {explained.notes.length > 0 && (
        <ul class="remarks" aria-label="Remarks">
          {explained.notes.map((text) => (
            <li key={text}>{text}</li>
          ))}
        </ul>
      )}
      {explained.pantographs.map((one) => (
        <section key={one.name} aria-label={one.name}>
          <h3>{explained.pantographs.length > 1 ? `Shares, ${one.name}` : "Shares"}</h3>
          <Shares of={one} />
          <Places run={run} places={one.worst} title="Largest deviations from the mean" of="deviation" />
          <Places run={run} places={one.irregular} title="Largest deviations from what repeats" of="deviation" />
        </section>
      ))}
      <FigureSections sections={ours(figures)} version={version} ask={(key, shown, signal) => askFigure(run, key, shown, signal)} />
    </article>
  );
}
