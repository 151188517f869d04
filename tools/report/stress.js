// SPDX-License-Identifier: MIT
// Lays out the stress report: each config's breakdown points with pictures, a matrix of what holds, the chosen case with
// its curve, every failure.
"use strict";
const SIGNS = {holds: "✓", breaks: "✗", void: "∅", beyond: "~", refused: "!", absent: "·"};
const fails = s => s.state === "breaks" || s.state === "void";
const series = data.series;
const configs = [...new Set(series.map(s => s.config))];
const caseOf = name => data.cases.find(c => c.name === name);
const rowOf = s => s.case + (s.format ? " " + s.format : "");
const rows = [...new Set(data.cases.flatMap(c => series.filter(s => s.case === c.name).map(rowOf)))];
const three = x => String(Number(x.toPrecision(3)));
const plural = (n, word) => `${n} ${word}${n === 1 ? "" : "s"}`;

// A logarithmic axis of figures, with room at its foot for what is 0.
const FLOOR = 1e-6;
function drawCurves(parent, row, chosen) {
  const lines = series.filter(s => rowOf(s) === row && s.state !== "absent"), test = caseOf(chosen.case);
  const width = Math.max(300, parent.clientWidth), height = 260, left = 58, right = width - 14, top = 10;
  const bottom = height - 46, count = test.steps.length;
  const most = Math.max(test.limit, 1e-3, ...lines.flatMap(s => s.steps.map(t => t ? t.figure : 0))) * 1.3;
  const X = i => left + (right - left) * (count > 1 ? i / (count - 1) : 0.5);
  const Y = f => bottom - (bottom - top) * Math.log(Math.max(f, FLOOR) / FLOOR) / Math.log(most / FLOOR);
  const svg = add(parent, "svg", {viewBox: `0 0 ${width} ${height}`, role: "img",
    "aria-label": `${test.figure} of ${row}, by ${test.unit || "kind"}`});
  for (let f = FLOOR; f <= most; f *= 10) {
    add(svg, "line", {class: "grid", x1: left, x2: right, y1: Y(f), y2: Y(f)});
    add(svg, "text", {x: left - 6, y: Y(f) + 4, "text-anchor": "end"}, f === FLOOR ? "0" : f.toExponential(0));
  }
  const gap = Math.ceil(count * 70 / (right - left));
  test.steps.forEach((label, i) => {
    if (i % gap === 0)
      add(svg, "text", {x: X(i), y: bottom + 17,
        "text-anchor": i === count - 1 && count > 1 ? "end" : "middle"}, label.slice(0, 14));
  });
  add(svg, "text", {x: (left + right) / 2, y: height - 6, "text-anchor": "middle"}, test.unit);
  add(svg, "line", {class: "axis", x1: X(test.ordinary), x2: X(test.ordinary), y1: top, y2: bottom});
  if (test.limit > 0) add(svg, "line", {class: "limit", x1: left, x2: right, y1: Y(test.limit), y2: Y(test.limit)});
  for (const s of [...lines.filter(s => s !== chosen), chosen]) {
    const places = s.steps.map((t, i) => t && t.outcome !== "absent" && t.outcome !== "refused" ? [X(i), Y(t.figure), t] : null);
    const path = add(svg, "path", {class: s === chosen ? "curve on" : "curve",
      d: "M" + places.filter(Boolean).map(([x, y]) => `${x} ${y}`).join("L")});
    add(path, "title", {}, s.config);
    if (s !== chosen) continue;
    for (const place of places.filter(Boolean)) {
      const dot = add(svg, "circle", {class: "dot " + place[2].outcome, cx: place[0], cy: place[1], r: 4.5});
      add(dot, "title", {}, place[2].why || place[2].outcome);
    }
  }
}

function showSteps(parent, s) {
  const test = caseOf(s.case), scroll = add(parent, "div", {class: "scroll"}), table = add(scroll, "table");
  const head = add(table, "tr");
  for (const text of [test.unit || "kind", "outcome", "mean", "least", test.figure, "kept", "stored", "step / radius"])
    add(head, "th", {}, text);
  s.steps.forEach((t, i) => {
    if (!t) return;
    const line = add(table, "tr"), drawn = t.outcome !== "absent" && t.outcome !== "refused";
    add(line, "td", {}, test.steps[i] + (i === test.ordinary ? " (ordinary)" : ""));
    add(line, "td", {class: t.outcome}, t.outcome + (t.why ? ": " + t.why : ""));
    for (const value of [t.mean, t.least, t.figure])
      add(line, "td", {class: "num"}, drawn ? three(value) : "–");
    add(line, "td", {class: "num"}, drawn && t.exact > 0 ? `${three(100 * t.occlusion / t.exact)} %` : "–");
    add(line, "td", {}, drawn ? t.stored : "–");
    add(line, "td", {class: "num"}, drawn && t.share > 0 ? three(t.share) : "–");
  });
}

function showPictures(parent, s) {
  const test = caseOf(s.case), box = add(parent, "div", {class: "steps failures"});
  s.steps.forEach((t, i) => {
    if (!t || !data.pictures[t.picture]) return;
    const figure = add(box, "figure");
    add(figure, "img", {src: data.pictures[t.picture], alt: `ambient occlusion at ${test.steps[i]}`});
    add(figure, "figcaption", {}, `${test.steps[i]} ${test.unit}: ${t.why}`);
  });
}

