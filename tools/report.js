// SPDX-License-Identifier: MIT
// Lays out the report: advice, a section for each scene, what is missing.
"use strict";
// --- which to take ---
function figures(p) {
  return `error ${error(p.error.rmse)} (bias ${p.error.bias >= 0 ? "+" : ""}${p.error.bias.toFixed(4)}, ` +
    `p99 ${p.error.p99.toFixed(3)}, fitted ${error(p.error.rmse_fit)}) · ${ms(p.total.median)} ` +
    `(${three(p.total.q1)}–${three(p.total.q3)}) · ${times(p.ratio_floor)} copy` +
    (p.ratio_learnopengl > 0 ? ` · ${times(p.ratio_learnopengl)} learnopengl` : "");
}
function showAdvice(parent, advice) {
  const several = advice.views.length > 1;
  add(parent, "h2", {}, "Which config to take");
  add(parent, "p", {class: "soft"}, `On ${advice.device} at ${advice.size}, ` + (several
    ? `by the worst of ${advice.views.length} scenes (${advice.views.join(", ")})` : `in ${advice.views[0]}`) +
    `: of ${advice.configs} configs, the ${advice.steps.length} that no other beats.`);
  const titles = {fastest: "Least time", balanced: "Best balance", "most accurate": "Least error"};
  const without = advice.error_without_ao;
  const cards = add(parent, "div", {class: "cards"});
  for (const role of Object.keys(titles)) {
    const step = advice.steps.find(s => s.roles.includes(role));
    if (!step) continue;
    const card = add(cards, "div", {class: role === "balanced" ? "card best" : "card"});
    add(card, "span", {class: "role"}, titles[role]);
    add(card, "span", {class: "name"}, step.label);
    add(card, "span", {class: "big"}, `error ${error(step.error)} in ${ms(step.ms)}`);
    if (without > 0) add(card, "span", {class: "soft"},
      `${Math.round(100 * (1 - step.error / without))} % less than without AO`);
  }
  add(parent, "h3", {}, "The Pareto front: a time, and the least error it buys");
  const table = add(add(parent, "div", {class: "card scroll"}), "table", {class: "advice"});
  const head = add(add(table, "thead"), "tr");
  for (const [text, kind] of [["time", "num"], ["config to take", ""], ["error", "num"],
    ["× copy", "num wide"], ["slowest in", "wide"], ["most wrong in", "wide"]])
    add(head, "th", {class: kind}, text);
  const body = add(table, "tbody");
  for (const step of advice.steps) {
    const row = add(body, "tr", {class: step.roles.includes("balanced") ? "on" : ""});
    add(row, "td", {class: "num"}, ms(step.ms));
    add(row, "td", {class: "label"}, step.label);
    add(row, "td", {class: "num"}, error(step.error));
    add(row, "td", {class: "num wide"}, times(step.ratio));
    add(row, "td", {class: "wide"}, step.slowest_view);
    add(row, "td", {class: "wide"}, step.worst_view);
  }
}

// --- one scene ---
const AXES = {ms: ["milliseconds", p => p.total.median], ratio: ["× depth copy", p => p.ratio_floor]};
let axis = "ms";
const redraws = [];
function redraw() { for (const draw of redraws) draw(); }

