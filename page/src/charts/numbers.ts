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
