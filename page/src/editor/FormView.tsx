/** The common fields of the file in groups; changing one changes one value of the text. */
import { useEffect, useRef } from "preact/hooks";
import { selectedField } from "../drawing/scene.ts";
import { opened } from "./documents.ts";
import { followForm, form } from "./formData.ts";
import { ListField } from "./ListField.tsx";
import { ValueField } from "./ValueField.tsx";

export function FormView() {
  const place = useRef<HTMLDivElement>(null);
  useEffect(followForm, []);
  const chosen = selectedField.value;
  useEffect(() => {
    if (chosen === null || place.current?.contains(document.activeElement)) return;
    const parts = chosen.split(".");
    for (; parts.length; parts.pop()) {
      const found = place.current?.querySelector(`[data-field="${CSS.escape(parts.join("."))}"]`);
      if (found) {
        found.closest("details")?.setAttribute("open", "");
        found.scrollIntoView({ block: "nearest" });
        return;
      }
    }
  }, [chosen]);
  const found = form.value?.path === opened.value?.path ? form.value : null;
  if (!opened.value) return <p class="empty">Choose a model to see its fields.</p>;
  if (!found) return <p class="empty">No fields yet: the text is no model that can be read.</p>;
  return (
    <div class="form" ref={place}>
      {found.groups.map((group) => (
        <details open key={group.title}>
          <summary>{group.title}</summary>
          {group.fields.map((own) => (
            <div class="row" data-field={own.field} key={own.field}>
              {Array.isArray(own.typed) ? <ListField own={own} /> : <ValueField own={own} />}
            </div>
          ))}
        </details>
      ))}
    </div>
  );
}
