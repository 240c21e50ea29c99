// What tests ask of a page; it is there before the page's own scripts are.
globalThis.tried = (() => {
  const TIMER = 17;  // ms: Bokeh paints no sooner after the last time
  const watched = new Set();
  let paints = 0;
  const watch = () => {
    for (const plot of globalThis.arcless?.plots ?? []) {
      const view = Bokeh.index.get_by_id(plot.id);
      if (!view || watched.has(view)) continue;
      watched.add(view);
      view.repainted.connect(() => { paints++; });
    }
  };
  const frame = () => new Promise((resolve) => requestAnimationFrame(resolve));
  const figures = () => [...document.querySelectorAll(".plot [data-key]")];
  const keys = () => figures().map((one) => one.dataset.key);
  const place = (key) => document.querySelector(`.plot [data-key="${key}"]`);
  const plot = (key) => arcless.plots.find((one) => `plot-${one.id}` === place(key).id);
  const view = (key) => Bokeh.index.get_by_id(plot(key).id);
  // The frame of a figure in its canvas, in px.
  const inner = (key) => {
    const { left, top, width, height } = view(key).frame.bbox;
    return { left, top, width, height };
  };
  const layer = (key, name) => view(key).canvas_view[name].canvas;

  // A copy is read: a canvas that is read again and again makes the browser complain.
  const pixels = (key, name = "primary") => {
    const from = layer(key, name);
    const copy = document.createElement("canvas");
    [copy.width, copy.height] = [from.width, from.height];
    const context = copy.getContext("2d", { willReadFrequently: true });
    if (!(from.width * from.height)) return { width: 0, height: 0, data: new Uint32Array() };
    context.drawImage(from, 0, 0);
    const { width, height, data } = context.getImageData(0, 0, copy.width, copy.height);
    return { width, height, data: new Uint32Array(data.buffer) };
  };
  const ink = (key, name) => pixels(key, name).data.reduce((count, value) => count + (value !== 0), 0);
  // A number that differs where a picture does.
  const hash = (key, name) => {
    let sum = 0;
    for (const value of pixels(key, name).data) sum = (Math.imul(sum, 31) + value) | 0;
    return sum;
  };
  // Sides of the canvas whose last row or column of pixels is painted: something is cut there.
  const cut = (key) => {
    const { width, height, data } = pixels(key);
    const found = new Set();
    const look = (x, y, side) => data[y * width + x] && found.add(side);
    for (let x = 0; x < width; x++) look(x, 0, "top"), look(x, height - 1, "bottom");
    for (let y = 0; y < height; y++) look(0, y, "left"), look(width - 1, y, "right");
    return [...found].map((side) => `${key}: ${side}`);
  };
  // Number of pixels with this colour, "#rrggbb".
  const coloured = (key, colour) => {
    const [red, green, blue] = [1, 3, 5].map((at) => parseInt(colour.slice(at, at + 2), 16));
    const wanted = ((255 << 24) | (blue << 16) | (green << 8) | red) >>> 0;
    return pixels(key).data.reduce((count, value) => count + (value === wanted), 0);
  };
  // Columns of a canvas that are painted over more than half of its height.
  const columns = (key, name) => {
    const { width, height, data } = pixels(key, name);
    const counts = new Uint32Array(width);
    data.forEach((value, at) => { counts[at % width] += value !== 0; });
    return [...counts.keys()].filter((x) => counts[x] > height / 2);
  };
  return {
    keys, plot, view, ink, inner, hash, cut, coloured, columns,
    // Bokeh paints in an animation frame after a timer after the change, and once more after a new
    // layout; on a busy machine all of them are late. Settled is a page that paints no more.
    settled: async () => {
      watch();
      for (let turn = 0, before = -1; turn < 200 && before !== paints; turn++) {
        before = paints;
        await new Promise((resolve) => setTimeout(resolve, 2 * TIMER));
        await frame();
        await frame();
      }
    },
    frame: (key) => {
      place(key).scrollIntoView({ block: "center", behavior: "instant" });
      const { x, y } = view(key).canvas_view.el.getBoundingClientRect();
      const { left, top, width, height } = inner(key);
      return { x: x + left, y: y + top, width, height };
    },
    // Keys of the figures along the track, in their order on the page.
    track: () => keys().filter((key) => plot(key).x_range.id === arcless.data.groups.track?.range),
    range: () => {
      const { start, end } = arcless.doc.get_model_by_id(arcless.data.groups.track.range);
      return [start, end];
    },
    // The range as each figure along the track draws it.
    ranges: () => tried.track().map((key) => {
      const { start, end } = view(key).frame.x_scale.source_range;
      return [start, end];
    }),
    // Entries of all legends, pressed twice: name, then [pressed, all and any visible] three times.
    entries: () => [...document.querySelectorAll(".legend button")].map((button) => {
      const drawn = button.dataset.drawn.split(" ").map((id) => arcless.doc.get_model_by_id(id));
      const state = () => [
        button.ariaPressed === "true", drawn.every((one) => one.visible), drawn.some((one) => one.visible),
      ];
      const seen = [button.textContent, state()];
      for (let times = 0; times < 2; times++) button.click(), seen.push(state());
      return seen;
    }),
    // Keys of figures in which nothing is painted.
    empty: () => keys().filter((key) => !ink(key)),
    reset: () => {
      for (const key of keys()) view(key).reset();
      const touch = matchMedia("(pointer: coarse)").matches;
      if (!touch) document.querySelector("[data-drag=zoom]")?.click();
    },
    cross: () => arcless.doc.get_model_by_id(arcless.data.groups.track.cross),
    // Width in px by which the page is wider than its window.
    overflow: () => document.documentElement.scrollWidth - document.documentElement.clientWidth,
    // Texts of a kind that are wider than their box, or leave the window.
    clipped: (selector) => [...document.querySelectorAll(selector)].filter((one) => {
      const box = one.getBoundingClientRect();
      // What a drawing has outside of its frame is cut on purpose.
      if (!box.width || one.closest('[clip-path]')) return false;
      const hidden = getComputedStyle(one).overflowX !== "visible";
      if (hidden && one.scrollWidth > one.clientWidth + 1) return true;
      const around = (one.ownerSVGElement ?? document.documentElement).getBoundingClientRect();
      return box.left < around.left - 1 || box.right > around.right + 1;
    }).map((one) => one.textContent.trim().slice(0, 80)),
    // Attributes that do not have the colour of their token: [token, object, attribute, found].
    wrong_colours: (scheme) => Object.entries(arcless.data.colours).flatMap(([token, places]) =>
      places.flatMap(([id, attribute]) => {
        const value = arcless.doc.get_model_by_id(id)[attribute];
        const found = value && typeof value === "object" && "value" in value ? value.value : value;
        return found === arcless.data.schemes[scheme][token] ? [] : [[token, id, attribute, found]];
      })),
    background: () => getComputedStyle(document.body).backgroundColor,
    // Where a point of each kind in a figure is, in px from the corner of the frame.
    points: (key) => {
      const { left, top, width, height } = inner(key);
      const { x_scale, y_scale } = view(key).frame;
      return plot(key).renderers.filter((one) => one.glyph?.type === "Scatter").flatMap((one) => {
        const { data } = one.data_source;
        const column = (name) => (data instanceof Map ? data.get(name) : data[name]);
        const [xs, ys] = [column(one.glyph.x.field), column(one.glyph.y.field)];
        const places = [...xs].map((x, i) => [x_scale.compute(x) - left, y_scale.compute(ys[i]) - top]);
        const shown = places.filter(([x, y]) => x > 0 && y > 0 && x < width && y < height);
        return shown.length ? [shown[Math.floor(shown.length / 2)]] : [];
      });
    },
    // Texts of the tooltips, and names of all elements in them.
    tooltips: () => {
      const found = { texts: [], elements: [] };
      const search = (within) => {
        for (const one of within.querySelectorAll("*")) {
          if (one.classList.contains("bk-tooltip-content")) {
            found.texts.push(one.textContent);
            found.elements.push(...[...one.querySelectorAll("*")].map((part) => part.localName));
          }
          if (one.shadowRoot) search(one.shadowRoot);
        }
      };
      search(document);
      return found;
    },
  };
})();
