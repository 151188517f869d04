// SPDX-License-Identifier: MIT
// What a frame costs here: AO beside that of others, milliseconds a pass, bytes of textures.
import {SLOT} from "./app.js";
import {$, add, button} from "./dom.js";
import {round} from "./scale.js";
import {median, ms} from "./timing.js";

export function makeCosts(app) {
  const root = $("cost");
  add(root, "p", {class: "soft"}, app.engine.machine.renderer);
  button(root, "Measure again", () => app.timing.time());
  const bars = add(root, "div", {class: "bars", id: "bars"});
  app.on("times", () => {
    if (app.tab !== "cost") return;
    bars.replaceChildren();
    showTurns(bars, app.timing.sides);
    showPasses(app, bars, app.timing.sides[0].runs);
  });
}

// AO of each config as multiples of the last one's, turn by turn; grey where the turns of two overlap.
function showTurns(parent, sides) {
  const unit = sides.at(-1), table = add(parent, "table", {id: "turns", "aria-label": "AO of configs, timed in turns"});
  const rows = sides.map(({config, runs, ao_ms}) => {
    const ratios = runs.map((run, i) => run.ao_ms / (unit.runs[i]?.ao_ms || NaN)).filter(Number.isFinite);
    return {config, ao_ms, ratio: median(ratios), least: Math.min(...ratios), most: Math.max(...ratios)};
  });
  for (const row of rows) {
    const overlaps = rows.some(other => other !== row && !(other.most < row.least || row.most < other.least));
    const line = add(table, "tr", {class: overlaps ? "soft" : null, title: overlaps ? "Too close to another to tell them apart" : null});
    add(line, "th", {scope: "row"}, row.config);
    add(line, "td", {class: "num"}, "AO " + ms(row.ao_ms));
    add(line, "td", {}, `${round(row.ratio, 2)} of ${unit.config} (${round(row.least, 2)} to ${round(row.most, 2)})`);
  }
}

// Medians over the runs.
function showPasses(app, parent, runs) {
  const passes = runs[0].passes.map(({name}, i) => ({name, ms: median(runs.map(run => run.passes[i].ms))}));
  const most = Math.max(...passes.map(p => p.ms), 1e-6), plan = app.engine.plan(SLOT.a);
  add(parent, "p", {}, `${ms(median(runs.map(run => run.total_ms)))} a frame by ${runs[0].by}, medians of ` +
    `${runs.length} turns; ${(plan.texture_bytes / 1e6).toFixed(2)} MB of textures at ${app.engine.size.join(" × ")}.`);
  const table = add(parent, "table", {id: "passes", "aria-label": "Milliseconds a pass"});
  for (const pass of passes) {
    const line = add(table, "tr");
    add(line, "th", {scope: "row"}, pass.name);
    add(add(line, "td", {class: "wide-cell"}), "span", {class: "bar-of", style: `width:${100 * Math.max(0, pass.ms) / most}%`});
    add(line, "td", {class: "num"}, ms(pass.ms));
  }
}

/// The plan as `crevice explain` prints it: passes, textures, and what is left out with its reason.
export function makePlan(app) {
  const text = add($("plan"), "pre", {id: "plan-text", tabindex: 0, "aria-label": "The plan"});
  const show = () => {
    if (app.tab !== "plan" || !app.stateA()) return;
    text.textContent = app.engine.planText(0);
    text.style.setProperty("--columns", Math.max(...text.textContent.split("\n").map(line => line.length)));
  };
  for (const event of ["tab", "loaded", "values", "size"]) app.on(event, show);
}
