import { addPanel } from "../shell/panels.ts";
import { followLine } from "./asking.ts";

export function register(): void {
  addPanel({
    id: "statics",
    slot: "main", alone: true,
    title: "Statics",
    order: 20,
    load: async () => (await import("./Statics.tsx")).Statics,
  });
  followLine();
}
