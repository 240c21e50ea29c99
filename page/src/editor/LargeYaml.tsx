/** The text of the file in the main slot, with room for long lines. */
import { useEffect } from "preact/hooks";
import { Conflict } from "./Conflict.tsx";
import { conflict, opened } from "./documents.ts";
import "./editor.css";
import { isLarge } from "./Inspector.tsx";
import { Problems } from "./Problems.tsx";
import { YamlView } from "./YamlView.tsx";

export function LargeYaml() {
  useEffect(() => {
    isLarge.value = true;
    return () => void (isLarge.value = false);
  }, []);
  if (!opened.value) return <p class="empty">Choose a model on the left to change it.</p>;
  if (conflict.value) return <Conflict />;
  return (
    <div class="inspector large">
      <YamlView />
      <Problems />
    </div>
  );
}
