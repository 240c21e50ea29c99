/** The window: six slots, and in each what the rooms of the page put there. */
import { useLayoutEffect, useRef } from "preact/hooks";
import { Banner } from "./Banner.tsx";
import { Help } from "./Help.tsx";
import { Loaded, offered } from "./Loaded.tsx";
import { folded, sizeOf } from "./layout.ts";
import { Messages } from "./Messages.tsx";
import { Palette } from "./Palette.tsx";
import { part, standing, type Part, type Slot } from "./panels.ts";
import { goTo, PLACES } from "./places.ts";
import { Splitter } from "./Splitter.tsx";
import { Tabs } from "./Tabs.tsx";
import { dialog } from "./window.ts";

function All({ slot }: { slot: Slot }) {
  return (
    <>
      {offered(slot).map((panel) => (
        <Loaded key={panel.id} panel={panel} />
      ))}
    </>
  );
}

function Sized() {
  const element = useRef<HTMLDivElement>(null);
  const below = offered("below").length > 0 && !folded.value.below && !standing("main")?.alone;
  const [left, right, height] = [sizeOf("left"), sizeOf("right"), sizeOf("below")];
  // By script: the content policy allows no style in markup.
  useLayoutEffect(() => {
    const style = element.current!.style;
    for (const [name, size] of Object.entries({ left, right, below: height })) style.setProperty(`--${name}`, `${size}px`);
  }, [left, right, height]);
  const classes = ["body", folded.value.left && "no-left", folded.value.right && "no-right", !below && "no-below"];
  return (
    <div class={classes.filter(Boolean).join(" ")} data-part={part.value} ref={element}>
      <nav class="slot left" aria-label="Project">
        <All slot="left" />
      </nav>
      <Splitter side="left" />
      <main>
        <Tabs slot="main" label="Views" />
        {below && <Splitter side="below" />}
        {below && (
          <section class="slot below" aria-label="Strips">
            <All slot="below" />
          </section>
        )}
      </main>
      <Splitter side="right" />
      <Tabs slot="right" label="Inspector" />
    </div>
  );
}

/** For who goes by Tab: seen when it has the focus. */
function Skip() {
  return (
    <nav class="skip" aria-label="Parts">
      {PLACES.map((place) => (
        <button key={place.title} onClick={() => goTo(place)}>
          {place.title}
        </button>
      ))}
    </nav>
  );
}

const PARTS: readonly [Part, string][] = [["left", "Project"], ["main", "Drawing"], ["right", "Fields"]];

/** The switch of a phone between the parts of the window. */
function Switch() {
  return (
    <nav class="parts" aria-label="Shown part">
      {PARTS.map(([of, title]) => (
        <button key={of} aria-pressed={part.value === of} onClick={() => (part.value = of)}>
          {title}
        </button>
      ))}
    </nav>
  );
}

export function Shell() {
  return (
    <>
      <Skip />
      <Banner />
      <header class="slot top">
        <All slot="top" />
      </header>
      <Sized />
      <footer class="slot bottom">
        <All slot="bottom" />
      </footer>
      <Switch />
      <Messages />
      {dialog.value === "commands" && <Palette />}
      {dialog.value === "keys" && <Help />}
    </>
  );
}
