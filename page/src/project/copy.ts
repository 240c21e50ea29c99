/** Models of the library, copied into the folder. */
import { ask } from "../connection/http.ts";
import { complain, say } from "../shell/messages.ts";
import { show } from "../shell/panels.ts";
import { openModel } from "../state/opening.ts";
import { project, readProject, type ModelEntry } from "../state/project.ts";

/** A name that no model of the folder has, with a number if need be. */
export function freeName(wanted: string, taken: readonly string[]): string {
  if (!taken.includes(wanted)) return wanted;
  for (let number = 2; ; number++) if (!taken.includes(`${wanted}-${number}`)) return `${wanted}-${number}`;
}

/** The name that is offered for a copy, `my-NAME`: by that of the shipped model it would be mistaken for it. */
export function nameFor(entry: ModelEntry): string {
  const stems = (project.peek()?.models ?? []).map((one) => one.path.replace(/^.*\//, "").replace(/\.[a-z]+$/, ""));
  return freeName(`my-${entry.name}`, stems);
}

/**
 * Copy a shipped model under a name of its own. Of a scenario its line and pantographs come too, and a second
 * pantograph at the spacing of the TSI where that is asked for. It is opened.
 */
export async function copy(entry: ModelEntry, name: string, second = false): Promise<string | null> {
  const pair = second ? { two_pantographs: "tsi" } : {};
  const body = { name, from: entry.path, with_pantographs: entry.kind === "scenario", ...pair };
  try {
    const { path } = await ask<{ path: string }>("new", { body });
    await readProject();
    openModel(path, entry.kind);
    show("drawing");
    say("note", `${entry.name} is copied to ${path}.`);
    return path;
  } catch (error) {
    complain(error);
    return null;
  }
}