function showMatrix(parent, select) {
  add(parent, "h2", {}, "What holds");
  const scroll = add(parent, "div", {class: "scroll card"}), table = add(scroll, "table", {class: "matrix"});
  const head = add(table, "tr"), byPlace = new Map(series.map(s => [rowOf(s) + "\n" + s.config, s]));
  add(head, "th");
  for (const config of configs) add(add(head, "th", {class: "config"}), "span", {}, config);
  for (const row of rows) {
    const line = add(table, "tr");
    add(line, "th", {class: "case"}, row);
    for (const config of configs) {
      const s = byPlace.get(row + "\n" + config), cell = add(line, "td");
      if (!s) continue;
      s.button = add(cell, "button", {type: "button", class: s.state, title: `${config}, ${row}: ${s.text}`,
        "aria-label": `${config}, ${row}: ${s.text}`, onclick: () => select(s)}, SIGNS[s.state]);
    }
  }
}

// A code span of a sentence is `so`.
function addSentence(parent, text) {
  const line = add(parent, "p");
  text.split("`").forEach((part, i) => i % 2 ? add(line, "code", {}, part) : line.append(part));
}

function showPoint(parent, point) {
  const item = add(parent, "li");
  addSentence(item, point.text);
  add(item, "p", {class: "soft"}, point.because);
  const box = add(item, "div", {class: "steps failures"});
  for (const {caption, picture} of point.pictures) {
    if (!data.pictures[picture]) continue;
    const figure = add(box, "figure");
    add(figure, "img", {src: data.pictures[picture], alt: `ambient occlusion: ${caption}`});
    add(figure, "figcaption", {}, caption);
  }
}

// Most configs are folded where there are many.
const UNFOLDED = 3;
function showPoints(parent) {
  add(parent, "h2", {id: "points"}, "Where each config breaks, what most users meet first");
  configs.forEach((config, i) => {
    const points = data.points.filter(p => p.config === config);
    const more = add(parent, "details", {class: "card points", open: i < UNFOLDED ? "" : null});
    const title = add(more, "summary");
    add(title, "strong", {}, config);
    title.append(points.length ? `: ${plural(points.length, "breakdown point")}` : ": nothing breaks");
    const list = add(more, "ol");
    for (const point of points) showPoint(list, point);
  });
}

function showBreakdowns(parent) {
  const broken = series.filter(s => fails(s) || s.beyond);
  add(parent, "h2", {id: "failures"}, "All that fails or goes beyond a format");
  if (!broken.length) return add(parent, "p", {}, "Nothing breaks, and nothing is beyond a format.");
  const scroll = add(parent, "div", {class: "scroll card"}), table = add(scroll, "table"), head = add(table, "tr");
  for (const text of ["config", "case", "format", "how far", "beyond the format"]) add(head, "th", {}, text);
  for (const s of broken) {
    const line = add(table, "tr");
    add(line, "td", {class: "label"}, s.config);
    add(line, "td", {}, s.case);
    add(line, "td", {}, s.format.replace("=", " "));
    add(line, "td", {}, s.beyond ? s.text.replace(s.beyond, "").replace(/; $/, "") : s.text);
    add(line, "td", {}, s.beyond);
  }
  for (const s of broken) {
    if (!s.steps.some(t => t && data.pictures[t.picture])) continue;
    const more = add(parent, "details");
    add(more, "summary", {}, `${s.config}, ${rowOf(s)}`);
    more.addEventListener("toggle", () => more.open && more.children.length === 1 && showPictures(more, s));
  }
}

// --- the page ---
const main = document.getElementById("main"), summary = document.getElementById("summary");
main.replaceChildren();
const failing = series.filter(fails).length;
summary.append(`${plural(series.filter(s => s.state !== "absent").length, "case")} in ` +
  `${plural(data.steps, "picture")}, drawn by crevice ${data.versions.join(", ")} on ${data.devices.join("; ")}. `);
if (failing) add(summary, "a", {class: "warn", href: "#points"}, `${plural(failing, "case")} fail.`);
let chosen;
const panel = document.createElement("section");
const select = s => {
  chosen?.button?.setAttribute("aria-pressed", "false");
  chosen = s;
  s.button?.setAttribute("aria-pressed", "true");
  panel.replaceChildren();
  add(panel, "h2", {}, `${s.config}: ${rowOf(s)}`);
  const card = add(panel, "div", {class: "card"});
  add(card, "p", {}, caseOf(s.case).what);
  add(card, "p", {class: s.state}, s.text);
  const ordinary = s.steps[caseOf(s.case).ordinary];
  if (ordinary && ordinary.rmse >= 0)
    add(card, "p", {class: "soft"}, `Its ordinary picture is off the ray-traced ground truth by ${three(ordinary.rmse)} ` +
      `(rmse; a white picture: ${three(ordinary.rmse_white)})` +
      (ordinary.exact > 0 ? `, and has ${three(100 * ordinary.occlusion / ordinary.exact)} % of its occlusion.` : "."));
  if (s.state !== "absent") drawCurves(card, rowOf(s), s);
  showSteps(card, s);
  showPictures(card, s);
};
if (series.length) {
  showPoints(main);
  showMatrix(main, select);
  main.append(panel);
  select(series.find(fails) || series[0]);
  showBreakdowns(main);
  addEventListener("resize", () => select(chosen));
} else
  add(main, "p", {class: "warn"}, "There are no figures to show.");
