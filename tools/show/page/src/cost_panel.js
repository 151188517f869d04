// SPDX-License-Identifier: MIT
// What a frame costs here: milliseconds a pass, bytes of textures.
import {SLOT} from "./app.js";
import {$, add, button, debounce} from "./dom.js";
import {round} from "./scale.js";

const TIME_AFTER_MS = 400;  // of the last change, while the tab is open
const TIMES = 5;            // the median of so many frames,
const TIMES_MS = 1000;      // or of those that fit in this time
const BY = {"gpu timer": "timer queries", processor: "the processor's time", "wall clock": "a clock around each pass"};
const ms = x => `${x >= 1000 ? Math.round(x) : round(x, 3)} ms`;

export class CostPanel {
  constructor(app) {
    this.app = app;
    const root = $("cost");
    add(root, "p", {class: "soft"}, app.engine.machine.renderer);
    button(add(root, "div", {class: "row"}), "Measure passes", () => this.time());
    this.bars = add(root, "div", {class: "bars", id: "bars"});
    this.later = debounce(TIME_AFTER_MS, () => this.time());
    for (const event of ["tab", "loaded", "values", "size"]) app.on(event, () => this.wake());
  }

  wake() {
    if (this.app.tab === "cost") this.later();
  }

  // One at a time: what changes meanwhile is timed afterwards.
  async time() {
    const {app} = this;
    if (this.timing) return void (this.again = true);
    if (!app.stateA()) return;
    this.timing = true;
    const answer = await app.during(() => this.medianTime());
    this.timing = false;
    if (answer?.ok) this.show(answer);
    else if (answer) app.must(() => answer);
    if (this.again) this.wake();
    this.again = false;
  }
  // The answer of the engine's timed() whose total is the median.
  async medianTime() {
    const runs = [], begin = performance.now();
    while (!runs.length || (runs.length < TIMES && performance.now() - begin < TIMES_MS && !this.again)) {
      const answer = await this.app.ask(() => this.app.engine.timed(SLOT.a));
      if (!answer.ok) return answer;
      runs.push(answer);
      await new Promise(done => setTimeout(done));
    }
    return runs.sort((a, b) => a.total_ms - b.total_ms)[runs.length >> 1];
  }

  show({passes, total_ms, by}) {
    const {bars, app} = this, most = Math.max(...passes.map(p => p.ms), 1e-6), plan = app.engine.plan(SLOT.a);
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
}
