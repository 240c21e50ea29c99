/**
 * Frames a second of a chart of a million samples, zoomed and moved, as a user does it.
 *
 *   python -m tests.support.long_run FOLDER
 *   python -m arcless studio FOLDER --no-browser
 *   node page/bench/charts.mjs ADDRESS
 */
import { chromium } from "playwright-core";

/** Turns of the wheel, and moves of the pointer, in each part. */
const ACTIONS = 120;

const [address] = process.argv.slice(2);
const browser = await chromium.launch({ executablePath: "/usr/bin/chromium", args: ["--no-sandbox"] });
const page = await browser.newPage({ viewport: { width: 1400, height: 900 } });
await page.goto(address);
await page.getByRole("checkbox", { name: /long/ }).check();
await page.getByRole("tab", { name: "Results" }).click();
const frame = page.getByRole("application", { name: "Contact force", exact: true });
await frame.scrollIntoViewIfNeeded();
await frame.locator("canvas").waitFor();

/** Count frames while something is done. */
async function measure(what, act) {
  await page.evaluate(() => {
    const seen = (window.frames_ms = []);
    let last = performance.now();
    const next = (now) => {
      seen.push(now - last);
      last = now;
      window.frames_end ? (window.frames_end = false) : requestAnimationFrame(next);
    };
    requestAnimationFrame(next);
  });
  await act();
  const all = await page.evaluate(() => {
    window.frames_end = true;
    return window.frames_ms.slice(1);
  });
  const rate = (1000 * all.length) / all.reduce((sum, one) => sum + one, 0);
  const slow = [...all].sort((a, b) => a - b)[Math.floor(0.95 * all.length)];
  console.log(`${what}: ${rate.toFixed(1)} frames a second, 95 % below ${slow.toFixed(1)} ms, worst ${Math.max(...all).toFixed(0)} ms`);
}

const box = await frame.boundingBox();
const middle = { x: box.x + box.width / 2, y: box.y + box.height / 2 };
const wheel = async (by) => {
  await page.keyboard.down("Control");
  for (let k = 0; k < ACTIONS; k++) await page.mouse.wheel(0, by);
  await page.keyboard.up("Control");
};
await page.mouse.move(middle.x, middle.y);
await measure("zoom in", () => wheel(-50));
await page.waitForTimeout(500);
await page.keyboard.down("Shift");
await page.mouse.down();
await measure("move", async () => {
  for (let k = 0; k < ACTIONS; k++) await page.mouse.move(middle.x + 300 * Math.sin(k / 10), middle.y);
});
await page.mouse.up();
await page.keyboard.up("Shift");
await measure("zoom out", () => wheel(50));
await browser.close();
