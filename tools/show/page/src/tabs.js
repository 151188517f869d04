// SPDX-License-Identifier: MIT
// The tabs, and the message over the picture.
import {$} from "./dom.js";

const NOTE_MS = 8000;  // how long a note stays; errors and warnings stay until they are mended or closed
const WIDE = "(min-width: 900px)";  // as in page.css: there the view's panel stands below the picture

export function makeTabs(app) {
  const tabs = [...$("tabs").querySelectorAll("[role=tab]")], wide = matchMedia(WIDE);
  const panelOf = tab => $(tab.getAttribute("aria-controls"));
  const shownTabs = () => tabs.filter(tab => !(wide.matches && tab.id === "tab-view"));
  const choose = tab => {
    for (const each of tabs) {
      const on = each === tab;
      each.setAttribute("aria-selected", String(on));
      each.tabIndex = on ? 0 : -1;
      panelOf(each).hidden = !on && !(each.id === "tab-view" && wide.matches);
    }
    app.tab = tab.id.slice(4);
    app.emit("tab", app.tab);
  };
  const fit = () => choose(shownTabs().find(tab => tab.getAttribute("aria-selected") === "true") ?? tabs[0]);
  for (const tab of tabs) tab.addEventListener("click", () => choose(tab));
  $("tabs").addEventListener("keydown", e => {
    const list = shownTabs(), at = list.indexOf(document.activeElement);
    const to = {ArrowRight: at + 1, ArrowLeft: at - 1, Home: 0, End: list.length - 1}[e.key];
    if (to === undefined || at < 0) return;
    e.preventDefault();
    const next = list[(to + list.length) % list.length];
    choose(next);
    next.focus();
  });
  wide.addEventListener("change", fit);
  fit();
  app.openTab = name => choose($("tab-" + name));
}

export function makeMessage(app) {
  const node = $("message"), [text, close] = node.children;
  let timer = 0;
  close.addEventListener("click", () => app.say(null));
  app.on("message", message => {
    node.hidden = !message;
    clearTimeout(timer);
    if (!message) return;
    if (message.kind === "note") timer = setTimeout(() => app.say(null), NOTE_MS);
    node.dataset.kind = message.kind;
    text.textContent = message.text;
  });
}
