// SPDX-License-Identifier: MIT
// One scene of the report: the plot of error against cost, and the pictures of the selected bench
// sample.
"use strict";
const AXES = {
  ms: ["cost: milliseconds added to a frame", "milliseconds", p => p.cost.median],
  ratio: ["cost: times a copy of the depth texture", "× depth copy", p => p.ratio_copy]
};
let axis = "ms";
const redraws = [];
function redraw() {
  for (const draw of redraws) draw();
}
const LEAST = 1e-4;  // a logarithmic axis has no place for an error of 0
const height = p => Math.max(LEAST, p.error.rmse);

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
function showFigures(parent, p, count) {
  const list = add(parent, "dl", {class: "figures"});
  for (const [name, value] of figures(p).slice(0, count)) {
    add(list, "dt", {}, name);
    add(list, "dd", {}, value);
  }
}
function showPictures(parent, p) {
  const known = [
    ["ao_picture", "this config"], ["ground_truth_picture", "ray-traced ground truth"],
    ["difference_picture", "difference: red is too bright, blue too dark"]
  ].filter(([kind]) => data.pictures && data.pictures[p[kind]]);
  if (!known.length) return add(parent, "p", {class: "soft"}, "No pictures were kept of it.");
  const strip = add(parent, "div", {class: "pictures"});
  for (const [kind, caption] of known) {
    const figure = add(strip, "figure");
    add(figure, "img", {src: data.pictures[p[kind]], alt: `${caption}: ${p.label}`});
    add(figure, "figcaption", {}, caption);
  }
}

// The frame, the line of no AO, the curves and the names; marks are for the caller. Null where
// there is nothing to show.
function drawPlot(parent, view, taken) {
  const [xlabel, , cost] = AXES[axis], front = view["front_" + axis],
                   without = Math.max(LEAST, view.error_without_ao);
  const shown = view.bench_samples.filter(i => cost(benchSamples[i]) > 0);
  if (!shown.length) return add(parent, "p", {}, "No bench sample has a time on this axis."), null;
  const names = families.filter(f => shown.some(i => benchSamples[i].family === f));
  const series = names.map(family => ({
    color: colorOf(family),
    points: shown.filter(i => benchSamples[i].family === family)
              .sort((a, b) => benchSamples[a].samples - benchSamples[b].samples)
              .map(i => ({x: cost(benchSamples[i]), y: height(benchSamples[i])}))
  }));
  legend(parent, names.map(family => ({family, text: brief(family)})));
  const place = chart(parent, {
    series,
    height: innerWidth < 640 ? 380 : 520,
    xlabel,
    ylabel: "error: less is better",
    title: `Error against cost in ${view.name}`,
    reach: [without],
    room: 1.5
  });
  const {svg, X, Y, left, right, top} = place, y = Y(without);
  svg.prepend(
    add(svg, "rect", {class: "worse", x: left, width: right - left, y: top, height: y - top}));
  add(svg, "line", {class: "none", x1: left, x2: right, y1: y, y2: y});
  add(svg, "text", {class: "soft-name", x: right - 4, y: y - 6, "text-anchor": "end"},
    `no AO at all: ${error(without)}`);
  place.at = i => ({x: X(cost(benchSamples[i])), y: Y(height(benchSamples[i]))});
  const stair = front.map(place.at).map(({x, y: down}, n) => n ? `H${x}V${down}` : `M${x} ${down}`);
  add(svg, "path", {class: "front", d: stair.join("")});
  const order =
    [taken, front[0], front[front.length - 1], ...(place.width < 500 ? [] : front)].filter(
      (i, n, all) => shown.includes(i) && all.indexOf(i) === n);
  const steps = front.slice(1).map(
    (i, n) => [place.at(front[n]), {x: place.at(i).x, y: place.at(front[n]).y}, place.at(i)]);
  place.nameAll = () => nameMarks(
    place, order.map(i => ({...place.at(i), strong: i === taken, text: brief(benchSamples[i].label)})), [
      {x0: right - 170, x1: right, y0: y - 20, y1: y},
      ...shown.map(i => boxAround(place.at(i), place.at(i), 7)),
      ...steps.flatMap(([a, b, c]) => [boxAround(a, b, 1), boxAround(b, c, 1)])
    ]);
  return Object.assign(place, {shown, front});
}
function showTip(plot, place, i) {
  plot.querySelector(".tip")?.remove();
  if (i < 0) return;
  const tip = add(plot, "div", {class: "tip"}), {x, y} = place.at(i);
  add(tip, "strong", {}, brief(benchSamples[i].label));
  showFigures(tip, benchSamples[i], 2);
  const svg = place.svg.getBoundingClientRect(), own = plot.getBoundingClientRect();
  const scale = svg.width / place.width, at = svg.left - own.left + x * scale;
  tip.style.left =
    `${Math.max(0, at + (at + tip.offsetWidth + 14 < own.width ? 14 : -14 - tip.offsetWidth))}px`;
  tip.style.top = `${svg.top - own.top + y * scale + 10}px`;
}

