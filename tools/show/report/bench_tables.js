// SPDX-License-Identifier: MIT
// Below each plot: where the error comes from, what moves, how it scales, and all figures.
"use strict";
// What is made ideal: [part, column, what to do]
const PARTS = [
  ["taps", "all taps", "more taps"], ["filter", "no filter", "no filter"],
  ["half_size", "full size", "occlusion at full size"],
  ["off_screen", "off screen seen", "a wider guard band"],
  ["hidden_layers", "hidden layers seen", "a second layer of depth"],
  ["precision", "32 bits", "wider formats"]
];
// A change of less than this share of the error is none.
const NOTICEABLE = 0.02;

function showBudgets(parent, view) {
  const known = view.bench_samples.filter(i => benchSamples[i].budget.model > 0).sort(byError);
  if (!known.length) return;
  add(parent, "h3", {}, "What would change the error");
  add(parent, "p", {class: "soft"},
    "By how much the error falls (−) or rises (+) when one thing is made ideal and the rest stays. " +
      "Changes do not add up, since errors cancel each other; the last figure is the error with all of them.");
  const onFront = i => view.front_ms.includes(i), others = known.filter(i => !onFront(i));
  showParts(parent, known.filter(onFront));
  if (!others.length) return;
  const details = add(parent, "details");
  add(details, "summary", {}, `The ${others.length} that are not on the thick line`);
  showParts(details, others);
}
function showParts(parent, shown) {
  if (!shown.length) return;
  const all = shown.map(i => benchSamples[i]);
  const longest = Math.max(...all.flatMap(p => [p.error.rmse, p.budget.model]));
  const plain = (value, kind) => cell => bar(cell, value, longest, kind, error(value));
  const change = value => cell => {
    const size = Math.abs(value), text = size < 5e-5 ? "–" : (value < 0 ? "−" : "+") + error(size);
    bar(cell, size, longest, value < 0 ? "falls" : "rises", text);
  };
  const columns = [
    ["config", "label"], ["error"], ...PARTS.map(part => [part[1]]), ["all of these"], ["what would help most", "wide"]
  ];
  const rows = all.map(p => ({
    class: "budget",
    cells: [
      brief(p.label), plain(p.error.rmse, "all"), ...PARTS.map(([name]) => change(p.budget[name])),
      plain(p.budget.model, "model"), p.budget_failure || cureOf(p)
    ]
  }));
  table(parent, columns, rows, {class: "budgets"});
}
function cureOf(p) {
  const [name, , cure] = PARTS.reduce((a, b) => p.budget[b[0]] < p.budget[a[0]] ? b : a);
  return p.budget[name] < -NOTICEABLE * p.error.rmse ? cure : "another estimator";
}

const PATHS = ["still", "sub-pixel", "pan", "strafe", "disocclusion"];
function showMotion(parent, view) {
  const known = view.bench_samples.filter(i => benchSamples[i].motion).sort(byError);
  if (!known.length) return;
  add(parent, "h3", {}, "What changes while the camera moves");
  add(parent, "p", {class: "soft"},
    "Change of the occlusion at the same surface point from a frame to the next, beyond that of ray-traced " +
      "occlusion: root mean square, and in brackets what 99 of 100 and 999 of 1,000 points stay below. " +
      "Beside it the error at rest and in the pan.");
  const change = c => c ? `${c.rms.toFixed(4)} (${c.p99.toFixed(3)}, ${c.p999.toFixed(3)})` : "–";
  const titles = ["error at rest", "in the pan", ...PATHS, "settles after", "uncovered, error by frame"];
  const rows = known.map(i => benchSamples[i]).map(({label, error: own, motion: m}) => ({
    class: "motion",
    cells: [
      brief(label), error(own.rmse), m.paths.pan ? error(m.paths.pan.rmse) : "–",
      ...PATHS.map(path => change(m.paths[path])), m.settled_after ? plural(m.settled_after, "frame") : "never",
      m.uncovered.map(u => `${u.frames}: ${error(u.rmse)}`).join(" · ") + ` · at rest: ${error(m.uncovered_rest)}`
    ]
  }));
  table(parent, [["config", "label"], ...titles.map(title => [title, "num"])], rows, {class: "motions"});
}

