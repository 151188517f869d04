// SPDX-License-Identifier: MIT
// What pages share: their data, and making elements. Text goes in as text, never as markup.
"use strict";
const data = JSON.parse(document.getElementById("data").textContent);
const SVG = "http://www.w3.org/2000/svg";
const plural = (n, word) => `${n} ${word}${n === 1 ? "" : "s"}`;

function add(parent, tag, attributes = {}, ...children) {
  const svg = parent.namespaceURI === SVG || tag === "svg";
  const node = svg ? document.createElementNS(SVG, tag) : document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (name.startsWith("on"))
      node.addEventListener(name.slice(2), value);
    else if (value !== null)
      node.setAttribute(name, value);
  }
  node.append(...children.map(String));
  parent.append(node);
  return node;
}

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
