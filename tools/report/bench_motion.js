// SPDX-License-Identifier: MIT
// Below each plot: what occlusion does while the camera moves, where that was measured.
"use strict";
const PATHS = ["still", "sub-pixel", "pan", "strafe", "disocclusion"];

function showMotion(parent, view) {
  const known = view.bench_samples.filter(i => benchSamples[i].motion)
    .sort((a, b) => benchSamples[a].error.rmse - benchSamples[b].error.rmse);
  if (!known.length) return;
  add(parent, "h3", {}, "What changes while the camera moves");
  add(parent, "p", {class: "soft"},
    "Change of the occlusion at the same surface point from a frame to the next, beyond that of ray-traced " +
      "occlusion: root mean square, and in brackets what 99 of 100 and 999 of 1,000 points stay below. " +
      "Beside it the error at rest and in the pan.");
  const table = add(add(parent, "div", {class: "card scroll"}), "table", {class: "motions"});
  const head = add(add(table, "thead"), "tr");
  add(head, "th", {}, "config");
  for (const title of ["error at rest", "in the pan", ...PATHS, "settles after", "uncovered, error by frame"])
    add(head, "th", {class: "num"}, title);
  const body = add(table, "tbody");
  for (const i of known) {
    const p = benchSamples[i], m = p.motion, row = add(body, "tr", {class: "motion"});
    add(row, "td", {class: "label"}, brief(p.label));
    const cells = [error(p.error.rmse), m.paths.pan ? error(m.paths.pan.rmse) : "–",
      ...PATHS.map(path => changeText(m.paths[path])),
      m.settled_after ? plural(m.settled_after, "frame") : "never",
      m.uncovered.map(u => `${u.frames}: ${error(u.rmse)}`).join(" · ") + ` · at rest: ${error(m.uncovered_rest)}`];
    for (const text of cells) add(row, "td", {class: "num"}, text);
  }
}
function changeText(c) {
  return c ? `${c.rms.toFixed(4)} (${c.p99.toFixed(3)}, ${c.p999.toFixed(3)})` : "–";
}
