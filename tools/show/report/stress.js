// SPDX-License-Identifier: MIT
// Lays out the stress report: each config's breakdown points with pictures, a matrix of what holds, the chosen case
// step by step, every failure.
"use strict";
const SIGNS = {holds: "✓", breaks: "✗", void: "∅", beyond: "~", refused: "!", absent: "·"};
const fails = s => s.state === "breaks" || s.state === "void";
const series = data.series;
const configs = [...new Set(series.map(s => s.config))];
const caseOf = name => data.cases.find(c => c.name === name);
const rows = [...new Set(data.cases.flatMap(c => series.filter(s => s.case === c.name).map(s => s.case)))];
const three = x => String(Number(x.toPrecision(3)));

function showSteps(parent, s) {
  const test = caseOf(s.case), percent = t => `${three(100 * t.occlusion / t.exact)} %`;
  const most = Math.max(test.limit, ...s.steps.map(t => t?.figure || 0), 1e-6);
  const columns = [
    [test.unit || "kind"], ["outcome"], ["mean", "num"], ["least", "num"], [test.figure, "num"], ["kept", "num"],
    ["stored"], ["step / radius", "num"]
  ];
  const lines = s.steps.map((t, i) => t && {
    cells: [
      test.steps[i] + (i === test.ordinary ? " (ordinary)" : ""),
      cell => add(cell, "span", {class: t.outcome}, t.outcome + (t.why ? ": " + t.why : "")),
      ...(t.outcome === "absent" || t.outcome === "refused" ? ["–", "–", "–", "–", "–", "–"] : [
        three(t.mean), three(t.least), cell => bar(cell, t.figure, most, t.outcome, three(t.figure)),
        t.exact > 0 ? percent(t) : "–", t.stored, t.share > 0 ? three(t.share) : "–"
      ])
    ]
  });
  table(parent, columns, lines.filter(Boolean));
  if (test.limit > 0) add(parent, "p", {class: "soft"}, `The limit of ${test.figure} is ${three(test.limit)}.`);
}

function showPictures(parent, s) {
  const test = caseOf(s.case);
  pictures(parent, "steps failures", s.steps.map((t, i) => [
    t?.picture, `${test.steps[i]} ${test.unit}: ${t?.why}`, `ambient occlusion at ${test.steps[i]}`
  ]));
}

function showMatrix(parent, select) {
  add(parent, "h2", {}, "What holds");
  const byPlace = new Map(series.map(s => [s.case + "\n" + s.config, s]));
  const button = s => cell => s && (s.button = add(cell, "button", {type: "button", class: s.state,
    title: `${s.config}, ${s.case}: ${s.text}`, "aria-label": `${s.config}, ${s.case}: ${s.text}`,
    onclick: () => select(s)}, SIGNS[s.state]));
  table(parent, [["", "case"], ...configs.map(config => [config, "config"])],
    rows.map(row => ({cells: [row, ...configs.map(config => button(byPlace.get(row + "\n" + config)))]})),
    {class: "matrix"});
}

// A code span of a sentence is `so`.
function addSentence(parent, text) {
  const line = add(parent, "p");
  text.split("`").forEach((part, i) => i % 2 ? add(line, "code", {}, part) : line.append(part));
}

// Most configs are folded where there are many.
const UNFOLDED = 3;
function showPoints(parent) {
  add(parent, "h2", {id: "points"}, "Where each config breaks");
  configs.forEach((config, i) => {
    const points = data.points.filter(p => p.config === config);
    const more = add(parent, "details", {class: "card points", open: i < UNFOLDED ? "" : null});
    const title = add(more, "summary");
    add(title, "strong", {}, config);
    title.append(points.length ? `: ${plural(points.length, "breakdown point")}` : ": nothing breaks");
    const list = add(more, "ol");
    for (const point of points) {
      const item = add(list, "li");
      addSentence(item, point.text);
      pictures(item, "steps failures",
        point.pictures.map(({caption, picture}) => [picture, caption, `ambient occlusion: ${caption}`]));
    }
  });
}

function showBreakdowns(parent) {
  const broken = series.filter(s => fails(s) || s.beyond);
  add(parent, "h2", {id: "failures"}, "All that fails or goes beyond a format");
  if (!broken.length) return add(parent, "p", {}, "Nothing breaks, and nothing is beyond a format.");
  const farOf = s => s.beyond ? s.text.replace(s.beyond, "").replace(/; $/, "") : s.text;
  table(parent, [["config", "label"], ["case"], ["how far"], ["beyond the format"]],
    broken.map(s => ({cells: [s.config, s.case, farOf(s), s.beyond]})));
  for (const s of broken) {
    if (!s.steps.some(t => t && data.pictures[t.picture])) continue;
    const more = add(parent, "details");
    add(more, "summary", {}, `${s.config}, ${s.case}`);
    more.addEventListener("toggle", () => showPictures(more, s), {once: true});
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
  add(panel, "h2", {}, `${s.config}: ${s.case}`);
  const card = add(panel, "div", {class: "card"});
  add(card, "p", {}, caseOf(s.case).what);
  add(card, "p", {class: s.state}, s.text);
  const ordinary = s.steps[caseOf(s.case).ordinary];
  if (ordinary && ordinary.rmse >= 0)
    add(card, "p", {class: "soft"}, `Its ordinary picture is off the ray-traced ground truth by ${three(ordinary.rmse)} ` +
      `(rmse; a white picture: ${three(ordinary.rmse_white)})` +
      (ordinary.exact > 0 ? `, and has ${three(100 * ordinary.occlusion / ordinary.exact)} % of its occlusion.` : "."));
  showSteps(card, s);
  showPictures(card, s);
};
if (series.length) {
  showPoints(main);
  showMatrix(main, select);
  main.append(panel);
  select(series.find(fails) || series[0]);
  showBreakdowns(main);
} else
  add(main, "p", {class: "warn"}, "There are no figures to show.");
