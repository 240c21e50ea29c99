import { fileURLToPath } from "node:url";
import { defineConfig } from "vite";

const here = (path: string) => fileURLToPath(new URL(path, import.meta.url));

/** The player of animated reports: one classic script that loads nothing, and its style. */
export default defineConfig({
  define: { "process.env.NODE_ENV": '"production"' }, // library mode leaves it in the script
  build: {
    outDir: here("../python/arcless/studio/page/animation"),
    emptyOutDir: true,
    cssCodeSplit: false,
    lib: {
      entry: here("src/player/animation/main.tsx"),
      formats: ["iife"],
      name: "arclessAnimation",
      fileName: () => "animation.js",
      cssFileName: "animation",
    },
  },
});