function showScene(parent, views) {
  let view = views.find(v => v.main) || views[0], chosen = -1;
  const section = add(parent, "section", {class: "scene"});
  add(section, "h2", {}, view.name);
  const row = add(section, "div", {class: "row"});
  if (views.length > 1) {
    const pick = add(row, "select", {"aria-label": "size and radius", onchange: () => {
      view = views[pick.value];
      chosen = -1;
      update();
    }});
    views.forEach((v, i) => add(pick, "option", v === view ? {value: i, selected: ""} : {value: i},
      `${v.size}, radius ${v.radius}`));
  } else add(row, "span", {class: "soft"}, `${view.size}, radius ${view.radius}`);
  const toggle = add(row, "div", {class: "switch", role: "group", "aria-label": "time axis"});
  const buttons = Object.entries(AXES).map(([name, [text]]) => add(toggle, "button",
    {type: "button", onclick: () => { axis = name; redraw(); }}, text));
  const card = add(section, "div", {class: "card"});
  const plot = add(card, "div", {class: "pareto"});
  const panel = add(card, "div", {class: "panel", "aria-live": "polite"});
  const rest = add(section, "div");

  const say = i => {
    panel.replaceChildren();
    add(panel, "strong", {}, i < 0 ? "Point at a mark for its figures; click for its pictures."
      : points[i].label);
    if (i >= 0) add(panel, "div", {}, figures(points[i]));
  };
  const select = i => {
    chosen = i;
    for (const mark of plot.querySelectorAll(".point"))
      mark.classList.toggle("on", mark.dataset.index === String(i));
    say(i);
    const kinds = [["ao_picture", "This config"], ["truth_picture", "Ray-traced truth"],
      ["difference_picture", "Difference: red is too bright, blue too dark"]];
    const known = kinds.filter(([kind]) => data.pictures && data.pictures[points[i][kind]]);
    if (!known.length) return add(panel, "div", {class: "soft"}, "No pictures were kept of it.");
    const strip = add(panel, "div", {class: "pictures"});
    for (const [kind, caption] of known) {
      const figure = add(strip, "figure");
      add(figure, "img", {src: data.pictures[points[i][kind]], alt: `${caption}: ${points[i].label}`});
      add(figure, "figcaption", {}, caption);
    }
  };
  const draw = () => {
    const [label, cost] = AXES[axis], front = view["front_" + axis];
    buttons.forEach((b, i) => b.setAttribute("aria-pressed", Object.keys(AXES)[i] === axis));
    plot.replaceChildren();
    const shown = view.points.filter(i => points[i].samples > 0 && cost(points[i]) > 0);
    if (!shown.length) return add(plot, "p", {}, "No point has a time on this axis.");
    const names = families.filter(f => shown.some(i => points[i].family === f));
    const series = names.map(family => ({family, points: shown.filter(i => points[i].family === family)
      .sort((a, b) => points[a].samples - points[b].samples)
      .map(i => ({x: cost(points[i]), y: points[i].error.rmse}))}));
    legend(plot, names);
    const {svg, X, Y, left, right} = chart(plot, {series, height: 400, xlabel: label, ylabel: "error (rmse)",
      title: `Error against time in ${view.name}`, floor: view.error_without_ao});
    if (view.error_without_ao) {
      const y = Y(view.error_without_ao);
      add(svg, "line", {class: "none", x1: left, x2: right, y1: y, y2: y});
      add(svg, "text", {x: right, y: y + 15, "text-anchor": "end"}, "without AO");
    }
    add(svg, "path", {class: "front", d: front.map((i, n) => (n ? "H" : "M") + X(cost(points[i])) +
      (n ? "V" : " ") + Y(points[i].error.rmse)).join("")});
    for (const i of shown) {
      const p = points[i];
      const mark = add(svg, "g", {class: "point" + (front.includes(i) ? " top" : "") + (i === chosen ? " on" : ""),
        tabindex: 0, role: "button", "data-index": i, "data-key": p.key,
        "aria-label": `${p.label}: error ${error(p.error.rmse)}, ${ms(p.total.median)}`,
        transform: `translate(${X(cost(p))} ${Y(p.error.rmse)})`,
        onclick: () => select(i), onpointerenter: () => chosen < 0 && say(i), onfocus: () => chosen < 0 && say(i),
        onkeydown: e => { if (e.key === "Enter" || e.key === " ") { e.preventDefault(); select(i); } }});
      add(mark, "circle", {class: "hit", r: 12});
      add(mark, "path", {d: shapeOf(p.family), fill: colorOf(p.family)});
      add(mark, "title", {}, `${p.label}\n${figures(p)}`);
    }
    add(plot, "p", {class: "soft front-names"}, "Pareto front: " + front.map(i => points[i].label).join(" → "));
  };
  const update = () => {
    draw();
    say(-1);
    rest.replaceChildren();
    showBudgets(rest, view);
    showCurves(rest, view.curves, "Scaling");
    showTable(rest, view, i => { select(i); card.scrollIntoView({block: "nearest"}); });
  };
  update();
  redraws.push(draw);
}

