/** The common fields of the file in groups; changing one changes one value of the text. */
import { useEffect, useRef } from "preact/hooks";
import { selectedField } from "../drawing/scene.ts";
import { opened } from "./documents.ts";
import { followForm, form } from "./formData.ts";
import { DropperTable } from "./DropperTable.tsx";
import { rowsOf, spanOf } from "./dropperRows.ts";
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
          {rowsOf(group.fields).map((all) => (
            <div class="row" data-field={all[0].together ?? all[0].field} key={all[0].field}>
              {all[0].together ? <DropperTable lists={all} span={spanOf(all[0].together, group.fields)} />
                : Array.isArray(all[0].typed) ? <ListField own={all[0]} /> : <ValueField own={all[0]} />}
            </div>
          ))}
        </details>
      ))}
    </div>
  );
}
