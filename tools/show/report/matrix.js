// SPDX-License-Identifier: MIT
// Lays out the results of a matrix: its cells, those that failed first chosen, and what each check found.
"use strict";
const passes = state => ["passed", "unchanged", "skipped"].includes(state);
const isBad = cell => cell.checks.some(check => !passes(check.state));

function picture(parent, file, caption) {
  const figure = add(parent, "figure");
  add(figure, "img", {src: file, alt: caption, loading: "lazy"});
  add(figure, "figcaption", {}, caption);
  return figure;
}

// What was wanted and what was drawn, one over the other.
function wipe(parent, check, name) {
  const figure = add(parent, "figure"), both = add(figure, "div", {class: "wipe"});
  add(both, "img", {src: check.wanted, alt: `wanted of ${name}`, loading: "lazy"});
  add(both, "img", {src: check.got, alt: `drawn of ${name}`, loading: "lazy"});
  add(figure, "input", {
    type: "range", min: 0, max: 100, value: 50, "aria-label": `wanted to drawn of ${name}`,
    oninput: event => both.style.setProperty("--at", event.target.value + "%"),
  });
  add(figure, "figcaption", {}, "wanted | drawn");
}

// `alone`: what was drawn is shown where nothing is compared, too.
function showCheck(parent, check, name, alone) {
  const line = add(parent, "p");
  add(line, "span", {class: "state " + check.state}, check.state);
  line.append(` ${check.title}${check.text ? ": " + check.text : ""}`);
  if (!check.got || (!alone && passes(check.state))) return;
  const strip = add(parent, "div", {class: "pictures"});
  if (check.wanted) {
    wipe(strip, check, name);
    picture(strip, check.wanted, "wanted");
  }
  picture(strip, check.got, "drawn");
  if (check.difference) picture(strip, check.difference, "difference");
}

function showCells(parent, cells) {
  parent.replaceChildren();
  if (!cells.length) add(parent, "p", {class: "soft"}, "No cell is like that.");
  for (const cell of cells) {
    const section = add(parent, "section", {class: "card cell"});
    add(section, "h3", {}, cell.name);
    add(section, "p", {class: "soft"},
      Object.entries(cell.values).map(([axis, value]) => `${axis} ${value}`).join(" · "));
    const first = isBad(cell) ? null : cell.checks.find(check => check.got);
    for (const check of cell.checks) showCheck(section, check, `${cell.name}, ${check.title}`, check === first);
  }
}

const main = document.getElementById("main");
main.replaceChildren();
document.getElementById("summary").append(`${data.matrix}: ${plural(data.cells.length, "cell")}; of their checks ` +
  ["passed", "failed", "skipped", "new", "changed", "unchanged"].filter(state => data[state])
    .map(state => `${data[state]} ${state}`).join(", "));
const filters = add(main, "p", {class: "filters"});
const bad = data.cells.filter(isBad);
const label = add(filters, "label");
const only = add(label, "input", {type: "checkbox", onchange: update});
label.append(` only what failed or changed (${bad.length})`);
only.checked = bad.length > 0;
const text = add(add(filters, "label", {}, "name contains "), "input", {type: "search", oninput: update});
const list = add(main, "div");
function update() {
  showCells(list, (only.checked ? bad : data.cells).filter(cell => cell.name.includes(text.value)));
}
update();
