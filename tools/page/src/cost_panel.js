// SPDX-License-Identifier: MIT
// What a frame costs here: milliseconds a pass, bytes of textures, and all configs against each other.
import {$, add, button, debounce} from "./dom.js";
import {measureAll} from "./measure_all.js";
import {shown} from "./scale.js";
import {scatter} from "./scatter.js";
import {error, ms} from "../../report/chart.js";

const TIME_AFTER_MS = 400;  // of the last change, while the tab is open
const TIMES = 3;            // the median of so many frames,
const TIMES_MS = 600;       // or of those that fit in this time
const BY = {"gpu timer": "timer queries", processor: "the processor's time", "wall clock": "a clock around each pass"};

export class CostPanel {
  constructor(app) {
    Object.assign(this, {app, root: $("cost"), result: null, running: null});
    this.build();
    this.later = debounce(TIME_AFTER_MS, () => app.during("timing", () => this.time()));
    app.on("tab", () => this.wake());
    for (const event of ["loaded", "values", "size"]) app.on(event, () => this.wake());
    app.on("drawn", () => this.showFrame());
  }

  build() {
    const {root, app} = this;
    this.machine = add(root, "p", {class: "soft", id: "machine"}, app.engine.machine.renderer);
    this.frame = add(root, "p", {class: "soft", id: "frame-time"});
    const row = add(root, "div", {class: "row"});
    button(row, "Measure passes", () => app.during("timing", () => this.time()), {id: "measure"});
    this.bars = add(root, "div", {class: "bars", id: "bars"});
    add(root, "h2", {}, "All configs on this machine");
    add(root, "p", {class: "soft"}, "Time and error of each shipped config on the present view, against the picture traced " +
      "at A's radius. Takes one to two minutes; keep the page in view.");
    const all = add(root, "div", {class: "row"});
    this.start = button(all, "Measure all", () => this.measureAll(), {id: "measure-all"});
    this.stop = button(all, "Cancel", () => this.running.cancelled = true, {hidden: "", id: "measure-cancel"});
    this.progress = add(all, "progress", {max: 1, value: 0, hidden: "", "aria-label": "Configs measured"});
    this.step = add(all, "output", {class: "soft"});
    this.all = add(root, "div", {id: "all-configs"});
  }

  wake() {
    if (this.app.tab !== "cost" || this.running) return;
    this.later();
    if (this.result) this.showAll();
  }
  showFrame() {
    const time = this.app.drawing.frameTime();
    if (this.app.tab === "cost")
      this.frame.textContent = time ? `${ms(time)} from frame to frame, by the browser's clock (at least one refresh of the screen).`
                                    : "Frames are drawn only when something changes: turn the picture to see their time.";
  }

  // One at a time: what changes meanwhile is timed afterwards.
  async time() {
    if (this.timing) return void (this.again = true);
    this.timing = true;
    try {
      await this.timeOnce();
    } finally {
      this.timing = false;
    }
    if (this.again) this.wake();
    this.again = false;
  }
  async timeOnce() {
    const {app} = this, runs = [], begin = performance.now();
    if (!app.stateA() || this.running) return;
    for (let i = 0; i < TIMES && !this.again && (i === 0 || performance.now() - begin < TIMES_MS); ++i) {
      const answer = await app.ask(() => app.engine.timed(0));
      if (!answer.ok) return app.must(() => answer);
      runs.push(answer);
    }
    const middle = runs.sort((a, b) => a.total_ms - b.total_ms)[runs.length >> 1];
    this.showBars(middle);
  }
  showBars({passes, total_ms, by}) {
    const {bars, app} = this, most = Math.max(...passes.map(p => p.ms), 1e-6), plan = app.engine.plan(0);
    bars.replaceChildren();
    add(bars, "p", {}, `${ms(total_ms)} a frame by ${BY[by] ?? by}; ${(plan.texture_bytes / 1e6).toFixed(2)} MB of textures ` +
      `at ${app.engine.size.join(" × ")}.`);
    const table = add(bars, "table", {"aria-label": "Milliseconds a pass"});
    for (const pass of passes) {
      const line = add(table, "tr");
      add(line, "th", {scope: "row"}, pass.name);
      add(add(line, "td", {class: "wide-cell"}), "span", {class: "bar-of", style: `width:${100 * Math.max(0, pass.ms) / most}%`});
      add(line, "td", {class: "num"}, ms(pass.ms));
    }
  }

  measureAll() {
    const {app} = this, running = this.running = {cancelled: false};
    this.start.disabled = true;
    this.stop.hidden = this.progress.hidden = false;
    app.drawing.play(null);
    app.drawing.setTurntable(false);
    return app.during("measuring", async () => {
      try {
        const result = await measureAll(app, step => this.showStep(step), () => running.cancelled);
        this.step.textContent = result ? "" : "Cancelled.";
        if (result) this.result = result;
        this.showAll();
      } finally {
        this.running = null;
        this.start.disabled = false;
        this.stop.hidden = this.progress.hidden = true;
      }
    });
  }
  showStep({done, of, what}) {
    this.progress.value = done / of;
    this.step.textContent = what;
  }

  showAll() {
    const {all, app, result} = this;
    if (!result) return;
    all.replaceChildren();
    const {samples, failures, without, radius, size, scene} = result, drawn = samples.filter(s => s.ms > 0);
    const select = config => app.chooseConfig(config);
    add(all, "p", {class: "soft"}, `${scene}, ${size}, radius ${shown(radius)}:`);
    if (drawn.length)
      scatter(add(all, "div", {class: "pareto"}), {samples: drawn, without, chosen: app.a.config, select});
    const table = add(add(all, "div", {class: "scroll"}), "table", {class: "figures"});
    const head = add(table, "tr");
    for (const name of ["config", "ms", "rmse", "bias", "p99"]) add(head, "th", {scope: "col", class: name === "config" ? null : "num"}, name);
    for (const sample of [...samples].sort((a, b) => a.rmse - b.rmse)) {
      const line = add(table, "tr", {class: sample.config === app.a.config ? "on" : null});
      button(add(line, "td"), sample.config, () => select(sample.config), {class: "link"});
      for (const text of [ms(sample.ms).replace(" ms", ""), error(sample.rmse), sample.bias.toFixed(3), sample.p99.toFixed(3)])
        add(line, "td", {class: "num"}, text);
    }
    for (const each of failures) add(all, "p", {class: "soft"}, `${each.config}: ${each.failure}`);
  }
}
