/** Studies: define one, watch one. */
import { Define } from "./Define.tsx";
import "./studies.css";
import { face } from "./vary.ts";
import { Watch } from "./Watch.tsx";

export function Studies() {
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
