// SPDX-License-Identifier: MIT
// Lays out the report: which config to take; for each view the plot, the chosen bench sample's pictures and all figures;
// what is missing. Text goes in as text, never as markup.
"use strict";
// columns: [title, class of its cells]; rows: {cells, attributes}, where a cell is a text or fills its element.
function table(parent, columns, rows, attributes = {}) {
  const made = add(add(parent, "div", {class: "card scroll"}), "table", attributes);
  const head = add(add(made, "thead"), "tr"), body = add(made, "tbody");
  for (const [title, kind = ""] of columns) add(head, "th", {class: kind}, title);
  for (const {cells, ...own} of rows) {
    const row = add(body, "tr", own);
    cells.forEach((cell, i) => {
      const node = add(row, "td", {class: columns[i][1] || ""});
      typeof cell === "function" ? cell(node) : node.append(cell);
    });
  }
}

// A figure with a bar of its length.
function bar(cell, value, longest, kind, text) {
  add(cell, "span", {class: "figure"}, text);
  const width = Math.min(100, Math.max(0, 100 * value / longest));
  add(cell, "i", {class: "bar", style: `width:${width}%;background:var(--${kind})`});
}

// shown: [picture, caption, what it is for those who do not see it]; what the page does not have is left out.
function pictures(parent, kind, shown) {
  const strip = add(parent, "div", {class: kind});
  for (const [picture, caption, alt] of shown) {
    if (!data.pictures?.[picture]) continue;
    const figure = add(strip, "figure");
    add(figure, "img", {src: data.pictures[picture], alt});
    add(figure, "figcaption", {}, caption);
  }
  if (!strip.children.length) strip.remove();
  return strip.children.length;
}

const benchSamples = data.bench_samples;
const families = [...new Set(benchSamples.map(s => s.family))];
const colorOf = family => `var(--f${families.indexOf(family) % 8})`;
const three = x => x >= 1000 ? Math.round(x).toLocaleString("en") : String(Number(x.toPrecision(3)));
const ms = x => three(x) + " ms";
const error = x => x.toFixed(x < 0.01 ? 4 : 3);
const times = x => x > 0 ? three(x) + "×" : "–";
// "some/where/mine.json /generated/kernel/shape=cube" as "mine.json shape=cube".
const brief = label => label.replace(/^\S*\/(?=[^\s/]+\.json)/, "").replace(/ \/\S*\/(?=[^\s/]+=)/g, " ");
const CLOCKS = {query: "the GPU's timer", cpu: "the processor time of the process", wall: "wall clock"};
const ROLES = {cheapest: "Cheapest", balanced: "Take this", "most accurate": "Most accurate"};

function showAdvice(parent, advice) {
  const take = advice.steps.find(s => s.roles.includes("balanced")), without = advice.error_without_ao;
  const box = add(parent, "section", {class: "card answer"}), line = add(box, "p", {class: "take"});
  if (!take) return line.append("None of these configs is better than no ambient occlusion in every scene.");
  line.append("Take ");
  add(line, "strong", {}, brief(take.label));
  add(box, "p", {}, `It is off by ${error(take.error)} from ray-traced ambient occlusion, where no ambient occlusion at ` +
    `all is off by ${error(without)}. It adds ${ms(take.ms)} a frame.`);
  const renderer = advice.software ? "a software renderer, " : "";
  add(box, "p", {class: "soft"}, `Measured at ${advice.size} in ${advice.views.join(", ")}, where each config counts with ` +
    `its worst, on ${advice.device} (${renderer}timed by ${CLOCKS[advice.clock]}).`);
  add(parent, "p", {class: "soft"}, "What each further cost buys: the configs that no other beats in both error and cost.");
  table(parent, [["config", "label"], ["error"], ["adds", "num"], ["× learnopengl", "num"], [""]], [
    {cells: ["no ambient occlusion", error(without), "0", "0", ""]},
    ...advice.steps.map(s => ({
      class: "step" + (s === take ? " on" : ""),
      cells: [brief(s.label), cell => bar(cell, s.error, without, "accent", error(s.error)), ms(s.ms), times(s.ratio),
        s.roles.map(role => ROLES[role]).join(", ")]
    }))
  ], {class: "advice"});
}

