// SPDX-License-Identifier: MIT
// Appended to a copy of a report: does what a reader does and writes down what came of it.
"use strict";
const found = {};
const marks = [...document.querySelectorAll(".pareto .point")];
const markOf = key => marks.find(m => m.dataset.key === key);
const textOf = selector => document.querySelector(selector)?.textContent || "";
found.marks = marks.map(m => m.dataset.key).sort().join(" ");
found.onFront = marks.filter(m => m.classList.contains("top")).map(m => m.dataset.key).sort().join(" ");
found.names = [...document.querySelectorAll(".pareto .name")].map(n => n.textContent).sort().join(", ");
found.answer = textOf(".answer .take");
found.steps = document.querySelectorAll("table.advice .step").length;
markOf("b4").dispatchEvent(new MouseEvent("click", {bubbles: true}));
found.click = textOf(".panel").includes("fine samples=4") && textOf(".panel").includes("crevice render fine");
found.clickPictures = document.querySelectorAll(".pictures img[src^='data:image/png;base64,']").length;
markOf("c4").focus();
document.activeElement.dispatchEvent(new KeyboardEvent("keydown", {key: "Enter", bubbles: true}));
found.enter = textOf(".panel").includes("<b>slow</b> samples=4");
found.markup = document.querySelectorAll("main b").length;
found.tableRows = document.querySelectorAll("table.bench-samples tbody tr").length;
found.motion = textOf("table.bench-samples").includes("0.0123");
found.missing = textOf(".missing").includes("the shader does not link");
found.background = getComputedStyle(document.body).backgroundColor;
// No window gets as narrow as a phone, but a page does; call it with a window under 640 wide.
document.documentElement.style.width = "390px";
found.phone = document.body.scrollWidth <= 390;
const list = document.createElement("pre");
list.id = "found";
list.textContent = Object.entries(found).map(([name, value]) => `${name}=${value}`).join("\n") + "\n";
document.body.append(list);
