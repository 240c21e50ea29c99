/** The scale of colours of a chart: a strip of the colours, with its ends and its middle below. */
import type { Scale } from "./figure.ts";
import { colour } from "./colours.ts";
import { stepped } from "./numbers.ts";

export function ScaleKey({ scale }: { scale: Scale }) {
  const step = (scale.high - scale.low) / 100;
  const numbers = [scale.low, (scale.low + scale.high) / 2, scale.high].map((one) => stepped(one, step));
  return (
    <div class="chart-scale" role="img" aria-label={`Colours of ${scale.label}: from ${numbers[0]} to ${numbers[2]} ${scale.unit}`}>
      <span>{scale.title}</span>
      {scale.under && (
        <span class="chart-under">
          <i style={{ background: colour(scale.under) }} /> {scale.under_label}
        </span>
      )}
      <div>
        <i style={{ background: `linear-gradient(to right, ${scale.order.join(", ")})` }} />
        {numbers.map((text) => (
          <span key={text}>{text}</span>
        ))}
      </div>
    </div>
  );
}