// --- budgets, curves, tables ---
const PARTS = [["noise", "more samples"], ["model", "another estimator"], ["precision", "wider formats"]];
function showBudgets(parent, view) {
  const known = view.points.filter(i => points[i].samples > 0 && PARTS.some(([part]) => points[i].budget[part] >= 0))
    .sort((a, b) => points[a].error.rmse - points[b].error.rmse);
  if (!known.length) return;
  add(parent, "h3", {}, "Where the error comes from, and what would buy less");
  const keys = add(parent, "div", {class: "legend"});
  for (const [part, cure] of PARTS) {
    const item = add(keys, "span");
    add(item, "i", {class: "key", style: `background:var(--${part})`});
    add(item, "span", {}, `${part}: ${cure}`);
  }
  const longest = Math.max(...known.map(i => points[i].error.rmse));
  const front = known.filter(i => view.front_ms.includes(i)), others = known.filter(i => !front.includes(i));
  showBars(add(parent, "div", {class: "card"}), front, longest);
  add(parent, "p", {class: "soft"}, "A bar is as long as the error; its parts have the shares of their squares.");
  if (!others.length) return;
  const details = add(parent, "details");
  add(details, "summary", {}, `The ${others.length} that are not on the front`);
  showBars(add(details, "div", {class: "card"}), others, longest);
}
function showBars(parent, shown, longest) {
  const bars = add(parent, "div", {class: "bars"});
  for (const i of shown) {
    const {budget, label, error: {rmse}} = points[i];
    const square = part => Math.max(0, budget[part]) ** 2;
    const sum = PARTS.reduce((s, [part]) => s + square(part), 0) || 1;
    const text = PARTS.filter(([part]) => budget[part] >= 0)
      .map(([part]) => `${part} ${budget[part].toFixed(3)}`).join(", ");
    add(bars, "span", {}, label);
    const bar = add(bars, "div", {class: "bar", role: "img", "aria-label": text, title: text,
      style: `width:${100 * rmse / longest}%`});
    for (const [part] of PARTS)
      if (square(part) > 0) add(bar, "i", {style: `width:${100 * square(part) / sum}%;background:var(--${part})`});
    add(bars, "span", {class: "num"}, text);
  }
}

const CURVES = {error_samples: ["Error against samples", "depth taps a pixel", "error (rmse)"],
  noise_samples: ["Noise against samples", "depth taps a pixel", "noise (rmse)"],
  cost_samples: ["Time against samples", "depth taps a pixel", "ms"],
  cost_pixels: ["Time against pixels", "pixels", "ms"],
  cost_radius: ["Time against radius on screen", "radius in pixels", "ms"],
  cost_triangles: ["Time against triangles", "triangles", "ms"]};
function showCurves(parent, curves, title) {
  const kinds = Object.keys(CURVES).filter(kind => curves.some(c => c.kind === kind));
  if (!kinds.length) return;
  add(parent, "h3", {}, title);
  add(parent, "p", {class: "soft"}, "Both axes are logarithmic; the figures are the fitted slopes. Error: " +
    "−0.5 is what random samples give, lower is better, 0 gains nothing. Time: 1 is in proportion.");
  const grid = add(parent, "div", {class: "charts"});
  for (const kind of kinds) {
    const own = curves.filter(c => c.kind === kind), [heading, xlabel, ylabel] = CURVES[kind];
    const card = add(grid, "div", {class: "card"});
    add(card, "h4", {}, heading);
    const series = own.map(c => ({family: c.family, points: c.points.map(([x, y]) => ({x, y}))}));
    const {svg, X, Y} = chart(card, {series, height: 230, ylog: true, xlabel, ylabel, title: heading});
    for (const s of series) for (const p of s.points)
      add(svg, "path", {d: shapeOf(s.family), fill: colorOf(s.family), transform: `translate(${X(p.x)} ${Y(p.y)}) scale(.7)`});
    const list = add(card, "ul", {class: "slopes"});
    for (const c of own) {
      const item = add(list, "li");
      add(item, "span", {style: `background:${colorOf(c.family)}`});
      item.append(`${c.label}: slope ${c.slope.toFixed(2)}`.replace("-", "−"));
    }
  }
}

