// SPDX-License-Identifier: MIT
// Appended to a copy of a report: does what a reader does and writes down what came of it.
"use strict";
const found = {};
const marks = [...document.querySelectorAll(".pareto .point")];
const markOf = key => marks.find(m => m.dataset.key === key);
const panelText = () => document.querySelector(".panel").textContent;
found.marks = marks.map(m => m.dataset.key).sort().join(" ");
found.onFront = marks.filter(m => m.classList.contains("top")).map(m => m.dataset.key).sort().join(" ");
found.titles = marks.every(m => m.querySelector("title").textContent.includes("error"));
found.best = document.querySelector(".cards .best .name").textContent;
found.adviceRows = document.querySelectorAll("table.advice tbody tr").length;
markOf("a16").dispatchEvent(new PointerEvent("pointerenter"));
found.hover = panelText().includes("quick samples=16") && panelText().includes("error 0.0900");
markOf("b4").dispatchEvent(new MouseEvent("click", {bubbles: true}));
found.click = panelText().includes("fine samples=4");
found.clickPictures = document.querySelectorAll(".pictures img[src^='data:image/png;base64,']").length;
markOf("c4").focus();
found.focus = document.activeElement === markOf("c4");
document.activeElement.dispatchEvent(new KeyboardEvent("keydown", {key: "Enter", bubbles: true}));
found.enter = panelText().includes("<b>slow</b> samples=4");
found.enterPictures = document.querySelectorAll(".pictures img").length;
found.markup = document.querySelectorAll("main b").length;
document.querySelectorAll(".switch button")[1].click();
found.ratioAxis = document.querySelector(".pareto > svg").textContent.includes("depth copy");
found.stillMarks = document.querySelectorAll(".pareto .point").length;
found.bars = document.querySelectorAll(".bar").length;
found.slopes = document.querySelectorAll(".slopes li").length;
found.tableRows = document.querySelectorAll("details table tbody tr").length;
found.missing = document.querySelector(".missing").textContent.includes("the shader does not link");
found.background = getComputedStyle(document.body).backgroundColor;
// No window gets as narrow as a phone, but a page does; call it with a window under 640 wide.
document.documentElement.style.width = "390px";
redraw();
found.phone = document.body.scrollWidth <= 390;
const list = document.createElement("pre");
list.id = "found";
list.textContent = Object.entries(found).map(([name, value]) => `${name}=${value}`).join("\n") + "\n";
document.body.append(list);