function showSample(panel, s) {
  panel.replaceChildren();
  add(panel, "h3", {}, brief(s.label));
  pictures(panel, "pictures", [
    [s.ao_picture, "this config"], [s.ground_truth_picture, "ray-traced ground truth"],
    [s.difference_picture, "difference: red is too bright, blue too dark"]
  ].map(([picture, caption]) => [picture, caption, `${caption}: ${s.label}`]));
  const quoted = word => /^[\w.,\/=:+-]+$/.test(word) ? word : `'${word}'`;
  const set = s.overrides.map(o => " --set " + quoted(o)).join("");
  add(panel, "code", {}, `crevice render ${quoted(s.config)}${set} --scene ${quoted(s.scene)} --out ao=ao.png`);
}

const COLUMNS = [
  ["error", s => error(s.error.rmse)], ["bias", s => s.error.bias.toFixed(4)], ["p99", s => s.error.p99.toFixed(3)],
  ["pattern", s => error(s.error.pattern)],
  ["fitted (power)", s => `${error(s.error.rmse_fit)} (${s.error.power_fit.toFixed(2)})`],
  ["cost, ms", s => three(s.cost.median)], ["middle half", s => `${three(s.cost.q1)}–${three(s.cost.q3)}`],
  ["× learnopengl", s => times(s.ratio_learnopengl)],
  ["with its geometry, ms", s => three(s.cost_with_geometry.median)], ["frame, ms", s => three(s.total.median)],
  ["MB", s => (s.texture_bytes / 1e6).toFixed(1)],
  ["passes, ms", s => s.passes.map(pass => `${pass.name} ${three(pass.ms.median)}`).join(" · ")]
];
const PATHS = ["still", "sub-pixel", "pan", "strafe", "disocclusion"];
const MOTION = PATHS.map(path => [path, s => s.motion?.paths[path]?.rms.toFixed(4) ?? "–"]);

function showView(parent, view, open) {
  const all = view.bench_samples.map(i => benchSamples[i]).sort((a, b) => costOf(a) - costOf(b) || a.error.rmse - b.error.rmse);
  let least = view.error_without_ao;
  const front = all.filter(s => costOf(s) > 0 && s.error.rmse < least && (least = s.error.rmse, true));
  const section = add(parent, "details", {class: "view", open: open ? "" : null});
  add(section, "summary", {}, `${view.name}, ${view.size}, radius ${view.radius}`);
  const card = add(section, "div", {class: "card"}), plot = add(card, "div", {class: "pareto"});
  const panel = add(card, "div", {class: "panel", "aria-live": "polite"}), select = s => showSample(panel, s);
  drawPlot(plot, view, front, select);
  if (front.length) select(front[0]);
  const columns = [...COLUMNS, ...(all.some(s => s.motion) ? MOTION : [])];
  const link = s => cell => {
    add(cell, "span", {class: "dot", style: `background:${colorOf(s.family)}`});
    add(cell, "button", {class: "link", type: "button", onclick: () => select(s)}, brief(s.label) + (front.includes(s) ? " ★" : ""));
  };
  table(section, [["config (★: no other beats it)", "label"], ...columns.map(([name]) => [name, "num"])],
    all.map(s => ({cells: [link(s), ...columns.map(([, text]) => text(s))]})), {class: "bench-samples"});
}

function showMissing(parent) {
  const lines = [
    ...benchSamples.filter(s => s.failure).map(s => `${s.title}: ${s.failure}`),
    ...benchSamples.filter(s => s.motion_failure).map(s => `${s.title}: its motion: ${s.motion_failure}`),
    ...data.advice.flatMap(a => [
      ...a.elided.map(text => `Not among those to choose from: ${text}`),
      ...a.harmful.map(label => `Worse than no ambient occlusion in at least one scene: ${label}`)
    ])
  ];
  if (!lines.length) return;
  add(parent, "h2", {id: "missing"}, "What is missing");
  const list = add(parent, "ul", {class: "missing"});
  for (const text of lines) add(list, "li", {}, text);
}

const main = document.getElementById("main"), summary = document.getElementById("summary");
main.replaceChildren();
const measured = benchSamples.filter(s => !s.failure).length, failed = benchSamples.length - measured;
summary.append(`${plural(measured, "bench sample")} measured by crevice ` +
  `${[...new Set(benchSamples.map(s => s.version))].join(", ")}. `);
if (failed) add(summary, "a", {class: "warn", href: "#missing"}, `${plural(failed, "bench sample")} failed.`);
for (const advice of data.advice) {
  if (data.advice.length > 1) add(main, "h2", {}, advice.device);
  showAdvice(main, advice);
  for (const view of data.views) if (view.device === advice.device) showView(main, view, view.main);
}
showMissing(main);
