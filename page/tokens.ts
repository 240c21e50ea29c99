/** The design tokens of reports, as custom properties of CSS: `contact_wire` is `--contact-wire`. */
import { readFileSync } from "node:fs";
import type { Plugin } from "vite";

const FILE = new URL("../python/arcless/figures/description/tokens.json", import.meta.url);
const NAME = "virtual:tokens.css";

type Tokens = Record<"font" | "size" | "space" | "light" | "dark", Record<string, string>>;

const lines = (values: Record<string, string>, before = "") =>
  Object.entries(values).map(([key, value]) => `--${before}${key.replaceAll("_", "-")}: ${value};`).join("");

export function tokensCss(): string {
  const tokens = JSON.parse(readFileSync(FILE, "utf-8")) as Tokens;
  const common = lines(tokens.font, "font-") + lines(tokens.size, "size-") + lines(tokens.space, "space-");
  const light = `color-scheme: light; ${lines(tokens.light)}`;
  const dark = `color-scheme: dark; ${lines(tokens.dark)}`;
  return `:root { ${common} ${light} }
:root[data-scheme="dark"] { ${dark} }
@media (prefers-color-scheme: dark) { :root:not([data-scheme="light"]) { ${dark} } }
`;
}

export function tokens(): Plugin {
  return {
    name: "tokens",
    resolveId: (id) => (id === NAME ? `\0${NAME}` : undefined),
    load: (id) => (id === `\0${NAME}` ? tokensCss() : undefined),
  };
}