// kind: [heading, x, y]
const CURVES = {
  taps_samples: ["What all taps would take from the error", "depth taps a pixel", "less error"],
  error_samples: ["Error against samples", "depth taps a pixel", "error"],
  cost_samples: ["Cost against samples", "depth taps a pixel", "ms"],
  cost_pixels: ["Cost against pixels", "pixels", "ms"],
  cost_radius: ["Cost against radius", "radius in pixels on screen", "ms"],
  cost_triangles: ["Time against triangles", "triangles", "ms"]
};
function showCurves(parent, curves, title) {
  const kinds = Object.keys(CURVES).filter(kind => curves.some(c => c.kind === kind));
  if (!kinds.length) return;
  add(parent, "h3", {}, title);
  add(parent, "p", {class: "soft"},
    "The figures are the exponents of fitted power laws; of an error, one further below 0 is " +
      "better. Cost that rises in proportion has 1.");
  const grid = add(parent, "div", {class: "charts"});
  for (const kind of kinds)
    showCurve(add(grid, "div", {class: "card"}), curves.filter(c => c.kind === kind), CURVES[kind]);
}
function showCurve(card, curves, [heading, xlabel, ylabel]) {
  add(card, "h4", {}, heading);
  const series = curves.map(
    ({family, points}) => ({family, color: colorOf(family), points: points.map(([x, y]) => ({x, y}))}));
  const {svg, X, Y} = chart(card, {series, height: 260, xlabel, ylabel, title: heading});
  for (const {family, points} of series)
    for (const p of points) mark(svg, family, X(p.x), Y(p.y), 0.7);
  const sorted = [...curves].sort((a, b) => a.slope - b.slope);
  legend(card, sorted.map(c => ({family: c.family, text: `${brief(c.label)}: ${signed(c.slope)}`})));
}

const COLUMNS = [
  ["error", p => error(p.error.rmse)], ["bias", p => p.error.bias.toFixed(4)],
  ["p99", p => p.error.p99.toFixed(3)],
  ["fitted (power)", p => `${error(p.error.rmse_fit)} (${p.error.power_fit.toFixed(2)})`],
  ["cost, ms", p => three(p.cost.median)],
  ["middle half", p => `${three(p.cost.q1)}–${three(p.cost.q3)}`],
  ["× copy", p => times(p.ratio_copy)], ["× learnopengl", p => times(p.ratio_learnopengl)],
  ["with its geometry, ms", p => three(p.cost_with_geometry.median)],
  ["with it × learnopengl", p => times(p.ratio_with_geometry)],
  ["frame, ms", p => three(p.total.median)], ["MB", p => megabytes(p.texture_bytes)],
  ["MB read", p => megabytes(p.bytes_read)], ["MB written", p => megabytes(p.bytes_written)],
  ["passes, ms", p => p.passes.map(pass => `${pass.name} ${three(pass.ms.median)}`).join(" · ")]
];
function showTable(parent, view, select) {
  const details = add(parent, "details");
  add(details, "summary", {}, `All ${view.bench_samples.length} bench samples of ${view.name}`);
  const link = i => cell => add(cell, "button", {class: "link", type: "button", onclick: () => select(i)},
    benchSamples[i].label + (view.front_ms.includes(i) ? " ★" : ""));
  const sorted = [...view.bench_samples].sort((a, b) => benchSamples[a].cost.median - benchSamples[b].cost.median);
  table(details, [["config (★: no other beats it)", "label"], ...COLUMNS.map(([name]) => [name, "num"])],
    sorted.map(i => ({cells: [link(i), ...COLUMNS.map(([, text]) => text(benchSamples[i]))]})), {class: "bench-samples"});
}
