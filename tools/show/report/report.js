// SPDX-License-Identifier: MIT
// What the pages of reports share: their data, and elements. Text goes in as text, never as markup.
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
