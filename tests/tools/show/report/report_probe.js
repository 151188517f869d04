// SPDX-License-Identifier: MIT
// Appended to a copy of a report: does what a reader does and writes down what came of it.
"use strict";
const found = {};
const marks = [...document.querySelectorAll(".pareto .point")];
const markOf = key => marks.find(m => m.dataset.key === key);
const textOf = selector => document.querySelector(selector)?.textContent || "";
found.marks = marks.map(m => m.dataset.key).sort().join(" ");
found.onFront = marks.filter(m => m.classList.contains("top")).map(m => m.dataset.key).sort().join(" ");
found.titles = marks.every(m => m.getAttribute("aria-label").includes("error"));
found.answer = textOf(".answer .take");
found.answerError = textOf(".answer").includes("off by 0.050") && textOf(".answer").includes("off by 0.200");
found.steps = document.querySelectorAll("table.advice .step").length;
found.openPanel = textOf(".panel").includes("fine samples=4");
found.names = [...document.querySelectorAll(".pareto .name")].map(n => n.textContent).sort().join(", ");
const hover = markOf("a16").querySelector("title").textContent;
found.hover = hover.includes("quick samples=16") && hover.includes("0.090");
markOf("b4").dispatchEvent(new MouseEvent("click", {bubbles: true}));
found.click = textOf(".panel").includes("fine samples=4") && textOf(".panel").includes("crevice render fine");
found.clickPictures = document.querySelectorAll(".pictures img[src^='data:image/png;base64,']").length;
markOf("c4").focus();
found.focus = document.activeElement === markOf("c4");
document.activeElement.dispatchEvent(new KeyboardEvent("keydown", {key: "Enter", bubbles: true}));
found.enter = textOf(".panel").includes("<b>slow</b> samples=4");
found.enterPictures = document.querySelectorAll(".pictures img").length;
found.markup = document.querySelectorAll("main b").length;
found.budgets = document.querySelectorAll(".budget").length;
found.motion = [...document.querySelectorAll("tr.motion")].map(r => r.textContent).join(";");
found.slopes = [...document.querySelectorAll(".charts .legend")].filter(l => / −?\d\.\d\d/.test(l.textContent)).length;
found.tableRows = document.querySelectorAll("table.bench-samples tbody tr").length;
found.missing = document.querySelector(".missing").textContent.includes("the shader does not link");
found.background = getComputedStyle(document.body).backgroundColor;
// No window gets as narrow as a phone, but a page does; call it with a window under 640 wide.
document.documentElement.style.width = "390px";
found.phone = document.body.scrollWidth <= 390;
const list = document.createElement("pre");
list.id = "found";
list.textContent = Object.entries(found).map(([name, value]) => `${name}=${value}`).join("\n") + "\n";
document.body.append(list);
