// SPDX-License-Identifier: MIT
// What AO takes here: timed once nothing moves, in turns with `learnopengl` while the costs are open.
import {SLOT} from "./app.js";
import {debounce} from "./dom.js";
import {round} from "./scale.js";

const UNIT = "learnopengl";  // whose AO is the unit of costs, as in `crevice bench`
const TIME_AFTER_MS = 400;   // of the last frame
const ROUNDS = 5;            // of turns,
const LEAST_ROUNDS = 3;      // or as many, from these on,
const ROUNDS_MS = 1000;      // as fit in this time

export const ms = x => `${x >= 1000 ? Math.round(x) : round(x, 3)} ms`;
export const median = values => [...values].sort((a, b) => a - b)[values.length >> 1];

/// Milliseconds of the passes that draw no geometry, up to the last that writes "ao": what a host with depth pays.
export function occlusionMs(plan, passes) {
  const target = plan.outputs.find(output => output.name === "ao")?.target;
  const last = plan.passes.map(pass => (pass.color ?? []).some(each => each.target === target)).lastIndexOf(true);
  return passes.reduce((sum, pass, i) => sum + (i <= last && plan.passes[i]?.type !== "draw" ? pass.ms : 0), 0);
}

export class Timing {
  constructor(app) {
    Object.assign(this, {app, sides: [], frames: 0});
    this.later = debounce(TIME_AFTER_MS, () => app.guard(() => this.time()));
    app.on("drawn", () => ++this.frames);
    for (const event of ["drawn", "tab"]) app.on(event, () => this.later());
  }

  /// Leaves in `sides` what each config took, and emits "times". What is drawn meanwhile is timed afterwards.
  async time() {
    const {app, frames} = this, {tab} = app;
    if (this.timing) return void (this.again = true);
    if (!app.stateA() || app.drawing.failed) return;
    Object.assign(this, {timing: true, again: false});
    const sides = this.listed(), begin = performance.now(), {runs} = sides[0];
    const changed = () => frames !== this.frames || tab !== app.tab || app.drawing.isPending();
    for (let turn = 0; turn < ROUNDS && !changed() && (turn < LEAST_ROUNDS || performance.now() - begin < ROUNDS_MS); ++turn)
      await this.takeTurn(sides);
    this.timing = false;
    if (this.again) this.later();
    if (changed() || !runs.length) return;
    this.sides = sides.map(side => ({...side, ao_ms: median(side.runs.map(run => run.ao_ms))}));
    app.emit("times");
  }
  // A run of each, or of none where the GPU's timer is disturbed.
  async takeTurn(sides) {
    const {app} = this, runs = [];
    for (const {slot} of sides) {
      const answer = await app.engine.timed(slot);
      if (!app.must(() => answer).ok || answer.total_ms < 0) return;
      runs.push({...answer, ao_ms: occlusionMs(app.engine.plan(slot), answer.passes)});
      await new Promise(done => setTimeout(done));
    }
    runs.forEach((run, i) => sides[i].runs.push(run));
  }
  listed() {
    const {app} = this, sides = [{slot: SLOT.a, config: app.a.config}];
    if (app.needsB() && app.b.config) sides.push({slot: SLOT.b, config: app.b.config});
    if (app.tab === "cost" && app.ask(() => app.engine.load(SLOT.unit, {config: UNIT, outputs: ["ao"]})).ok)
      sides.push({slot: SLOT.unit, config: UNIT});
    return sides.map(side => ({...side, runs: []}));
  }

  /// "AO 1.8 ms" of a slot, once that config is timed.
  said(slot, config) {
    const side = this.sides.find(each => each.slot === slot && each.config === config);
    return `AO ${side ? ms(side.ao_ms) : "… ms"}`;
  }
}
