/** Questions about the study that is being defined; saving and starting it. */
import { batch, effect, signal } from "@preact/signals";
import { ask, newest, type Complaint } from "../connection/http.ts";
import { complain } from "../shell/messages.ts";
import { changes } from "../state/changes.ts";
import { project, readProject } from "../state/project.ts";
import { subject } from "../state/subject.ts";
import { asChanged, definition, fields, fileOf, freeName, name, scenario, varied, vary, withChanges, type Fields } from "./defining.ts";
import { openStudy } from "./open.ts";
import { isAsked, wanted } from "./vary.ts";

interface Text {
  text: string;
  /** Of the file that it was made from; null of a new one. */
  version: string | null;
  /** null where it is wrong. */
  count: number | null;
  errors: Complaint[];
  /** Whether a file of that name has another text. */
  changes: boolean;
  /** Whether a study of that name has rows already: of what is asked here, or of something else. */
  begun: "same" | "other" | null;
}

/** After the last change, in ms. */
const ASK_AFTER = 150;

export const told = signal<Text | null>(null);
/** The definition that it is told of. */
export const toldOf = signal<typeof definition.value>(null);
export const saving = signal(false);

/** A scenario as a study file in the project's folder names it. */
const named = (path: string) => path.replace(/^shipped:\w+\//, "");

const askFields = newest((signal, path: string) => ask<Fields>("studies/fields", { body: { scenario: path }, signal }));
const askText = newest((signal, given: NonNullable<typeof definition.value>) =>
  ask<Text>("studies/text", { body: { path: fileOf(given.name), definition: given }, signal }),
);

/** A name for a study that none has, and no file. */
export function anotherName(wanted: string): string {
  const view = project.peek();
  const files = (view?.models ?? []).map(({ path }) => path.replace(/\.ya?ml$/, ""));
  const begun = (view?.studies ?? []).flatMap((one) => [one.name, one.path.replace(/^.*\//, "")]);
  return freeName(wanted, [...files, ...(view?.models ?? []).filter(({ kind }) => kind === "study").map((one) => one.name), ...begun]);
}

/** Follow the scenario that is chosen, and what is defined; the returned function ends it. */
export function followDefinition(): () => void {
  let timer: ReturnType<typeof setTimeout> | undefined;
  const ends = [
    effect(() => {
      const path = subject.value;
      if (path === null) return;
      askFields(path).then((found) => {
        if (!found) return;
        // At once: a field that waits to be varied is added to what is there then.
        batch(() => {
          fields.value = found;
          if (scenario.peek() === named(path)) return;
          scenario.value = named(path);
          varied.value = [];
          name.value = anotherName(`${found.name}-study`);
        });
      }, complain);
    }),
    effect(() => {
      const given = definition.value;
      clearTimeout(timer);
      if (!given) {
        told.value = null;
        return;
      }
      timer = setTimeout(() => void askText(given).then((found) => {
        if (!found) return;
        told.value = found;
        toldOf.value = given;
      }, complain), ASK_AFTER);
    }),
    effect(() => {
      const found = fields.value;
      const asked = wanted.value;
      if (!found || asked === null) return;
      const own = found.fields.find(({ field }) => isAsked(field, asked));
      wanted.value = null;
      if (own) vary(asChanged(own, withChanges.peek() ? changes.peek()[own.field] : undefined));
      else complain(`${asked} is no number of this scenario that can be varied.`);
    }),
  ];
  return () => {
    clearTimeout(timer);
    for (const end of ends) end();
  };
}

/** Save the study file; start it if that is wanted. A study that was begun with other values keeps its name. */
export async function save(start: boolean): Promise<boolean> {
  if (told.peek()?.begun === "other") name.value = anotherName(name.peek());
  const given = definition.peek();
  if (!given || saving.peek()) return false;
  saving.value = true;
  try {
    const path = fileOf(given.name);
    const { text, version, changes, begun } = await ask<Text>("studies/text", { body: { path, definition: given } });
    if (begun === "other") throw new Error(`The study ${given.name} was begun with other values. Give this one another name.`);
    if (changes || version === null) await ask("file", { method: "PUT", body: { path, text, version } });
    if (start) await run(path, { resume: begun === "same" });
    await readProject();
    return true;
  } catch (error) {
    complain(error);
    return false;
  } finally {
    saving.value = false;
  }
}

/** Start the study of a file, or go on with it, and look at it. */
export async function run(path: string, more: { resume?: boolean; retry_failed?: boolean } = {}): Promise<void> {
  const answer = await ask<{ path: string }>("studies/run", { body: { path, ...more } });
  openStudy(answer.path);
}
