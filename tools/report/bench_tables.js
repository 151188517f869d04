// SPDX-License-Identifier: MIT
// Below each plot: where the error comes from, how it scales, and all figures.
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
  const known = view.bench_samples.filter(i => benchSamples[i].budget.model > 0)
    .sort((a, b) => benchSamples[a].error.rmse - benchSamples[b].error.rmse);
  if (!known.length) return;
  add(parent, "h3", {}, "What would change the error");
  add(parent, "p", {class: "soft"},
    "By how much the error falls (−) or rises (+) when one thing is made ideal and the rest stays. " +
      "Changes do not add up, since errors cancel each other; the last figure is the error with all of them.");
  const front = known.filter(i => view.front_ms.includes(i)),
        others = known.filter(i => !front.includes(i));
  showParts(parent, front);
  if (!others.length) return;
  const details = add(parent, "details");
  add(details, "summary", {}, `The ${others.length} that are not on the thick line`);
  showParts(details, others);
}
function showParts(parent, shown) {
  if (!shown.length) return;
  const longest = Math.max(...shown.flatMap(i => [benchSamples[i].error.rmse, benchSamples[i].budget.model]));
  const table = add(add(parent, "div", {class: "card scroll"}), "table", {class: "budgets"});
  const head = add(add(table, "thead"), "tr");
  for (const title of ["config", "error", ...PARTS.map(part => part[1]), "all of these"])
    add(head, "th", {}, title);
  add(head, "th", {class: "wide"}, "what would help most");
  const body = add(table, "tbody");
  for (const i of shown) {
    const p = benchSamples[i], row = add(body, "tr", {class: "budget"});
    add(row, "td", {class: "label"}, brief(p.label));
    bar(add(row, "td"), p.error.rmse, longest, "all");
    for (const [name] of PARTS) changeBar(add(row, "td"), p.budget[name], longest);
    bar(add(row, "td"), p.budget.model, longest, "model");
    add(row, "td", {class: "wide"}, p.budget_failure || cureOf(p));
  }
}
function cureOf(p) {
  const [name, , cure] = PARTS.reduce((a, b) => p.budget[b[0]] < p.budget[a[0]] ? b : a);
  return p.budget[name] < -NOTICEABLE * p.error.rmse ? cure : "another estimator";
}
function changeBar(cell, change, longest) {
  const size = Math.abs(change), text = size < 5e-5 ? "–" : (change < 0 ? "−" : "+") + error(size);
  bar(cell, size, longest, change < 0 ? "falls" : "rises", text);
}
// A figure with a bar of its length.
function bar(cell, value, longest, kind, text = error(value)) {
  add(cell, "span", {class: "figure"}, text);
  add(cell, "i", {
    class: "bar",
    style: `width:${Math.min(100, Math.max(0, 100 * value / longest))}%;background:var(--${kind})`
  });
}

// kind: [heading, x, y, the slope of the guide and what it means, where there is one]
const CURVES = {
  taps_samples: ["What all taps would take from the error", "depth taps a pixel", "less error"],
  error_samples: ["Error against samples", "depth taps a pixel", "error"],
  cost_samples: ["Cost against samples", "depth taps a pixel", "ms", 1, "in proportion"],
  cost_pixels: ["Cost against pixels", "pixels", "ms", 1, "in proportion"],
  cost_radius: ["Cost against radius", "radius in pixels on screen", "ms", 1, "in proportion"],
  cost_triangles: ["Time against triangles", "triangles", "ms", 1, "in proportion"]
};
function showCurves(parent, curves, title) {
  const kinds = Object.keys(CURVES).filter(kind => curves.some(c => c.kind === kind));
  if (!kinds.length) return;
  add(parent, "h3", {}, title);
  add(parent, "p", {class: "soft"},
    "The figures are the exponents of fitted power laws; of an error, one further below 0 is " +
      "better. Cost that rises in proportion has 1.");
  const grid = add(parent, "div", {class: "charts"});
  for (const kind of kinds) {
    showCurve(add(grid, "div", {class: "card"}), curves.filter(c => c.kind === kind), CURVES[kind]);
  }
}
function showCurve(card, curves, [heading, xlabel, ylabel, slope, meaning]) {
  add(card, "h4", {}, heading);
  const series = curves.map(c => (
    {family: c.family, color: colorOf(c.family), points: c.points.map(([x, y]) => ({x, y}))}));
  const place = chart(card, {series, height: 260, xlabel, ylabel, title: heading});
  if (slope) showGuide(place, slope, meaning);
  for (const s of series)
    for (const p of s.points) mark(place.svg, s.family, place.X(p.x), place.Y(p.y), 0.7);
  const sorted = [...curves].sort((a, b) => a.slope - b.slope);
  legend(card, sorted.map(c => ({family: c.family, text: `${brief(c.label)}: ${signed(c.slope)}`})));
}

// A line from a corner, so that it shows a direction and hides nothing.
function showGuide({svg, X, Y, x0, x1, y0, y1, right}, slope, meaning) {
  const corner = slope < 0 ? y1 : y0,
        end = Math.min(x1, x0 * (slope < 0 ? y0 / y1 : y1 / y0) ** (1 / slope));
  const x = X(end), y = Y(corner * (end / x0) ** slope), near = x > right - 110;
  add(svg, "line", {class: "none", x1: X(x0), y1: Y(corner), x2: x, y2: y});
  const at = {x: x + (near ? -6 : 5), y: y + (slope < 0 ? -6 : 12)};
  add(svg, "text", {class: "soft-name", ...at, "text-anchor": near ? "end" : "start"},
    `${meaning} (${signed(slope)})`);
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
  const table = add(add(details, "div", {class: "card scroll"}), "table");
  const head = add(add(table, "thead"), "tr");
  add(head, "th", {}, "config (★: no other beats it)");
  for (const [name] of COLUMNS) add(head, "th", {class: "num"}, name);
  const body = add(table, "tbody", {class: "bench-samples"});
  for (const i of [...view.bench_samples].sort((a, b) => benchSamples[a].cost.median - benchSamples[b].cost.median)) {
    const row = add(body, "tr"), star = view.front_ms.includes(i);
    const link = add(add(row, "td", {class: "label"}), "button",
      {class: "link", type: "button", onclick: () => select(i)});
    link.append(benchSamples[i].label + (star ? " ★" : ""));
    for (const [, text] of COLUMNS) add(row, "td", {class: "num"}, text(benchSamples[i]));
  }
}
