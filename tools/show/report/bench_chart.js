// SPDX-License-Identifier: MIT
// How the report names and colours what it draws.
"use strict";
const benchSamples = data.bench_samples;
const families = [...new Set(benchSamples.filter(p => !p.failure).map(p => p.family))];
const peers = new Set(benchSamples.filter(p => p.peer).map(p => p.family));  // drawn hollow
const numberOf = family => Math.max(0, families.indexOf(family));
const colorOf = family => `var(--f${numberOf(family) % 8})`;

// "learnopengl /generated/kernel/shape=cube" as "learnopengl shape=cube".
const brief = label => label.replace(/ \/\S*\/(?=[^\s/]+=)/g, " ");
const times = x => x > 0 ? three(x) + "×" : "–";
const signed = x => x.toFixed(2).replace("-", "−");
const megabytes = x => (x / 1e6).toFixed(1);
const byError = (a, b) => benchSamples[a].error.rmse - benchSamples[b].error.rmse;

function mark(parent, family, x, y, scale = 1) {
  const transform = `translate(${x} ${y}) scale(${scale})`, color = colorOf(family);
  const paint = peers.has(family) ? {class: "peer", style: `--peer:${color}`} : {fill: color};
  return add(parent, "path", {d: SHAPES[numberOf(family) % SHAPES.length], transform, ...paint});
}
function legend(parent, entries) {
  const list = add(parent, "div", {class: "legend"});
  for (const {family, text} of entries) {
    const item = add(list, "span");
    mark(add(item, "svg", {viewBox: "-8 -8 16 16", style: "width:16px", "aria-hidden": "true"}),
      family, 0, 0);
    add(item, "span", {}, text);
  }
}
