// Drives Chromium for the tests: a line of JSON is a call, and a line of JSON its answer.
// Arguments: the folder of the packages, and the browser.
import { createRequire } from "node:module";
import { createInterface } from "node:readline";

const [packages, executablePath] = process.argv.slice(2);
const { chromium } = createRequire(`${packages}/`)("playwright-core");
// Playwright gives each browser an empty profile, and each context its own storage.
const browser = await chromium.launch({
  executablePath,
  args: [
    "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
    "--disable-background-networking", "--disable-component-update", "--disable-sync",
  ],
});
const pages = new Map();

// Opens an address; what the page says, and what it asks for elsewhere, is kept from its beginning.
// A file has no elsewhere: all it asks for is kept. `beside` is a page whose storage this one shares.
async function open({ name, address, before, ready, beside, ...options }) {
  const context = beside === undefined ? await browser.newContext(options) : pages.get(beside).page.context();
  const page = await context.newPage();
  const events = [];
  const own = address.startsWith("file:") ? address : new URL(address).host;
  page.on("console", (said) => {
    // Software rendering says so whenever a picture is taken of a canvas with WebGL.
    if (said.text().includes("GPU stall due to ReadPixels")) return;
    if (["error", "warning"].includes(said.type())) events.push(`${said.type()}: ${said.text()}`);
  });
  page.on("pageerror", (error) => events.push(`page error: ${error.message}`));
  page.on("request", (request) => {
    const asked = request.url();
    const at = own === address ? asked : new URL(asked).host;
    if (at !== own && !asked.startsWith("blob:")) events.push(`request: ${asked.slice(0, 200)}`);
  });
  if (before) await page.addInitScript(before);
  pages.set(name, { page, events, session: await context.newCDPSession(page), beside });
  await page.goto(address);
  if (ready) await page.waitForSelector(ready, { state: "attached" });
}

// Drags in one breath: the page takes a button that is held for 250 ms before it moves as another
// gesture, and between two calls from outside a busy machine may take longer than that.
function drag(session, from, to) {
  const send = (type, [x, y], buttons) =>
    session.send("Input.dispatchMouseEvent", { type, x, y, button: "left", buttons, clickCount: 1 });
  const between = [1, 2, 3, 4].map((step) => from.map((start, at) => start + (step * (to[at] - start)) / 4));
  return Promise.all([
    send("mousePressed", from, 1), ...between.map((place) => send("mouseMoved", place, 1)),
    send("mouseReleased", to, 0),
  ]).then(() => null);
}

async function answer({ name, call, args }) {
  if (call === "open") return open({ name, ...args[0] });
  const { page, events, session, beside } = pages.get(name);
  if (call === "events") return events.splice(0);
  if (call === "send") return session.send(...args);
  if (call === "drag") return drag(session, ...args);
  if (call === "close") return pages.delete(name) && (beside === undefined ? page.context() : page).close();
  const path = call.split(".");
  const last = path.pop();
  const found = await path.reduce((object, part) => object[part], page)[last](...args);
  return Buffer.isBuffer(found) ? found.toString("base64") : found;
}

for await (const line of createInterface({ input: process.stdin })) {
  let reply;
  try {
    reply = { value: (await answer(JSON.parse(line))) ?? null };
  } catch (error) {
    reply = { error: error.message };
  }
  process.stdout.write(`${JSON.stringify(reply)}\n`);
}
await browser.close();
