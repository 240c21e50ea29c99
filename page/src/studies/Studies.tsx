/** Studies: define one, watch one. */
import { useEffect } from "preact/hooks";
import { project } from "../state/project.ts";
import { Define } from "./Define.tsx";
import { followDraft } from "./draft.ts";
import { current, lastOpen, openStudy } from "./open.ts";
import "./studies.css";
import { face, opening, wanted } from "./vary.ts";
import { Watch } from "./Watch.tsx";

/** After the window was read anew, what was watched is watched. */
function again(): void {
  const last = lastOpen();
  if (current.peek() !== null || !project.peek()?.studies.some(({ path }) => path === last)) return;
  openStudy(last);
  face.value = "watch";
}

export function Studies() {
  // Before the window's own wishes, which come later: a field to vary, a study to show.
  const isReady = project.value !== null;
  useEffect(() => {
    if (isReady && wanted.peek() === null && opening.peek() === null) again();
  }, [isReady]);
  useEffect(() => (isReady ? followDraft() : undefined), [isReady]);
  return (
    <div class="studies">
      <div class="faces" role="group" aria-label="Studies">
        <button aria-pressed={face.value === "define"} onClick={() => (face.value = "define")}>Define</button>
        <button aria-pressed={face.value === "watch"} onClick={() => (face.value = "watch")}>Watch</button>
      </div>
      {face.value === "define" ? <Define /> : <Watch />}
    </div>
  );
}
