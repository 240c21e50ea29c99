import { fileURLToPath } from "node:url";
import { defineConfig } from "vite";
import { tokens } from "./tokens.ts";

const here = (path: string) => fileURLToPath(new URL(path, import.meta.url));

export default defineConfig({
  base: "./",
  plugins: [tokens()],
  build: {
    outDir: here("../python/arcless/studio/page"),
    emptyOutDir: true,
    assetsInlineLimit: 0, // the content policy of the server allows files, and no data addresses
    modulePreload: { polyfill: false },
    chunkSizeWarningLimit: 700,
  },
});
