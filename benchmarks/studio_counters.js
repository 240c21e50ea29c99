// Counts what the page of the studio draws and asks, for `benchmarks/studio_page.py`. It is there
// before the page's own script. Times in ms of `performance.now()`.
(() => {
  /** Pictures begun, by canvas: both kinds of views clear theirs once for each. */
  const begun = new WeakMap();
  const count = (canvas) => begun.set(canvas, (begun.get(canvas) ?? 0) + 1);
  for (const [kind, method] of [[CanvasRenderingContext2D, "clearRect"], [WebGL2RenderingContext, "clear"]]) {
    const original = kind.prototype[method];
    kind.prototype[method] = function (...given) {
      count(this.canvas);
      return original.apply(this, given);
    };
  }

  /** Questions about the line at rest: body as it was sent, when, and when it was answered. */
  const asked = [];
  const fetched = window.fetch;
  window.fetch = async (address, given) => {
    if (!String(address).startsWith("api/statics")) return fetched(address, given);
    const one = { body: JSON.parse(given.body), from: performance.now(), to: null };
    asked.push(one);
    const answer = await fetched(address, given);
    one.to = performance.now();
    return answer;
  };

  const frame = () => new Promise(requestAnimationFrame);
  /** Behind the painting of a frame. */
  const painted = async () => {
    await frame();
    await new Promise((done) => setTimeout(done));
  };

  /**
   * Pictures of a canvas for so many ms, the first of `warm` ms left out. One counts where the canvas
   * was drawn since the frame before and `state()` is another one: the same picture twice is one.
   * `act(n)` is done in each frame.
   */
  async function pictures(selector, ms, state = (n) => n, act = () => {}, warm = 500) {
    const times = [];
    let [drawn, before] = [0, undefined];
    const begin = (await frame()) + warm;
    for (let now = begin - warm, n = 0; now < begin + ms; now = await frame(), n++) {
      act(n);
      const canvas = document.querySelector(selector);
      const all = (canvas && begun.get(canvas)) ?? 0;
      const is = state(n);
      if (all === drawn || is === before) continue;
      [drawn, before] = [all, is];
      times.push(now);
    }
    const counted = times.filter((time) => time >= begin);
    const apart = counted.slice(1).map((time, n) => time - counted[n]);
    return { rate: (1000 * counted.length) / ms, longest: Math.max(0, ...apart), all: times.length };
  }

  /** Time of the run that is shown, s. */
  const shownTime = () => document.querySelector(".transport input[type=range]")?.value;

  /** Play, if the clock does not go on already. */
  const play = () => document.querySelector(".transport button[aria-label=Play]")?.click();

  /** Bring a figure into view, and give it a name to find it by. */
  function mark(title) {
    const all = [...document.querySelectorAll("figure.chart")];
    const found = all.find((one) => one.querySelector("h4").textContent === title);
    found.dataset.measured = "";
    found.scrollIntoView();
  }

  /** A small copy of what a canvas shows, as a text. */
  const small = Object.assign(document.createElement("canvas"), { width: 350, height: 120 });
  function copy(canvas) {
    const context = small.getContext("2d", { willReadFrequently: true });
    context.globalCompositeOperation = "copy";
    context.drawImage(canvas, 0, 0, small.width, small.height);
    return context.getImageData(0, 0, small.width, small.height).data.join();
  }

  /** ms from the next key to a picture of another line, which an answer asked after it has given. */
  function follows(selector) {
    const canvas = document.querySelector(selector);
    const before = copy(canvas);
    const known = asked.length;
    return new Promise((done, fail) => {
      addEventListener("keydown", async ({ timeStamp }) => {
        while (performance.now() - timeStamp < 10_000) {
          await painted();
          if (asked.slice(known).some(({ to }) => to !== null) && copy(canvas) !== before) {
            return done({ all: performance.now() - timeStamp, answer: asked[known].to - asked[known].from });
          }
        }
        fail(new Error("the line did not follow the key"));
      }, { capture: true, once: true });
    });
  }

  /** Move a slider for so many ms: how often a second other numbers are seen, and how many coarse. */
  async function slide(slider, ms, warm = 1000) {
    const field = document.querySelector(slider);
    const middle = Number(field.value);
    const reach = Math.min(middle - field.min, field.max - middle) / 2;
    const text = () => document.querySelector(".statics > .numbers")?.innerText;
    let [seen, coarse, before] = [0, 0, text()];
    const begin = performance.now() + warm;
    for (let now = begin; now < begin + ms; now = await frame()) {
      field.value = String(middle + reach * Math.sin((now - begin) / 400));
      field.dispatchEvent(new Event("input", { bubbles: true }));
      const is = text();
      if (is === before) continue;
      before = is;
      if (now < begin) continue;
      seen++;
      coarse += document.querySelector(".statics .draft").innerText !== "";
    }
    return { rate: (1000 * seen) / ms, coarse: coarse / Math.max(seen, 1) };
  }

  /** Answers a second in full resolution, two questions under way as the page has them. */
  async function full(field, unit, middle, ms) {
    const { body } = asked.findLast((one) => one.body.want.length > 1);
    let [answers, number] = [0, 1e6];
    const begin = performance.now();
    const ask = async () => {
      while (performance.now() - begin < ms) {
        const value = `${(middle * (1 + 0.001 * (number % 50))).toFixed(3)} ${unit}`;
        const question = { ...body, want: ["droppers", "supports", "elasticity"], draft: false, changes: { [field]: value } };
        const sent = { method: "POST", body: JSON.stringify({ ...question, question: ++number }), headers: { "Content-Type": "application/json" } };
        const answer = await (await fetched("api/statics", sent)).json();
        if (!answer.errors || answer.errors.length) throw new Error(JSON.stringify(answer.error ?? answer.errors));
        answers += answer.dropped ? 0 : 1;
      }
    };
    await Promise.all([ask(), ask()]);
    return (1000 * answers) / (performance.now() - begin);
  }

  /** Turn the wheel over a chart, in and out again, or move it to and fro: one event a frame. */
  function gesture(selector, kind) {
    const over = document.querySelector(`${selector} .u-over`);
    const { left, top, width, height } = over.getBoundingClientRect();
    const place = { clientX: left + width / 2, clientY: top + height / 2, bubbles: true, cancelable: true };
    if (kind === "zoom") {
      return (n) => over.dispatchEvent(new WheelEvent("wheel", { ...place, ctrlKey: true, deltaY: n % 120 < 60 ? -50 : 50 }));
    }
    // Of all of it nothing is left to be moved to.
    for (let n = 0; n < 30; n++) over.dispatchEvent(new WheelEvent("wheel", { ...place, ctrlKey: true, deltaY: -50 }));
    const step = (type, x) => new PointerEvent(type, { ...place, clientX: place.clientX + x, shiftKey: true, button: 0, buttons: 1, pointerId: 1 });
    return (n) => over.dispatchEvent(step(n === 0 ? "pointerdown" : "pointermove", 0.25 * width * Math.sin(n / 10)));
  }

  window.measured = { asked, follows, full, gesture, mark, pictures, play, shownTime, slide };
})();
