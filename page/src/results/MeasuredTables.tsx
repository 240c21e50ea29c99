/** Tables of a comparison with measurements: how they were placed, bands, acceptance. */
import { RowHead } from "./RowHead.tsx";
import type { Comparison } from "./told.ts";

/** How each measurement lies on the line of a run, which the caption names. */
export function Placement({ of }: { of: Comparison }) {
  if (!of.placement.length) return null;
  return (
    <div class="wide" tabIndex={0} role="region" aria-label="Placement of the measurement">
      <table>
        <caption>Placement of the measurement{of.placed_on === null ? "" : `, on the line of ${of.placed_on}`}</caption>
        <thead>
          <tr>
            {["measurement", "pantograph", "placed by", "offset", "drift", "correlation", "next best"].map((title) => (
              <th key={title} scope="col">
                {title}
              </th>
            ))}
          </tr>
        </thead>
        <tbody>
          {of.placement.map((one, row) => (
            <tr key={row}>
              <th scope="row">{of.names[one.run]}</th>
              <td>{one.pantograph}</td>
              {one.cells.map((text, k) => (
                <td key={k}>{text}</td>
              ))}
            </tr>
          ))}
        </tbody>
      </table>
      <p class="soft">{of.placement_reads}</p>
    </div>
  );
}

/** Standard deviations band by band. */
export function Bands({ of }: { of: Comparison }) {
  if (!of.bands.length) return null;
  return (
    <details>
      <summary>Bands</summary>
      <div class="wide" tabIndex={0} role="region" aria-label="Standard deviation of each band">
        <table>
          <caption>Standard deviation of each band</caption>
          <thead>
            <tr>
              <th scope="col">band</th>
              {of.names.map((name, k) => (
                <th key={k} scope="col" class="number">
                  {name}
                </th>
              ))}
            </tr>
          </thead>
          <tbody>
            {of.bands.map((one, row) => (
              <tr key={row}>
                <th scope="row">
                  {one.label}
                  {of.several ? `, ${one.pantograph}` : ""}
                </th>
                {one.cells.map((parts, k) => (
                  <td key={k} class="number">
                    {parts[0]}
                    {parts.slice(1).filter(Boolean).map((text) => (
                      <span key={text} class="difference">
                        {text}
                      </span>
                    ))}
                  </td>
                ))}
              </tr>
            ))}
          </tbody>
        </table>
        <p class="soft">{of.bands_read}</p>
      </div>
    </details>
  );
}

/** Simulation against line test, number by number, with tolerances of mark C shown as such. */
export function Acceptance({ of }: { of: Comparison }) {
  return (
    <>
      {of.acceptance.map((table) => (
        <div key={`${table.run} ${table.measurement}`} class="wide" tabIndex={0} role="region" aria-label={`${table.run} against ${table.measurement}`}>
          <table>
            <caption>
              Simulation against line test: {table.run} against {table.measurement}
            </caption>
            <thead>
              <tr>
                {["quantity", "simulated", "measured", "difference", "tolerance (mark)", "within"].map((title, k) => (
                  <th key={title} scope="col" class={k && k < 4 ? "number" : ""}>
                    {title}
                  </th>
                ))}
              </tr>
            </thead>
            <tbody>
              {table.rows.map((one, row) => (
                <tr key={row}>
                  <RowHead of={of} row={one} label={one.label} />
                  {one.cells.map((text, k) => (
                    <td key={k} class={k < 3 ? "number" : k === 4 ? `state ${text}` : ""} title={k === 3 ? one.source : undefined}>
                      {text}
                    </td>
                  ))}
                </tr>
              ))}
            </tbody>
          </table>
          <p class="soft">{of.acceptance_reads}</p>
        </div>
      ))}
    </>
  );
}
