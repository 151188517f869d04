// SPDX-License-Identifier: MIT
// What a frame costs here: milliseconds a pass, bytes of textures, and all configs against each other.
import {$, add, button, debounce} from "./dom.js";
import {measureAll, medianTime} from "./measure.js";
import {round, shown} from "./scale.js";

const TIME_AFTER_MS = 400;  // of the last change, while the tab is open
const BY = {"gpu timer": "timer queries", processor: "the processor's time", "wall clock": "a clock around each pass"};
const ms = x => `${x >= 1000 ? Math.round(x) : round(x, 3)} ms`;

export class CostPanel {
  constructor(app) {
    Object.assign(this, {app, root: $("cost"), result: null, running: null});
    this.build();
    this.later = debounce(TIME_AFTER_MS, () => this.time());
    for (const event of ["tab", "loaded", "values", "size"]) app.on(event, () => this.wake());
  }

  build() {
    const {root, app} = this;
    add(root, "p", {class: "soft"}, app.engine.machine.renderer);
    button(add(root, "div", {class: "row"}), "Measure passes", () => this.time());
    this.bars = add(root, "div", {class: "bars", id: "bars"});
    add(root, "h2", {}, "All configs on this machine");
    add(root, "p", {class: "soft"}, "Time and error of each shipped config on the present view, against the picture traced " +
      "at A's radius. Takes one to two minutes; keep the page in view.");
    const row = add(root, "div", {class: "row"});
    this.start = button(row, "Measure all", () => this.measureAll(), {id: "measure-all"});
    this.stop = button(row, "Cancel", () => this.running.cancelled = true, {hidden: ""});
    this.progress = add(row, "progress", {max: 1, value: 0, hidden: "", "aria-label": "Configs measured"});
    this.step = add(row, "output", {class: "soft"});
    this.all = add(root, "div", {id: "all-configs"});
  }

  wake() {
    if (this.app.tab !== "cost" || this.running) return;
    this.later();
    if (this.result) this.showAll();
  }

  // One at a time: what changes meanwhile is timed afterwards.
  async time() {
    const {app} = this;
    if (this.timing) return void (this.again = true);
    if (!app.stateA() || this.running) return;
    this.timing = true;
    const answer = await app.during(() => medianTime(app, 0, () => this.again));
    this.timing = false;
    if (answer?.ok) this.showBars(answer);
    else if (answer) app.must(() => answer);
    if (this.again) this.wake();
    this.again = false;
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
    return app.during(async () => {
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
    const {samples, failures, radius, size, scene} = result, front = frontOf(samples);
    add(all, "p", {class: "soft"}, `${scene}, ${size}, radius ${shown(radius)}; those that no other beats in time and error are marked:`);
    const table = add(add(all, "div", {class: "scroll"}), "table", {class: "figures"}), head = add(table, "tr");
    for (const name of ["config", "ms", "rmse", "bias", "p99"]) add(head, "th", {scope: "col", class: name === "config" ? null : "num"}, name);
    for (const sample of [...samples].sort((a, b) => a.rmse - b.rmse)) {
      const line = add(table, "tr", {class: sample.config === app.a.config ? "on" : null}), name = add(line, "td");
      button(name, sample.config, () => app.chooseConfig(sample.config), {class: "link"});
      if (front.has(sample)) add(name, "strong", {}, " ●");
      for (const text of [ms(sample.total_ms).replace(" ms", ""), sample.rmse.toFixed(4), sample.bias.toFixed(3), sample.p99.toFixed(3)])
        add(line, "td", {class: "num"}, text);
    }
    for (const each of failures) add(all, "p", {class: "soft"}, `${each.config}: ${each.failure}`);
  }
}

function frontOf(samples) {
  let best = Infinity;
  const sorted = [...samples].sort((a, b) => a.total_ms - b.total_ms || a.rmse - b.rmse);
  return new Set(sorted.filter(s => s.rmse < best && (best = s.rmse, true)));
}
