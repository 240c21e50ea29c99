/** The line that a scenario names, as a path of the project. */

const FILE = /\.(ya?ml|json)$/i;

/** Path of the line that stands in a scenario: a shipped name, or a file beside it. */
export function lineOf(scenario: string, typed: string): string {
  if (!FILE.test(typed) || scenario.startsWith("shipped:")) return `shipped:line/${typed}`;
  const parts = [...scenario.split("/").slice(0, -1), ...typed.split("/")];
  const found: string[] = [];
  for (const part of parts) {
    if (part === "..") found.pop();
    else if (part !== "." && part !== "") found.push(part);
  }
  return found.join("/");
}
