// SPDX-License-Identifier: MIT
// The report's data, the ways it writes numbers, and its charts. Text goes in as text, never as markup.
"use strict";
const data = JSON.parse(document.getElementById("data").textContent);
const points = data.points;
const SVG = "http://www.w3.org/2000/svg";
const SHAPES = [  // around 0,0
  "M-5 0a5 5 0 1 0 10 0a5 5 0 1 0-10 0z", "M-4.6-4.6h9.2v9.2h-9.2z", "M0-6L5.6 4.4H-5.6z",
  "M0-6.4L6.4 0L0 6.4L-6.4 0z", "M0 6L5.6-4.4H-5.6z"];
const families = [...new Set(points.filter(p => !p.failure && p.samples > 0).map(p => p.family))];
const colorOf = family => `var(--f${Math.max(0, families.indexOf(family)) % 8})`;
const shapeOf = family => SHAPES[Math.max(0, families.indexOf(family)) % SHAPES.length];

function add(parent, tag, attributes = {}, ...children) {
  const svg = parent.namespaceURI === SVG || tag === "svg";
  const node = svg ? document.createElementNS(SVG, tag) : document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (name.startsWith("on")) node.addEventListener(name.slice(2), value);
    else if (value !== null) node.setAttribute(name, value);
  }
  node.append(...children.map(String));
  parent.append(node);
  return node;
}
const three = x => x >= 1000 ? Math.round(x).toLocaleString("en") : String(Number(x.toPrecision(3)));
const ms = x => three(x) + " ms";
const times = x => x > 0 ? three(x) + "×" : "–";
const error = x => x >= 0 ? x.toFixed(4) : "–";
const megabytes = x => (x / 1e6).toFixed(1);

function ticks(low, high, log) {
  const list = [];
  if (log && high > 4 * low) {
    const wide = Math.log10(high / low) > 2.4;
    for (let e = Math.floor(Math.log10(low)); e <= Math.log10(high); ++e)
      for (const m of wide ? [1] : [1, 2, 5]) list.push(m * 10 ** e);
  } else {
    const rough = (high - low) / 5, unit = 10 ** Math.floor(Math.log10(rough));
    const step = unit * [1, 2, 5, 10].find(m => m * unit >= rough);
    for (let i = Math.ceil(low / step); i * step <= high * 1.0001; ++i) list.push(i * step);
  }
  return list.filter(t => t >= low * 0.9999 && t <= high * 1.0001);
}
const short = x => x >= 1e6 ? three(x / 1e6) + "M" : x >= 1e4 ? three(x / 1e3) + "k" : three(x);

// series: [{family, points: [{x, y}]}]; x is on a log axis. Returns the SVG and where things are.
function chart(parent, {series, height, ylog, xlabel, ylabel, title, floor}) {
  const width = Math.max(300, parent.clientWidth), left = 52, right = 14, top = 12, bottom = 44;
  const all = series.flatMap(s => s.points), xs = all.map(p => p.x), ys = all.map(p => p.y);
  const pad = Math.max(1.06, (Math.max(...xs) / Math.min(...xs)) ** 0.04);
  const x0 = Math.min(...xs) / pad, x1 = Math.max(...xs) * pad;
  const y1 = Math.max(...ys, floor || 0) * (ylog ? 1.15 : 1.06), y0 = ylog ? Math.min(...ys) / 1.15 : 0;
  const X = x => left + (width - left - right) * Math.log(x / x0) / Math.log(x1 / x0);
  const part = ylog ? y => Math.log(y / y0) / Math.log(y1 / y0) : y => y / y1;
  const Y = y => height - bottom - (height - top - bottom) * part(y);
  const svg = add(parent, "svg", {viewBox: `0 0 ${width} ${height}`, role: "group", "aria-label": title});
  for (const t of ticks(x0, x1, true)) {
    add(svg, "line", {class: "grid", x1: X(t), x2: X(t), y1: top, y2: height - bottom});
    add(svg, "text", {x: X(t), y: height - bottom + 17, "text-anchor": "middle"}, short(t));
  }
  for (const t of ticks(y0, y1, ylog)) {
    add(svg, "line", {class: "grid", x1: left, x2: width - right, y1: Y(t), y2: Y(t)});
    add(svg, "text", {x: left - 7, y: Y(t) + 4, "text-anchor": "end"}, short(t));
  }
  add(svg, "line", {class: "axis", x1: left, x2: width - right, y1: height - bottom, y2: height - bottom});
  add(svg, "text", {x: (left + width - right) / 2, y: height - 6, "text-anchor": "middle"}, xlabel);
  add(svg, "text", {transform: `translate(12 ${(top + height - bottom) / 2}) rotate(-90)`,
    "text-anchor": "middle"}, ylabel);
  for (const s of series)
    add(svg, "path", {class: "join", stroke: colorOf(s.family),
      d: "M" + s.points.map(p => `${X(p.x)} ${Y(p.y)}`).join("L")});
  return {svg, X, Y, left, right: width - right};
}
function legend(parent, names) {
  const list = add(parent, "div", {class: "legend"});
  for (const family of names) {
    const item = add(list, "span");
    const svg = add(item, "svg", {viewBox: "-8 -8 16 16", style: "width:16px", "aria-hidden": "true"});
    add(svg, "path", {d: shapeOf(family), fill: colorOf(family)});
    add(item, "span", {}, family);
  }
}
