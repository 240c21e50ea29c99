import { addPanel } from "../shell/panels.ts";

export function register(): void {
  addPanel({
    id: "project",
    slot: "left",
    title: "Project",
    order: 0,
    load: async () => (await import("./ProjectTree.tsx")).ProjectTree,
  });
}
