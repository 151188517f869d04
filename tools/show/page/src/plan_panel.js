// SPDX-License-Identifier: MIT
// The plan as `crevice explain` prints it: passes, textures, and what is left out with its reason.
import {$, add} from "./dom.js";

export function makePlan(app) {
  const text = add($("plan"), "pre", {id: "plan-text", tabindex: 0, "aria-label": "The plan"});
  const show = () => {
    if (app.tab !== "plan" || !app.stateA()) return;
    text.textContent = app.engine.planText(0);
    text.style.setProperty("--columns", Math.max(...text.textContent.split("\n").map(line => line.length)));
  };
  for (const event of ["tab", "loaded", "values", "size"]) app.on(event, show);
}
