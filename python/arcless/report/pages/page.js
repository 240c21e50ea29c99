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

    // ---- what the pointer shows: in the colours of the page, also in dark ----------------------
    const tips = `:host { --tooltip-color: var(--paper); --tooltip-text: var(--ink); --tooltip-border: var(--soft); --tooltip-arrow-color: var(--soft); font: 12px/1.4 var(--font-text); border-radius: 4px; padding: 5px 8px; }
      .bk-tooltip-row-label { color: var(--soft); } .bk-tooltip-row-value { padding-left: 6px; font-variant-numeric: tabular-nums; }`;
    for (const plot of plots) {
      for (const one of view_of(plot)?.tool_views.values() ?? []) {
        for (const tip of one.ttmodels?.values() ?? []) tip.stylesheets = [tips];
      }
    }

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
      const whole = data.track.whole || [range.start, range.end];
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
        return after > 0 ? `, span ${after + (data.track.first || 1) - 1}` : "";
      };
      cross.properties.location.change.connect(() => {
        const x = cross.location;
        if (output) output.textContent = Number.isFinite(x) ? `${x.toFixed(1)} m${name(x)}` : "";
      });
    }

    // ---- heights drawn larger than lengths: how much, at this size and zoom --------------------
    for (const output of $("[data-exaggeration]")) {
      const place = $(`[data-key="${output.dataset.exaggeration}"]`)[0];
      const plot = plots.find((one) => data.places[one.id] === place?.id);
      if (!plot) continue;
      const tell = () => {
        const scale = (size, range) => size / Math.abs(range.end - range.start);
        const ratio = scale(plot.inner_height, plot.y_range) / scale(plot.inner_width, plot.x_range);
        if (ratio > 0 && Number.isFinite(ratio)) output.textContent = `, here ${Number(ratio.toPrecision(2))} times`;
      };
      for (const range of [plot.x_range, plot.y_range]) range.change.connect(tell);
      plot.properties.inner_width.change.connect(tell);
      plot.properties.inner_height.change.connect(tell);
      tell();
    }

    // ---- tables of variants: sorted by a title, selected together with the figures ------------
    for (const table of $("table[data-selection]")) {
      const source = model(table.dataset.selection);
      const body = table.tBodies[0], rows = [...body.rows], said = $("p.chosen")[0];
      const place = new Map(rows.map((row, index) => [row, index]));
      const show = () => {
        const chosen = new Set(source.selected.indices);
        rows.forEach((row, index) => row.classList.toggle("chosen", chosen.has(index)));
        if (said) said.textContent = chosen.size ? `${chosen.size} of ${rows.length} selected` : "";
        const first = body.querySelector(".chosen"), box = table.closest(".tall");
        if (first && box) box.scrollTop = first.offsetTop - table.tHead.offsetHeight;
      };
      source.selected.properties.indices.change.connect(show);
      body.addEventListener("click", (event) => {
        const index = place.get(event.target.closest("tr"));
        if (index === undefined) return;
        const chosen = source.selected.indices;
        source.selected.indices = chosen.includes(index) ? chosen.filter((one) => one !== index) : [...chosen, index];
      });
      for (const button of $("[data-sort]", table)) {
        button.addEventListener("click", () => {
          const title = button.closest("th"), values = source.data[button.dataset.sort];
          const sign = title.getAttribute("aria-sort") === "ascending" ? -1 : 1;
          for (const one of $("th", table)) one.removeAttribute("aria-sort");
          title.setAttribute("aria-sort", sign > 0 ? "ascending" : "descending");
          const key = (row) => values[place.get(row)];
          const none = (value) => Number(Number.isNaN(value));  // the last ones either way
          body.append(...[...rows].sort((a, b) =>
            none(key(a)) - none(key(b)) || sign * (key(a) - key(b)) || place.get(a) - place.get(b)));
        });
      }
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
    // Three figures of the usual height fit on a sheet at this part of it; high ones have rows of
    // signs, which need theirs.
    const lower = (height) => Math.round((height > 450 ? 0.92 : 0.76) * height);
    const heights = new Map(plots.map((plot) => [plot, plot.height]));
    addEventListener("beforeprint", () => {
      if (copies.length) return;
      for (const part of $("details:not([open])")) {
        if (!part.hasAttribute("data-screen")) { part.open = true; opened.push(part); }
      }
      paint("light");
      root.classList.add("printing");
      for (const [plot, height] of heights) plot.height = lower(height);
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
      for (const [plot, height] of heights) plot.height = height;
      paint(scheme());
      lay_out();
    });
    root.classList.add("drawn");
  });

  // ---- tables as files -------------------------------------------------------------------------
  const cells = (id) => $("tr", document.getElementById(id)).map((row) =>
    [...row.cells].map((cell) => cell.textContent.trim().replace(/\u2212(?=\d)/g, "-").replace(/^\u2013$/, "")));
  for (const button of $("[data-download]")) {
    button.addEventListener("click", () => {
      const quoted = (text) => (/[",\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text);
      const text = cells(button.dataset.download).map((row) => row.map(quoted).join(",")).join("\r\n");
      const link = document.createElement("a");
      // The mark at the beginning tells spreadsheets that the text is UTF-8.
      link.href = URL.createObjectURL(new Blob(["\ufeff", text, "\r\n"], { type: "text/csv" }));
      link.download = button.dataset.file;
      link.click();
      setTimeout(() => URL.revokeObjectURL(link.href), 1000);
    });
  }
  for (const button of $("[data-copy]")) {
    button.hidden = !navigator.clipboard;
    button.addEventListener("click", async () => {
      await navigator.clipboard.writeText(cells(button.dataset.copy).map((row) => row.join("\t")).join("\n"));
      button.textContent = "Copied";
    });
  }

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
      const link = links.get(entry.target.id);
      if (!link) continue;
      link.setAttribute("aria-current", "true");
      const list = link.closest("ol");  // a row that is scrolled sideways on small screens
      list.scrollLeft = link.offsetLeft - list.offsetLeft - 12;
    }
  }, { rootMargin: "-10% 0px -80% 0px" });
  for (const part of $("main section[id]")) seen.observe(part);
})();
