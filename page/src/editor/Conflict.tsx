/** Two texts of one file side by side: whoever looks decides, piece by piece. */
import { useComputed, useSignal } from "@preact/signals";
import { conflict } from "./documents.ts";
import { diff, joined } from "./diff.ts";
import { settle } from "./saving.ts";

type Side = "mine" | "theirs" | "both";

/** Lines that both have are shown up to so many on either side of a difference. */
const AROUND = 3;

export function Conflict() {
  const found = conflict.value;
  const pieces = useComputed(() => (conflict.value ? diff(conflict.value.mine, conflict.value.theirs?.text ?? "") : []));
  const sides = useSignal<Side[]>([]);
  if (!found) return null;
  let number = -1;
  const choose = (which: number, side: Side) => {
    const all = pieces.value.filter((piece) => !piece.same).map((_, at) => sides.value[at] ?? "mine");
    all[which] = side;
    sides.value = all;
  };
  return (
    <section class="conflict" aria-label="Two texts of the file">
      <p role="alert">
        {found.theirs
          ? `${found.path} was changed by another program while it was changed here. Nothing is saved until you choose.`
          : `${found.path} was deleted by another program. Nothing is saved until you choose.`}
      </p>
      <p class="choices">
        <button onClick={() => settle(found.mine)}>Keep what was typed here</button>
        {found.theirs && <button onClick={() => settle(found.theirs!.text)}>Take what is on the disk</button>}
        {found.theirs && (
          <button onClick={() => settle(joined(pieces.value, sides.value))}>Save the pieces chosen below</button>
        )}
      </p>
      <div class="texts" role="table" aria-label="Differences">
        <div role="row" class="piece head">
          <span role="columnheader">Typed here</span>
          <span role="columnheader">On the disk</span>
        </div>
        {pieces.value.map((piece, at) => {
          if (piece.same) {
            const lines = piece.mine;
            const short = lines.length <= 2 * AROUND ? lines : [...lines.slice(0, AROUND), "…", ...lines.slice(-AROUND)];
            return (
              <div role="row" class="piece same" key={at}>
                <pre role="cell">{short.join("\n")}</pre>
                <pre role="cell">{short.join("\n")}</pre>
              </div>
            );
          }
          const which = ++number;
          const side = sides.value[which] ?? "mine";
          return (
            <div role="row" class={`piece ${side}`} key={at}>
              <pre role="cell">{piece.mine.join("\n")}</pre>
              <pre role="cell">{piece.theirs.join("\n")}</pre>
              <span role="cell" class="side">
                <label>
                  Take{" "}
                  <select value={side} onChange={(event) => choose(which, event.currentTarget.value as Side)}>
                    <option value="mine">the left</option>
                    <option value="theirs">the right</option>
                    <option value="both">both</option>
                  </select>
                </label>
              </span>
            </div>
          );
        })}
      </div>
    </section>
  );
}
