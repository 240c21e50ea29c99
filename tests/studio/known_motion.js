// Stands in for the stream of a server: a line of twelve spans, and a hump that travels with a pantograph.
(() => {
  const [SPAN, SPANS, STEP, SPEED, ROW, END] = [50, 12, 0.5, 80, 0.01, 5];
  const x = Array.from({ length: (SPAN * SPANS) / STEP + 1 }, (_, node) => node * STEP);
  const level = (z) => x.map(() => z);
  const supports = Array.from({ length: SPANS + 1 }, (_, n) => ({
    name: `support ${n + 1}`, x_m: n * SPAN, stagger_m: 0, wire: 0, node: (n * SPAN) / STEP,
    arms: [{ from: [n * SPAN, 0, 5.3], to: [n * SPAN, 1, 5.6] }],
  }));
  const droppers = Array.from({ length: 5 * SPANS }, (_, n) => {
    const at = 5 + 10 * n;
    return {
      name: `dropper ${n + 1}`, span: Math.floor(at / SPAN) + 1, x_m: at, top: [at, 0, 6.5], bottom: [at, 0, 5.3],
      length_m: 1.2, force_N: 80, wire: 0, node: at / STEP, top_wire: 1, top_node: at / STEP,
    };
  });
  const line = {
    name: "Known line", spatial: false, height_m: 5.3, droppers, supports,
    spans: Array.from({ length: SPANS }, (_, n) => ({ number: n + 1, start_m: n * SPAN, end_m: (n + 1) * SPAN })),
    wires: [
      { name: "contact wire", kind: "contact", first: 0, x, y: level(0), z: level(5.3) },
      { name: "messenger wire", kind: "messenger", first: 0, x, y: level(0), z: level(6.5) },
    ],
  };
  const names = ["wire.0.up", "droppers", "supports", "pantograph.0"];
  const values = ["position", "contact force", "height", "uplift", "mass 1", "mass 2"].map((name) => ({ name, unit: "m" }));
  const up = (at, place) => 0.05 * Math.exp(-(((at - place) / 12) ** 2));
  const known = (window.known = { sockets: [], wants: [], opened: 0, beside: Infinity });

  // What rooms of the server would answer of such a run.
  const answers = {
    "api/run/line": line,
    "api/jobs": [],
    "api/explain": { pantographs: [{ worst: [{ position_m: 320 }, { position_m: 240 }] }] },
  };
  const real = window.fetch;
  window.fetch = (address, options) => {
    const answer = answers[String(address).split("?")[0]];
    return answer ? Promise.resolve(Response.json(answer)) : real(address, options);
  };

  window.WebSocket = class {
    static OPEN = 1;
    readyState = 0;
    constructor() {
      known.sockets.push(this);
      setTimeout(() => {
        this.readyState = 1;
        this.onopen?.();
      });
      setInterval(() => this.readyState === 1 && this.say({ topic: "beat" }), 2000);
    }
    close() {
      this.readyState = 3;
      this.onclose?.();
    }
    say(message) {
      this.onmessage?.({ data: JSON.stringify(message) });
    }
    piece(channel, first, time, numbers) {
      const data = new ArrayBuffer(16 + 4 * numbers.length);
      const view = new DataView(data);
      view.setUint32(0, channel, true);
      view.setUint32(4, first, true);
      view.setFloat64(8, time, true);
      new Float32Array(data, 16).set(numbers);
      this.onmessage?.({ data });
    }
    send(text) {
      const { topic, source, from_s, to_s, every_s, ask } = JSON.parse(text);
      if (topic === "play") {
        this.base = 100 * ++known.opened; // numbers are those of this socket alone
        const channels = names.map((name, n) => ({
          number: this.base + n, name, unit: "m", type: "f32", shape: [x.length],
          about: name === "pantograph.0" ? { name: "P1", values } : { text: name },
        }));
        setTimeout(() => this.say({ topic: "channels", source, channels, start_s: 0, end_s: END, final: true, every_s: ROW, wires: true }));
      }
      if (topic === "want") {
        known.wants.push([from_s, to_s, every_s]);
        setTimeout(() => this.rows(source, from_s, Math.min(to_s, END), every_s || ROW, ask));
      }
    }
    rows(source, from, to, every, ask) {
      for (let time = from; time <= to + 1e-9; time += every) {
        const place = 100 + SPEED * time;
        this.piece(this.base, 0, time, x.map((at) => up(at, place)));
        this.piece(this.base + 1, 0, time, droppers.map(({ x_m }) => Math.max(0, 80 - 2000 * up(x_m, place))));
        this.piece(this.base + 2, 0, time, supports.map(({ x_m }) => up(x_m, place)));
        // Beside the wire, from `known.beside` on, only the position is known.
        const all = [150 + 50 * Math.sin(9 * time), 5.35, 0.05, 0.04, 0.05];
        this.piece(this.base + 3, 0, time, [place, ...(time >= known.beside ? all.map(() => NaN) : all)]);
      }
      this.say({ topic: "sent", source, ask, from_s: from, to_s: to, frames: 1, dropped: 0 });
    }
  };
})();
