/** Numbers as the reports write them: a real minus, decimals by a form such as "0.00". */

export function decimals(value: number, count: number): string {
  const text = value.toFixed(count);
  // A number that rounds to zero has no sign.
  return (Number(text) === 0 ? text.replace("-", "") : text).replace("-", "−");
}

/** A number with the decimals of a form: "0.00" has two; "0.00e+0" is a power of ten. */
export function formed(value: number, form: string): string {
  if (!Number.isFinite(value)) return "–";
  if (form.includes("e")) return value.toExponential(2).replaceAll("-", "−");
  return decimals(value, (form.split(".")[1] ?? "").length);
}

/** A number with about so many digits that tell steps of a size apart. */
export function stepped(value: number, step: number): string {
  return decimals(value, Math.min(6, Math.max(0, Math.ceil(-Math.log10(step) - 1e-9))));
}

/** Fewer powers of ten than this on a logarithmic axis, and 2 and 5 times a power have a tick too. */
const FEW_POWERS = 3;

/** Places of the numbers of a logarithmic axis: powers of ten, with 2 and 5 times them where these are few. */
export function logarithmicTicks(low: number, high: number): number[] {
  const powers = Math.log10(high / low);
  const found: number[] = [];
  for (let k = Math.floor(Math.log10(low)); k <= Math.log10(high); k++) {
    for (const one of powers < FEW_POWERS ? [1, 2, 5] : [1]) {
      const at = Number(`${one}e${k}`);
      if (at >= low && at <= high) found.push(at);
    }
  }
  return found;
}

const RAISED = "⁰¹²³⁴⁵⁶⁷⁸⁹";

/** A number of a logarithmic axis, short enough to stand beside the title: large and small powers as powers. */
export function powered(value: number, beside: readonly number[]): string {
  const isWide = beside.some((one) => one > 1000 || one < 0.01);
  const power = Math.round(Math.log10(value));
  if (!isWide || Number(`1e${power}`) !== value) return String(value);
  const raised = [...String(Math.abs(power))].map((digit) => RAISED[Number(digit)]).join("");
  return `10${power < 0 ? "⁻" : ""}${raised}`;
}
