// SPDX-License-Identifier: MIT
// Error against cost of one view, both on logarithmic axes.
"use strict";
const WIDTH = 760, HEIGHT = 440, LEFT = 56, RIGHT = WIDTH - 16, TOP = 12, BOTTOM = HEIGHT - 46;
const LEAST = 1e-4;  // a logarithmic axis has no place for an error of 0
const costOf = s => s.cost.median;
const errorOf = s => Math.max(LEAST, s.error.rmse);

// Where values go between two ends, and round numbers among them.
function axis(values, from, to) {
  const low = Math.min(...values) / 1.2, high = Math.max(...values) * 1.2, ticks = [];
  for (let e = Math.floor(Math.log10(low)); e <= Math.log10(high); ++e)
    for (const m of high / low > 200 ? [1] : [1, 2, 3, 5, 7]) ticks.push(m * 10 ** e);
  const at = x => from + (to - from) * Math.log(x / low) / Math.log(high / low);
  return {at, ticks: ticks.filter(t => t >= low && t <= high)};
}

function drawAxes(svg, x, y) {
  for (const t of x.ticks) {
    add(svg, "line", {class: "grid", x1: x.at(t), x2: x.at(t), y1: TOP, y2: BOTTOM});
    add(svg, "text", {x: x.at(t), y: BOTTOM + 17, "text-anchor": "middle"}, three(t));
  }
  for (const t of y.ticks) {
    add(svg, "line", {class: "grid", x1: LEFT, x2: RIGHT, y1: y.at(t), y2: y.at(t)});
    add(svg, "text", {x: LEFT - 7, y: y.at(t) + 4, "text-anchor": "end"}, three(t));
  }
  add(svg, "text", {x: (LEFT + RIGHT) / 2, y: HEIGHT - 8, "text-anchor": "middle"}, "cost: milliseconds added to a frame");
  add(svg, "text", {transform: `translate(13 ${(TOP + BOTTOM) / 2}) rotate(-90)`, "text-anchor": "middle"}, "error");
}

// A mark for each bench sample, of its family's colour; a thick line through the `front`, which is named.
function drawPlot(parent, view, front, select) {
  const shown = view.bench_samples.map(i => benchSamples[i]).filter(s => costOf(s) > 0);
  if (!shown.length) return add(parent, "p", {}, "No bench sample has a time.");
  const without = Math.max(LEAST, view.error_without_ao);
  const x = axis(shown.map(costOf), LEFT, RIGHT), y = axis([without, ...shown.map(errorOf)], BOTTOM, TOP);
  const placeOf = s => ({x: x.at(costOf(s)), y: y.at(errorOf(s))});
  const svg = add(add(parent, "div", {class: "scroll"}), "svg",
    {viewBox: `0 0 ${WIDTH} ${HEIGHT}`, role: "group", "aria-label": `Error against cost in ${view.name}`});
  drawAxes(svg, x, y);
  add(svg, "line", {class: "none", x1: LEFT, x2: RIGHT, y1: y.at(without), y2: y.at(without)});
  add(svg, "text", {x: RIGHT, y: y.at(without) - 6, "text-anchor": "end"}, `no AO at all: ${error(without)}`);
  const steps = front.map(placeOf).map((p, n) => n ? `H${p.x}V${p.y}` : `M${p.x} ${p.y}`);
  add(svg, "path", {class: "front", d: steps.join("")});
  for (const s of shown) drawMark(svg, s, placeOf(s), front.includes(s), select);
  nameMarks(svg, front.map(s => ({...placeOf(s), text: brief(s.label)})));
}

function drawMark(svg, sample, {x, y}, top, select) {
  const text = `${sample.label}: error ${error(sample.error.rmse)}, ${ms(costOf(sample))}`;
  const mark = add(svg, "circle", {
    class: "point" + (top ? " top" : ""), cx: x, cy: y, r: 6, fill: colorOf(sample.family), tabindex: 0, role: "button",
    "data-key": sample.key, "aria-label": text, onclick: () => select(sample),
    onkeydown: event => { if (event.key === "Enter") select(sample); }
  });
  add(mark, "title", {}, text);
}

// Below and left of a front there is room for names, but for each other.
function nameMarks(svg, marks) {
  let last = -Infinity;
  for (const {x, y, text} of marks) {
    if (y + 18 - last < 13) continue;
    last = y + 18;
    const near = x < LEFT + 120;
    add(svg, "text", {class: "name", x: near ? x + 4 : x - 6, y: last, "text-anchor": near ? "start" : "end"}, text);
  }
}