function drawMarks(plot, place, chosen, select) {
  for (const i of place.shown) {
    const p = benchSamples[i], {x, y} = place.at(i);
    const show = () => showTip(plot, place, i), hide = () => showTip(plot, place, -1);
    const node = add(place.svg, "g", {
      class: "point" + (place.front.includes(i) ? " top" : "") + (i === chosen ? " on" : ""),
      tabindex: 0,
      role: "button",
      "data-index": i,
      "data-key": p.key,
      transform: `translate(${x} ${y})`,
      "aria-label": `${p.label}: error ${error(p.error.rmse)}, ${ms(p.cost.median)}`,
      onclick: () => select(i),
      onpointerenter: show,
      onpointerleave: hide,
      onfocus: show,
      onblur: hide,
      onkeydown: e => {
        if (e.key !== "Enter" && e.key !== " ") return;
        e.preventDefault();
        select(i);
      }
    });
    add(node, "circle", {class: "hit", r: 12});
    mark(node, p.family, 0, 0);
  }
}

function showScene(parent, views, take) {
  let view, chosen, taken;
  const section = add(parent, "section", {class: "scene"});
  add(section, "h2", {}, `Scene: ${views[0].name}`);
  const row = add(section, "div", {class: "row"});
  if (views.length > 1) {
    const change = () => turnTo(views[pick.value]);
    const pick = add(row, "select", {"aria-label": "size and radius", onchange: change});
    views.forEach((v, i) =>
      add(pick, "option", {value: i, selected: v.main ? "" : null}, `${v.size}, radius ${v.radius}`));
  } else
    add(row, "span", {class: "soft"}, `${views[0].size}, radius ${views[0].radius}`);
  const toggle = add(row, "div", {class: "switch", role: "group", "aria-label": "cost axis"});
  const turnAxis = to => {
    axis = to;
    redraw();
  };
  const buttons = Object.entries(AXES).map(([name, [, text]]) =>
    add(toggle, "button", {type: "button", onclick: () => turnAxis(name)}, text));
  const card = add(section, "div", {class: "card"});
  add(card, "p", {class: "soft"},
    "Down and left is better. The thick line joins the configs that no other beats. Hover over " +
      "a mark for its figures, click it for its pictures.");
  const plot = add(card, "div", {class: "pareto"}),
        panel = add(card, "div", {class: "panel", "aria-live": "polite"});
  const rest = add(section, "div");

  const select = i => {
    chosen = i;
    for (const node of plot.querySelectorAll(".point"))
      node.classList.toggle("on", node.dataset.index === String(i));
    panel.replaceChildren();
    if (i < 0) return;
    add(panel, "h3", {}, brief(benchSamples[i].label) + (i === taken ? " – the one to take" : ""));
    showPictures(panel, benchSamples[i]);
    showFigures(panel, benchSamples[i]);
    add(panel, "code", {}, renderCommand(benchSamples[i]));
  };
  const draw = () => {
    buttons.forEach((b, i) => b.setAttribute("aria-pressed", Object.keys(AXES)[i] === axis));
    plot.replaceChildren();
    const place = drawPlot(plot, view, taken);
    if (!place) return;
    drawMarks(plot, place, chosen, select);
    place.nameAll();
  };
  const turnTo = to => {
    view = to;
    taken = view.bench_samples.find(i => benchSamples[i].label === take) ?? -1;
    select(taken >= 0 ? taken : view.front_ms[0] ?? -1);
    draw();
    rest.replaceChildren();
    showBudgets(rest, view);
    showMotion(rest, view);
    showCurves(rest, view.curves, "How it scales");
    showTable(rest, view, i => {
      select(i);
      card.scrollIntoView({block: "nearest"});
    });
  };
  turnTo(views.find(v => v.main) || views[0]);
  redraws.push(draw);
}
