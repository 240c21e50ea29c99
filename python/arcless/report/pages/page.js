"use strict";
// Draws the figures, and links what the reader does: cross hair, zoom, legends, light and dark, print.
(() => {
  const data = JSON.parse(document.getElementById("data").textContent);
  const root = document.documentElement;
  const $ = (selector, within = document) => [...within.querySelectorAll(selector)];

  Bokeh.set_log_level("warn");

  // ---- figures -------------------------------------------------------------------------------
  const items = [{ docid: "page", roots: data.places, root_ids: Object.keys(data.places) }];
  const ready = items[0].root_ids.length
    ? Bokeh.embed.embed_items({ page: data.objects }, items)
    : Promise.resolve([]);

  ready.then((views) => {
    const doc = Bokeh.documents[Bokeh.documents.length - 1];
    const model = (id) => doc.get_model_by_id(id);
    const plots = doc ? doc.roots().filter((one) => one.type === "Plot" || one.type === "Figure") : [];
    const view_of = (plot) => Bokeh.index.get_by_id(plot.id);
    window.arcless = { doc, plots, data };  // for tests, and for those who look behind the page

    // ---- light and dark --------------------------------------------------------------------
    const system = matchMedia("(prefers-color-scheme: dark)");
    const scheme = () => root.dataset.scheme || (system.matches ? "dark" : "light");
    const paint = (name) => {
      for (const [token, places] of Object.entries(data.colours)) {
        for (const [id, attribute] of places) model(id)?.setv({ [attribute]: data.schemes[name][token] });
      }
    };
    const apply = () => {
      paint(scheme());
      for (const button of $("[data-scheme-switch]")) {
        button.textContent = scheme() === "dark" ? "Light" : "Dark";
      }
    };
    for (const button of $("[data-scheme-switch]")) {
      button.addEventListener("click", () => {
        root.dataset.scheme = scheme() === "dark" ? "light" : "dark";
        apply();
      });
    }
    system.addEventListener("change", apply);
    apply();

    // ---- legends ---------------------------------------------------------------------------
    for (const button of $(".legend button")) {
      button.addEventListener("click", () => {
        const shown = button.getAttribute("aria-pressed") !== "true";
        button.setAttribute("aria-pressed", String(shown));
        for (const id of button.dataset.drawn.split(" ")) model(id).visible = shown;
      });
    }

    // ---- dragging, and back ----------------------------------------------------------------
    const touch = matchMedia("(pointer: coarse)").matches;
    const drag = (kind) => {
      for (const plot of plots) {
        const wanted = kind === "pan" ? "PanTool" : "BoxZoomTool";
        const first = plot.toolbar.tools[0];
        const chosen = kind === "zoom" && first.type === "BoxSelectTool" ? first : null;
        const tool = chosen || plot.toolbar.tools.find((one) => one.type === wanted);
        for (const one of plot.toolbar.tools) if ("active" in one && /Zoom|Pan|BoxSelect/.test(one.type)) one.active = false;
        if (kind && tool) tool.active = true;
      }
      for (const button of $("[data-drag]")) button.setAttribute("aria-pressed", String(button.dataset.drag === kind));
    };
    for (const button of $("[data-drag]")) button.addEventListener("click", () => drag(button.dataset.drag));
    // A finger that moves over a figure scrolls the page.
    if (touch) drag("");
    for (const plot of plots) plot.on_event("doubletap", () => view_of(plot)?.reset());

    // ---- the track: whole run, section, places ----------------------------------------------
    const track = data.groups.track;
    if (track && data.track.section) {
      const range = model(track.range);
      const whole = [range.start, range.end];
      const show = { all: whole, section: data.track.section };
      for (const button of $("[data-show]")) {
        button.addEventListener("click", () => {
          const [start, end] = show[button.dataset.show];
          range.setv({ start, end });
        });
      }
      const cross = model(track.cross);
      const output = $(".cursor")[0];
      const name = (x) => {
        const after = data.track.supports.findIndex((place) => place > x);
        return after > 0 ? `, span ${after}` : "";
      };
      cross.properties.location.change.connect(() => {
        const x = cross.location;
        if (output) output.textContent = Number.isFinite(x) ? `${x.toFixed(1)} m${name(x)}` : "";
      });
    }

    // ---- print -----------------------------------------------------------------------------
    // Figures are laid out for paper, light, and copied as drawings, while the browser waits:
    // what Bokeh draws itself would be emptied when the browser changes its size, and not redrawn.
    const lay_out = () => {
      for (const plot of plots) {
        const view = view_of(plot);
        if (view) { view.invalidate_layout(); view.repaint(); }
      }
    };
    const opened = [];
    const copies = [];
    addEventListener("beforeprint", () => {
      if (copies.length) return;
      for (const part of $("details:not([open])")) {
        if (!part.hasAttribute("data-screen")) { part.open = true; opened.push(part); }
      }
      paint("light");
      root.classList.add("printing");
      lay_out();
      for (const plot of plots) {
        const view = view_of(plot);
        if (!view) continue;
        const has_image = plot.renderers.some((one) => one.glyph?.type === "Image");
        const copy = view.export(has_image ? "png" : "svg", true).canvas;
        const width = view.bbox.width, height = view.bbox.height;
        if (!has_image) copy.setAttribute("viewBox", `0 0 ${width} ${height}`);
        copy.setAttribute("class", "paper");
        const place = document.getElementById(data.places[plot.id]);
        place.after(copy);
        copies.push(copy);
      }
      root.classList.add("copied");
    });
    addEventListener("afterprint", () => {
      while (copies.length) copies.pop().remove();
      while (opened.length) opened.pop().open = false;
      root.classList.remove("printing", "copied");
      paint(scheme());
      lay_out();
    });
    root.classList.add("drawn");
  });

  // ---- tables that are larger than their place: scrolled by keys too -------------------------------
  const measure = (one) => {
    if (one.scrollWidth > one.clientWidth || one.scrollHeight > one.clientHeight) one.tabIndex = 0;
    else one.removeAttribute("tabindex");
  };
  const sizes = new ResizeObserver((entries) => entries.forEach((entry) => measure(entry.target)));
  for (const one of $(".scroll")) sizes.observe(one);

  // ---- contents: where the reader is ----------------------------------------------------------
  const links = new Map($("nav.contents a[href^='#']").map((link) => [link.hash.slice(1), link]));
  const seen = new IntersectionObserver((entries) => {
    for (const entry of entries) {
      if (!entry.isIntersecting) continue;
      for (const link of links.values()) link.removeAttribute("aria-current");
      links.get(entry.target.id)?.setAttribute("aria-current", "true");
    }
  }, { rootMargin: "-10% 0px -80% 0px" });
  for (const part of $("main section[id]")) seen.observe(part);
})();