const COLUMNS = [["error", p => error(p.error.rmse)], ["bias", p => p.error.bias.toFixed(4)],
  ["p99", p => p.error.p99.toFixed(3)], ["fitted (power)", p => `${error(p.error.rmse_fit)} (${p.error.power_fit.toFixed(2)})`],
  ["ms", p => three(p.total.median)], ["middle half", p => `${three(p.total.q1)}–${three(p.total.q3)}`],
  ["× copy", p => times(p.ratio_floor)], ["× learnopengl", p => times(p.ratio_learnopengl)],
  ["MB", p => megabytes(p.texture_bytes)], ["MB read", p => megabytes(p.bytes_read)],
  ["MB written", p => megabytes(p.bytes_written)],
  ["passes, ms", p => p.passes.map(pass => `${pass.name} ${three(pass.ms.median)}`).join(" · ")]];
function showTable(parent, view, select) {
  const details = add(parent, "details");
  add(details, "summary", {}, `All ${view.points.length} points of ${view.name}`);
  const table = add(add(details, "div", {class: "card scroll"}), "table");
  const head = add(add(table, "thead"), "tr");
  add(head, "th", {}, "config (★ on the front)");
  for (const [name] of COLUMNS) add(head, "th", {class: "num"}, name);
  const body = add(table, "tbody");
  for (const i of [...view.points].sort((a, b) => points[a].total.median - points[b].total.median)) {
    const row = add(body, "tr"), star = view.front_ms.includes(i);
    const link = add(add(row, "td", {class: "label"}), "button", {class: "link", type: "button", onclick: () => select(i)});
    link.append(points[i].label + (star ? " ★" : ""));
    for (const [, text] of COLUMNS) add(row, "td", {class: "num"}, text(points[i]));
  }
}

function showMissing(parent) {
  const left = data.advice.flatMap(a => a.left_out);
  if (!data.failures.length && !left.length) return;
  add(parent, "h2", {}, "What is missing");
  const list = add(parent, "ul", {class: "missing"});
  for (const {title, reason} of data.failures) add(list, "li", {}, `${title}: ${reason}`);
  for (const text of left) add(list, "li", {}, `Not among those to choose from: ${text}`);
}

// --- the page ---
const main = document.getElementById("main"), summary = document.getElementById("summary");
main.replaceChildren();
const measured = points.length - data.failures.length;
const plural = (n, word) => `${n} ${word}${n === 1 ? "" : "s"}`;
summary.append(`${plural(measured, "point")} measured` + data.advice.map(a => ` on ${a.device} (${a.software
  ? "software renderer, " : ""}timed by ${a.clock === "query" ? "GPU timer" : "wall clock"}), crevice ${a.version}`).join(";"));
if (data.failures.length) add(summary, "span", {class: "warn"}, `. ${plural(data.failures.length, "point")} failed.`);
if (!measured) add(main, "p", {class: "warn"}, "There are no figures to show.");
for (const advice of data.advice) {
  showAdvice(main, advice);
  const scenes = new Map();
  for (const view of data.views.filter(v => v.device === advice.device))
    scenes.set(view.name, [...(scenes.get(view.name) || []), view]);
  for (const views of scenes.values()) showScene(main, views);
  showCurves(main, advice.curves, "Across scenes");
}
showMissing(main);
let width = innerWidth;
addEventListener("resize", () => { if (innerWidth !== width) { width = innerWidth; redraw(); } });
