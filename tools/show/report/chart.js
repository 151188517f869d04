// SPDX-License-Identifier: MIT
// How charts write numbers, and a chart of two logarithmic axes, of the reports.
"use strict";
const SHAPES = [  // around 0,0
  "M-5 0a5 5 0 1 0 10 0a5 5 0 1 0-10 0z", "M-4.6-4.6h9.2v9.2h-9.2z", "M0-6L5.6 4.4H-5.6z",
  "M0-6.4L6.4 0L0 6.4L-6.4 0z", "M0 6L5.6-4.4H-5.6z"];
const three = x =>
  x >= 1000 ? Math.round(x).toLocaleString("en") : String(Number(x.toPrecision(3)));
const ms = x => three(x) + " ms";
const error = x => x >= 0 ? x.toFixed(x < 0.01 ? 4 : 3) : "–";

// Round numbers on a logarithmic axis: more of them where it is short.
function ticks(low, high) {
  const list = [], decades = Math.log10(high / low);
  if (decades > 0.6) {
    for (let e = Math.floor(Math.log10(low)); e <= Math.log10(high); ++e)
      for (const m of decades > 2.4 ? [1] : [1, 2, 5]) list.push(m * 10 ** e);
  } else {
    const rough = (high - low) / 5, unit = 10 ** Math.floor(Math.log10(rough));
    const step = unit * [1, 2, 5, 10].find(m => m * unit >= rough);
    for (let i = Math.ceil(low / step); i * step <= high; ++i) list.push(i * step);
  }
  return list.filter(t => t >= low && t <= high);
}
const short = x => x >= 1e6 ? three(x / 1e6) + "M" : x >= 1e4 ? three(x / 1e3) + "k" : three(x);

// series: [{color, points: [{x, y}]}]; both axes are logarithmic. `reach` are further y that must
// have room. Returns the SVG and its scales.
function chart(parent, {series, height, xlabel, ylabel, title, reach = [], room = 1.15}) {
  const width = Math.max(300, parent.clientWidth), left = 52, right = width - 14, top = 12,
        bottom = height - 44;
  const all = series.flatMap(s => s.points), xs = all.map(p => p.x),
        ys = [...all.map(p => p.y), ...reach];
  const pad = Math.max(1.06, (Math.max(...xs) / Math.min(...xs)) ** 0.04);
  const x0 = Math.min(...xs) / pad, x1 = Math.max(...xs) * pad;
  const y0 = Math.min(...ys) / room, y1 = Math.max(...ys) * 1.15;
  const X = x => left + (right - left) * Math.log(x / x0) / Math.log(x1 / x0);
  const Y = y => bottom - (bottom - top) * Math.log(y / y0) / Math.log(y1 / y0);
  const svg =
    add(parent, "svg", {viewBox: `0 0 ${width} ${height}`, role: "group", "aria-label": title});
  for (const t of ticks(x0, x1)) {
    add(svg, "line", {class: "grid", x1: X(t), x2: X(t), y1: top, y2: bottom});
    add(svg, "text", {x: X(t), y: bottom + 17, "text-anchor": "middle"}, short(t));
  }
  for (const t of ticks(y0, y1)) {
    add(svg, "line", {class: "grid", x1: left, x2: right, y1: Y(t), y2: Y(t)});
    add(svg, "text", {x: left - 7, y: Y(t) + 4, "text-anchor": "end"}, short(t));
  }
  add(svg, "line", {class: "axis", x1: left, x2: right, y1: bottom, y2: bottom});
  add(svg, "text", {x: (left + right) / 2, y: height - 6, "text-anchor": "middle"}, xlabel);
  add(svg, "text",
    {transform: `translate(12 ${(top + bottom) / 2}) rotate(-90)`, "text-anchor": "middle"},
    ylabel);
  for (const s of series)
    add(svg, "path", {
      class: "join",
      stroke: s.color,
      d: "M" + s.points.map(p => `${X(p.x)} ${Y(p.y)}`).join("L")
    });
  return {svg, X, Y, x0, x1, y0, y1, left, right, top, bottom, width};
}
// Writes names beside marks, where they meet neither each other nor what is `taken`; the first ones
// first.
const boxAround = (a, b, margin) => ({
  x0: Math.min(a.x, b.x) - margin,
  x1: Math.max(a.x, b.x) + margin,
  y0: Math.min(a.y, b.y) - margin,
  y1: Math.max(a.y, b.y) + margin
});
function nameMarks({svg, left, right, top, bottom}, names, taken) {
  const meets = (a, b) => a.x0 < b.x1 && b.x0 < a.x1 && a.y0 < b.y1 && b.y0 < a.y1;
  for (const {x, y, text, strong} of names) {
    const node = add(svg, "text", {class: strong ? "name strong" : "name"}, text);
    const w = node.getComputedTextLength() + 2;
    const box = ([dx, dy]) => {
      const x0 = Math.abs(dy) > 8 ? Math.max(left, Math.min(x + dx, right - w)) : x + dx;
      return {x0, x1: x0 + w, y0: y + dy - 12, y1: y + dy + 4, far: Math.abs(dy) > 22};
    };
    const inside = b => b.x0 >= left && b.x1 <= right && b.y0 >= top && b.y1 <= bottom;
    const near = [[9, 4], [-9 - w, 4], [5, -10], [-5 - w, 20], [5, 20]];
    const far = [36, 52, 68, 84, -26, -42].flatMap(dy => [[-w / 2, dy], [6, dy], [-w, dy]]);
    const free = [...near, ...far].map(box).find(b => inside(b) && !taken.some(t => meets(t, b)));
    if (!free) {
      node.remove();
      continue;
    }
    node.setAttribute("x", free.x0);
    node.setAttribute("y", free.y0 + 12);
    const below = free.y0 > y;
    if (free.far)
      add(svg, "line", {
        class: "leader",
        x1: x,
        y1: y + (below ? 7 : -7),
        x2: Math.min(Math.max(x, free.x0 + 4), free.x1 - 4),
        y2: below ? free.y0 + 1 : free.y1
      });
    taken.push(free);
  }
}
