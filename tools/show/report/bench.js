// SPDX-License-Identifier: MIT
// Lays out the report: which config to take, each scene, what is missing.
"use strict";
const CLOCKS = {
  query: "the GPU's timer", cpu: "the processor time of the process", wall: "wall clock"
};
const ROLES = {
  cheapest: "Cheapest",
  balanced: data.coverage.whole ? "Take this" : "Take this of these",
  "most accurate": "Most accurate"
};
const stepOf = (advice, role) => advice.steps.find(s => s.roles.includes(role));
const costText = step => `${ms(step.ms)} a frame` +
  (step.ratio > 0 ? `, ${three(step.ratio)} times a copy of the depth texture` : "");

function showAnswer(parent, advice) {
  const take = stepOf(advice, "balanced"), without = advice.error_without_ao;
  const box = add(parent, "section", {class: "card answer"});
  if (!take)
    return add(box, "p", {class: "take"},
      advice.elided.length ?
        "No config that was measured alike in every scene is better than no ambient occlusion." :
        "None of these configs is better than no ambient occlusion.");
  const line =
    add(box, "p", {class: "take"}, data.coverage.whole ? "Take " : "Of what is measured, take ");
  add(line, "strong", {}, brief(take.label));
  add(box, "p", {},
    `It is off by ${error(take.error)} from ray-traced ambient occlusion, where no ambient ` +
      `occlusion at all is off by ${error(without)}. It adds ${costText(take)}.`);
  for (const role of ["cheapest", "most accurate"]) {
    const step = stepOf(advice, role), own = step === take, item = add(box, "p", {class: "other"});
    add(item, "strong", {}, `${ROLES[role]}: `);
    item.append(own ? "this one as well." :
                      `${brief(step.label)}, off by ${error(step.error)}, adds ${costText(step)}.`);
  }
  const scenes = advice.views.length > 1 ?
    `in the worst of ${advice.views.length} scenes (${advice.views.join(", ")})` :
    `in the scene ${advice.views[0]}`;
  const renderer = advice.software ? "a software renderer, " : "";
  add(box, "p", {class: "soft"},
    `Measured at ${advice.size}, ${scenes}, on ${advice.device} (${renderer}timed by ${CLOCKS[advice.clock]}).`);
}
function showSteps(parent, advice) {
  if (!advice.steps.length) return;
  const without = advice.error_without_ao, longest = Math.max(without, ...advice.steps.map(s => s.error));
  add(parent, "h2", {}, "What each further cost buys");
  add(parent, "p", {class: "soft"}, "Every config that no other beats in both error and cost.");
  const errorBar = (value, kind) => cell => bar(cell, value, longest, kind, error(value));
  table(parent, [["config", "label"], ["error", "wider"], ["adds", "num"], ["× copy", "num"], ["", "wide role"]], [
    {cells: ["no ambient occlusion", errorBar(without, "soft"), "0", "0", ""]},
    ...advice.steps.map(s => ({
      class: "step" + (s.roles.includes("balanced") ? " on" : ""),
      cells: [
        brief(s.label), errorBar(s.error, "accent"), ms(s.ms), times(s.ratio), s.roles.map(r => ROLES[r]).join(", ")
      ]
    }))
  ], {class: "advice"});
  if (advice.harmful.length)
    add(parent, "p", {class: "soft"},
      `Worse than no ambient occlusion in at least one scene: ${
        sampleLists(advice.harmful).join("; ")}.`);
}
// "a samples=4" and "a samples=8" as "a samples=4, 8".
function sampleLists(labels) {
  const lists = new Map();
  for (const label of labels.map(brief)) {
    const [, before, count = "", after = ""] =
      /^(.*? samples=)(\d+)(.*)$/.exec(label) || [label, label];
    const key = before + after, list = lists.get(key) || {before, after, counts: []};
    list.counts.push(count);
    lists.set(key, list);
  }
  return [...lists.values()].map(({before, after, counts}) => before + counts.join(", ") + after);
}

function showMissing(parent) {
  const measured = benchSamples.filter(p => !p.failure);
  const lacking = (what, failure) => measured.filter(p => p[failure])
    .map(p => `${p.label}, ${p.scene}: ${what}: ${p[failure]}`);
  const lines = [
    ...data.failures.map(({title, reason}) => `${title}: ${reason}`),
    ...lacking("a part of its error", "budget_failure"), ...lacking("its motion", "motion_failure"),
    ...data.advice.flatMap(a => a.elided).map(text => `Not among those to choose from: ${text}`)
  ];
  if (!lines.length) return;
  add(parent, "h2", {id: "missing"}, "What is missing");
  const list = add(parent, "ul", {class: "missing"});
  for (const text of lines) add(list, "li", {}, text);
}

// --- the page ---
const main = document.getElementById("main"), summary = document.getElementById("summary");
main.replaceChildren();
const measured = benchSamples.length - data.failures.length;
const versions = [...new Set(benchSamples.map(p => p.version))].join(", ");
const devices = data.advice.map(a => a.device).join("; ") || "no device";
summary.append(`${plural(measured, "bench sample")} measured by crevice ${versions} on ${devices}.`);
if (data.failures.length) {
  summary.append(" ");
  add(summary, "a", {class: "warn", href: "#missing"},
    `${plural(data.failures.length, "bench sample")} failed.`);
}
if (!data.coverage.whole)
  add(main, "p", {class: "warn part"}, `A part of a bench: ${data.coverage.text}.`);
if (!measured) add(main, "p", {class: "warn"}, "There are no figures to show.");
for (const advice of data.advice) {
  if (data.advice.length > 1) add(main, "h2", {}, advice.device);
  showAnswer(main, advice);
  const scenes = new Map(), take = stepOf(advice, "balanced")?.label;
  for (const view of data.views.filter(v => v.device === advice.device))
    scenes.set(view.name, [...(scenes.get(view.name) || []), view]);
  showSteps(main, advice);
  for (const views of scenes.values()) showScene(main, views, take);
  showCurves(main, advice.curves, "Across scenes");
}
showMissing(main);
