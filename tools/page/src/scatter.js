// SPDX-License-Identifier: MIT
// Error against cost of the configs measured here, drawn as the bench's report draws it.
import {add} from "./dom.js";
import {SHAPES, chart, boxAround, error, ms, nameMarks} from "../../report/chart.js";

const LEAST = 1e-4;  // a logarithmic axis has no place for an error of 0
const COLORS = 8;

/// Those that no other beats, from the cheapest on.
export function frontOf(samples) {
  let best = Infinity;
  return [...samples].sort((a, b) => a.ms - b.ms || a.rmse - b.rmse).filter(s => s.rmse < best && (best = s.rmse, true));
}

/// samples: [{config, ms, rmse}] with ms > 0; `without` is the error without AO; `select(config)` is called on a click.
export function scatter(parent, {samples, without, chosen, select}) {
  const front = frontOf(samples), high = s => Math.max(LEAST, s.rmse);
  const place = chart(parent, {
    series: [{color: "none", points: samples.map(s => ({x: s.ms, y: high(s)}))}],
    height: parent.clientWidth < 480 ? 340 : 420, xlabel: "cost: milliseconds a frame on this machine",
    ylabel: "error: less is better", title: "Error against cost on this machine", reach: [without], room: 1.5
  });
  place.svg.querySelector(".join")?.remove();
  place.at = s => ({x: place.X(s.ms), y: place.Y(high(s))});
  drawWithout(place, without);
  const stair = front.map(place.at).map(({x, y}, n) => n ? `H${x}V${y}` : `M${x} ${y}`);
  add(place.svg, "path", {class: "front", d: stair.join("")});
  for (const sample of samples) drawMark(parent, place, sample, {samples, front, chosen, select});
  const named = [...samples.filter(s => s.config === chosen), ...front].filter((s, i, all) => all.indexOf(s) === i);
  nameMarks(place, named.map(s => ({...place.at(s), text: s.config, strong: s.config === chosen})),
    samples.map(s => boxAround(place.at(s), place.at(s), 7)));
}

function drawWithout({svg, Y, left, right, top}, without) {
  const y = Y(without);
  svg.prepend(add(svg, "rect", {class: "worse", x: left, width: right - left, y: top, height: Math.max(0, y - top)}));
  add(svg, "line", {class: "none", x1: left, x2: right, y1: y, y2: y});
  add(svg, "text", {class: "soft-name", x: right - 4, y: y - 6, "text-anchor": "end"}, `no AO at all: ${error(without)}`);
}

function drawMark(parent, place, sample, {samples, front, chosen, select}) {
  const {x, y} = place.at(sample), family = samples.indexOf(sample);
  const show = () => showTip(parent, place, sample), hide = () => parent.querySelector(".tip-box")?.remove();
  const load = () => select(sample.config);
  const node = add(place.svg, "g", {
    class: "point" + (front.includes(sample) ? " top" : "") + (sample.config === chosen ? " on" : ""),
    tabindex: 0, role: "button", "data-config": sample.config, transform: `translate(${x} ${y})`,
    "aria-label": `${sample.config}: error ${error(sample.rmse)}, ${ms(sample.ms)}. Enter loads it.`,
    onclick: load, onpointerenter: show, onpointerleave: hide, onfocus: show, onblur: hide,
    onkeydown: e => {
      if (e.key !== "Enter" && e.key !== " ") return;
      e.preventDefault();
      load();
    }
  });
  add(node, "circle", {class: "hit", r: 12});
  add(node, "path", {d: SHAPES[Math.floor(family / COLORS) % SHAPES.length], fill: `var(--f${family % COLORS})`});
}

function showTip(parent, place, sample) {
  parent.querySelector(".tip-box")?.remove();
  const tip = add(parent, "div", {class: "tip-box"}), {x, y} = place.at(sample);
  add(tip, "strong", {}, sample.config);
  add(tip, "div", {}, `error ${error(sample.rmse)}, bias ${sample.bias.toFixed(3)}, p99 ${sample.p99.toFixed(3)}`);
  add(tip, "div", {}, `${ms(sample.ms)} (${sample.by})`);
  const scale = place.svg.getBoundingClientRect().width / place.width, at = x * scale;
  tip.style.left = `${Math.max(0, at + tip.offsetWidth + 14 < parent.clientWidth ? at + 14 : at - 14 - tip.offsetWidth)}px`;
  tip.style.top = `${y * scale + 10}px`;
}
