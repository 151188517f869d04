// SPDX-License-Identifier: MIT
// Error against run time of all configs in this view, measured here, and which one to take.
import {describe} from "./app.js";
import {$, add, button} from "./dom.js";
import {round} from "./scale.js";
import {ms} from "./timing.js";

const NAME = "chosen";  // of the config that a setting beside a config becomes

export function makeChoice(app) {
  const form = add($("cost"), "form", {class: "choice", onsubmit: event => {
    event.preventDefault();
    app.guard(() => running ? stop() : measure());
  }});
  add(form, "h2", {}, "Which config to take");
  const row = add(form, "div", {class: "row"});
  const budget = add(add(row, "label", {}, "AO takes at most "), "input", {id: "budget", size: 6, placeholder: "2ms, 0.5x"});
  const error = add(add(row, "label", {}, "error at most "), "input", {id: "error", size: 5, placeholder: "0.05", inputmode: "decimal"});
  const start = add(row, "button", {type: "submit", id: "measure-all"}, "Measure all");
  const said = add(form, "p", {class: "soft", "aria-live": "polite", id: "choice-said"},
    "All configs against the ray-traced truth in this view, in turns with learnopengl: about a minute.");
  const table = add(form, "table", {id: "found", "aria-label": "Error and cost of configs, by rising cost"});
  let running = false;
  for (const event of ["scene", "camera", "size"]) app.on(event, stop);  // it is of one view

  function stop() {
    running = false;
  }
  async function measure() {
    const wanted = {camera: app.camera, budget: budget.value.trim(), error: Number(error.value)};
    if (!(wanted.error >= 0)) return app.say(`'${error.value}' is no error: write 0.05`, "error");
    const radius = app.stateA()?.params.find(param => param.name === "radius");
    if (radius) [wanted.radius] = radius.value;
    app.say(null);
    table.replaceChildren();
    running = true;
    start.textContent = "Stop";
    const answer = await app.during(() => app.engine.choose(wanted, ({lines, found}) => {
      if (lines.length) said.textContent = lines.at(-1);
      if (found) show(found, wanted.budget || wanted.error);
    }, () => !running));
    running = false;
    start.textContent = "Measure all";
    if (!answer) return;
    if (!answer.ok) return app.say(describe(answer.diagnostics), "error");
    for (const {message} of answer.diagnostics) add(said, "span", {class: "line-of"}, message);
  }

  function show(found, limited) {
    table.replaceChildren();
    const most = Math.max(...found.map(each => each.rmse), 1e-6);
    for (const each of found) {
      const beyond = limited && !each.within;
      const line = add(table, "tr", {class: beyond ? "soft" : null, title: beyond ? "Over a limit" : each.front ? "No other beats it" : null});
      const best = limited && each.best;
      add(line, best ? "th" : "td", {}, (best ? "➤ " : "") + each.label + (each.front ? " ★" : ""));
      add(line, "td", {class: "num", title: `${round(each.ratio, 2)} of learnopengl`}, ms(each.ms));
      const cell = add(line, "td", {class: "wide-cell"}, `${each.rmse.toFixed(4)} ± ${each.margin.toFixed(4)}`);
      add(cell, "span", {class: "bar-of", style: `width:${100 * each.rmse / most}%`});
      button(add(line, "td"), "Use", () => use(each), {"aria-label": "Use " + each.label});
    }
  }

  function use({config, overrides}) {
    if (!overrides.length) return app.chooseConfig(config);
    const answer = app.must(() => app.engine.foundText(JSON.stringify({config, overrides}))), path = app.path(NAME);
    if (!answer.ok) return;
    app.firstTexts.set(path, answer.text);
    app.putText(path, answer.text);
    app.chooseConfig(NAME);
  }
}
