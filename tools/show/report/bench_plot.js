// SPDX-License-Identifier: MIT
// One scene of the report: the plot of error against cost, and the pictures of the chosen bench sample.
"use strict";
const LEAST = 1e-4;  // a logarithmic axis has no place for an error of 0

function quoted(word) { return /^[\w.,\/=:+-]+$/.test(word) ? word : `'${word}'`; }
function renderCommand(p) {
  return [
    "crevice render", quoted(p.config), ...p.overrides.map(o => "--set " + quoted(o)), "--scene",
    quoted(p.scene), "--out ao=ao.png"
  ].join(" ");
}
// The figures of a bench sample, as [name, value].
function figures(p) {
  const {rmse, bias, rmse_fit, p99} = p.error, {median, q1, q3} = p.cost;
  const against = p.ratio_learnopengl > 0 ? `, ${times(p.ratio_learnopengl)} learnopengl` : "";
  return [
    ["error", `${error(rmse)} (without AO ${error(p.error_without_ao)})`],
    ["cost", `${ms(median)}, the middle half ${three(q1)}–${three(q3)}; ` +
      `${times(p.ratio_copy)} depth copy${against}`],
    ["bias", bias >= 0 ? `+${bias.toFixed(3)}, too bright` : `−${(-bias).toFixed(3)}, too dark`],
    ["shape", `error ${error(rmse_fit)} with the best contrast; ` +
      `99 of 100 pixels within ${p99.toFixed(2)}`]
  ];
}
function showSample(panel, p, taken) {
  add(panel, "h3", {}, brief(p.label) + (taken ? " – the one to take" : ""));
  const kept = pictures(panel, "pictures", [
    [p.ao_picture, "this config"], [p.ground_truth_picture, "ray-traced ground truth"],
    [p.difference_picture, "difference: red is too bright, blue too dark"]
  ].map(([picture, caption]) => [picture, caption, `${caption}: ${p.label}`]));
  if (!kept) add(panel, "p", {class: "soft"}, "No pictures were kept of it.");
  const list = add(panel, "dl", {class: "figures"});
  for (const [name, value] of figures(p)) {
    add(list, "dt", {}, name);
    add(list, "dd", {}, value);
  }
  add(panel, "code", {}, renderCommand(p));
}

// The plot, the line of no AO, the front, and a mark for each bench sample.
function drawPlot(parent, view, taken, select) {
  const front = view.front_ms, without = Math.max(LEAST, view.error_without_ao);
  const place = i => ({x: benchSamples[i].cost.median, y: Math.max(LEAST, benchSamples[i].error.rmse)});
  const shown = view.bench_samples.filter(i => place(i).x > 0);
  if (!shown.length) return add(parent, "p", {}, "No bench sample has a time.");
  const of = family => shown.filter(i => benchSamples[i].family === family)
                         .sort((a, b) => benchSamples[a].samples - benchSamples[b].samples);
  const names = families.filter(family => of(family).length);
  legend(parent, names.map(family => ({family, text: brief(family)})));
  const plot = chart(parent, {
    series: names.map(family => ({color: colorOf(family), points: of(family).map(place)})),
    height: innerWidth < 640 ? 380 : 520,
    xlabel: "cost: milliseconds added to a frame",
    ylabel: "error: less is better",
    title: `Error against cost in ${view.name}`,
    reach: [without],
    room: 1.5
  });
  const {svg, X, Y, left, right, top} = plot, y = Y(without);
  const at = i => ({x: X(place(i).x), y: Y(place(i).y)});
  svg.prepend(add(svg, "rect", {class: "worse", x: left, width: right - left, y: top, height: y - top}));
  add(svg, "line", {class: "none", x1: left, x2: right, y1: y, y2: y});
  add(svg, "text", {class: "soft-name", x: right - 4, y: y - 6, "text-anchor": "end"},
    `no AO at all: ${error(without)}`);
  add(svg, "path", {class: "front", d: front.map(at).map((p, n) => n ? `H${p.x}V${p.y}` : `M${p.x} ${p.y}`).join("")});
  for (const i of shown) drawMark(svg, i, at(i), front.includes(i), select);
  const named = [taken, front[0], front[front.length - 1], ...(plot.width < 500 ? [] : front)];
  const steps = front.slice(1).map((i, n) => [at(front[n]), {x: at(i).x, y: at(front[n]).y}, at(i)]);
  nameMarks(plot,
    named.filter((i, n) => shown.includes(i) && named.indexOf(i) === n)
      .map(i => ({...at(i), strong: i === taken, text: brief(benchSamples[i].label)})),
    [
      {x0: right - 170, x1: right, y0: y - 20, y1: y}, ...shown.map(i => boxAround(at(i), at(i), 7)),
      ...steps.flatMap(([a, b, c]) => [boxAround(a, b, 1), boxAround(b, c, 1)])
    ]);
}
function drawMark(svg, i, {x, y}, top, select) {
  const p = benchSamples[i], text = `${p.label}: error ${error(p.error.rmse)}, ${ms(p.cost.median)}`;
  const node = add(svg, "g", {
    class: "point" + (top ? " top" : ""), tabindex: 0, role: "button", "data-index": i, "data-key": p.key,
    transform: `translate(${x} ${y})`, "aria-label": text, onclick: () => select(i),
    onkeydown: e => {
      if (e.key !== "Enter" && e.key !== " ") return;
      e.preventDefault();
      select(i);
    }
  });
  add(node, "title", {}, text);
  add(node, "circle", {class: "hit", r: 12});
  mark(node, p.family, 0, 0);
}

function showView(parent, view, take) {
  const taken = view.bench_samples.find(i => benchSamples[i].label === take) ?? -1;
  const card = add(parent, "div", {class: "card"});
  add(card, "p", {class: "soft"},
    `${view.size}, radius ${view.radius}. Down and left is better. The thick line joins the configs that no other ` +
      "beats. Hover over a mark for its figures, click it for its pictures.");
  const plot = add(card, "div", {class: "pareto"}),
        panel = add(card, "div", {class: "panel", "aria-live": "polite"});
  const select = i => {
    for (const node of plot.querySelectorAll(".point"))
      node.classList.toggle("on", node.dataset.index === String(i));
    panel.replaceChildren();
    if (i >= 0) showSample(panel, benchSamples[i], i === taken);
  };
  drawPlot(plot, view, taken, select);
  select(taken >= 0 ? taken : view.front_ms[0] ?? -1);
  showBudgets(parent, view);
  showMotion(parent, view);
  showCurves(parent, view.curves, "How it scales");
  showTable(parent, view, i => {
    select(i);
    card.scrollIntoView({block: "nearest"});
  });
}

// The view that most bench samples share; others are drawn when they are opened.
function showScene(parent, views, take) {
  const section = add(parent, "section", {class: "scene"}), main = views.find(v => v.main) || views[0];
  add(section, "h2", {}, `Scene: ${main.name}`);
  showView(section, main, take);
  for (const view of views) {
    if (view === main) continue;
    const more = add(section, "details");
    add(more, "summary", {}, `${view.name} at ${view.size}, radius ${view.radius}`);
    more.addEventListener("toggle", () => showView(more, view, take), {once: true});
  }
}
