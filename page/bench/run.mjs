/**
 * Measures the player in headless Chromium without a GPU: frames in a second of 5 s of playing, and
 * what the page's own script took of a frame. `node bench/run.mjs [BROWSER]`, in the folder `page`.
 */
import { execFileSync } from "node:child_process";
import { createServer } from "node:http";
import { readFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { extname, join } from "node:path";
import { chromium } from "playwright-core";

const folder = join(tmpdir(), "arcless-player-bench");
execFileSync(process.execPath, ["node_modules/vite/bin/vite.js", "build", "--config", "bench/vite.config.ts", "--logLevel", "warn"], { stdio: "inherit" });
const types = { ".html": "text/html", ".js": "text/javascript", ".css": "text/css" };
const server = createServer(async (request, response) => {
  const path = new URL(request.url, "http://here").pathname;
  try {
    const body = await readFile(join(folder, path));
    response.writeHead(200, { "Content-Type": types[extname(path)] ?? "application/octet-stream" }).end(body);
  } catch {
    response.writeHead(404).end();
  }
});
await new Promise((done) => server.listen(0, "127.0.0.1", done));
const browser = await chromium.launch({ executablePath: process.argv[2] ?? "/usr/bin/chromium", args: ["--no-sandbox", "--disable-gpu"] });
for (const query of ["view=side", "view=side&whole", "view=space"]) {
  const page = await browser.newPage({ viewport: { width: 1200, height: 900 } });
  page.on("pageerror", (error) => console.error(error.message));
  await page.goto(`http://127.0.0.1:${server.address().port}/index.html?${query}`);
  await page.waitForFunction("window.bench !== undefined");
  const session = await page.context().newCDPSession(page);
  await session.send("Performance.enable");
  const spent = async () => Object.fromEntries((await session.send("Performance.getMetrics")).metrics.map((one) => [one.name, one.value]));
  await page.waitForTimeout(500);
  const before = await spent();
  const found = await page.evaluate("window.bench()");
  const after = await spent();
  const frames = found.frames_per_s * 5;
  console.log(query, {
    frames_per_s: Number(found.frames_per_s.toFixed(1)), longest_ms: Math.round(found.longest_ms),
    script_ms: Number(((1000 * (after.ScriptDuration - before.ScriptDuration)) / frames).toFixed(2)),
    heap_MB: Math.round(after.JSHeapUsedSize / 1e6),
  });
  if (process.env.PICTURES) await page.screenshot({ path: join(process.env.PICTURES, `${query.replaceAll(/\W/g, "-")}.png`) });
  await page.close();
}
await browser.close();
server.close();
