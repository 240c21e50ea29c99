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

/**
 * Copy a shipped model under a name of its own, `my-NAME`: of a shipped one it would be mistaken. Of a
 * scenario its line and pantographs come too. It is opened.
 */
export async function copy(entry: ModelEntry): Promise<string | null> {
  const stems = (project.peek()?.models ?? []).map((one) => one.path.replace(/^.*\//, "").replace(/\.[a-z]+$/, ""));
  const body = { name: freeName(`my-${entry.name}`, stems), from: entry.path, with_pantographs: entry.kind === "scenario" };
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
