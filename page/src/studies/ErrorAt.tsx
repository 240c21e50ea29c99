/** What is wrong with the study, told where it is. */
import type { Complaint } from "../connection/http.ts";
import { capital } from "./columns.ts";
import { told } from "./asking.ts";

/** A complaint without the file and the field, which are where it is told. */
function said({ text, what = "", got, expected, hint, field = [] }: Complaint): string {
  const path = field.join(".");
  const own = what.startsWith(path) ? what.slice(path.length).replace(/^:\s*/, "") : what;
  const parts = [own, got && `got ${got}`, expected && `expected ${expected}`].filter(Boolean).join(", ");
  return parts ? capital([parts, hint].filter(Boolean).join("; ")) : text;
}

/** The error of a place of the study file, or of what is below it; null without. */
export function errorAt(...place: string[]): string | null {
  const [error] = told.value?.errors ?? [];
  const field = error?.field;
  return error && field && place.every((part, at) => field[at] === part) ? said(error) : null;
}

export function ErrorAt({ place }: { place: string[] }) {
  const text = errorAt(...place);
  return text === null ? null : <p class="problem" role="alert">{text}</p>;
}
