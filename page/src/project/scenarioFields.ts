/** Fields of the scenario that is run, as typed in its file: those that the run bar offers. */
import { effect, signal } from "@preact/signals";
import { ask, newest } from "../connection/http.ts";
import { whenOpen } from "../connection/stream.ts";
import { changes } from "../state/changes.ts";
import { project } from "../state/project.ts";
import { scenario } from "../state/selection.ts";

interface Field {
  field: string;
  typed: unknown;
  /** Of a variant: what its base has. */
  inherited?: unknown;
}

export interface ScenarioFields {
  path: string;
  /** As typed: "275 km/h"; null where the form does not tell. */
  speed: string | null;
  /** Where the speed stands in the file: in a variant among what it sets. */
  speedField: string;
  /** The line that it names, or that its base names; null where it holds its own. */
  line: string | null;
  /** Names of the pantographs' models, the leading one first. */
  pantographs: string[];
}

export const fields = signal<ScenarioFields | null>(null);

const MODEL = /^pantographs\.(\d+)\.model$/;
const text = (typed: unknown) => (typeof typed === "string" || typeof typed === "number" ? String(typed) : null);

export function sorted(path: string, given: readonly Field[]): ScenarioFields {
  const found = given.map(({ field, typed, inherited }) => ({ field: field.replace(/^set\./, ""), typed: typed ?? inherited }));
  const models = found.flatMap(({ field, typed }) => {
    const place = MODEL.exec(field);
    return place ? [[Number(place[1]), text(typed) ?? ""] as const] : [];
  });
  return {
    path,
    speed: text(found.find(({ field }) => field === "speed")?.typed),
    speedField: given.find(({ field }) => field.replace(/^set\./, "") === "speed")?.field ?? "speed",
    line: text(found.find(({ field }) => field === "line")?.typed),
    pantographs: models.sort(([a], [b]) => a - b).map(([, model]) => model),
  };
}

const question = newest(async (signal, path: string) => {
  const { text } = await ask<{ text: string }>("file", { query: { path }, signal });
  const found = await ask<{ groups: { fields: Field[] }[] }>("form", { body: { path, text }, signal });
  return sorted(path, found.groups.flatMap((group) => group.fields));
});

export function followScenario(): void {
  const read = () => {
    const path = scenario.peek();
    if (path === null) return;
    // What is wrong with the file stands in the tree and in its editor.
    question(path).then((found) => found && (fields.value = found), () => (fields.value = null));
  };
  let before: string | null = null;
  effect(() => {
    void project.value; // the file may have been saved
    if (scenario.value !== before) {
      changes.value = {};
      fields.value = null;
    }
    before = scenario.value;
    read();
  });
  whenOpen(read);
}
