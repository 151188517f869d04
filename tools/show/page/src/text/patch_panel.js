// SPDX-License-Identifier: MIT
// The smallest patch that gives the picture: to copy, to save, to share.
import {$, add, button, copyText, debounce, download, flash} from "../dom.js";
import {describe} from "../app.js";
import {makeCommand} from "../command_line.js";
import {share} from "../toolbar.js";

export function makePatch(app) {
  const root = $("patch");
  add(root, "p", {class: "soft"}, "The smallest config that draws as here; it extends the shipped one. Scene, camera and size are not in it, but in the command below it.");
  const row = add(root, "div", {class: "row"});
  const copy = button(row, "Copy", () => copyText(text.textContent, copy), {id: "patch-copy"});
  const save = button(row, "Download", () => {
    download(fileName(), text.textContent + "\n");
    flash(save, "Downloaded");
  }, {id: "patch-save"});
  button(row, "Share as a link", e => app.during(() => share(app, e.target)));
  const note = add(root, "p", {class: "soft"}), text = add(root, "pre", {id: "patch-text", tabindex: 0, "aria-label": "The patch"});
  const showCommand = makeCommand(app, root, "Copy the command of the patch");
  const nameIn = json => /^\s*{[^{}]*"name"\s*:\s*"([\w-]+)"/.exec(json)?.[1];
  const fileName = () => `${nameIn(text.textContent) ?? app.a.config + "_mine"}.json`;
  const show = () => {
    if (app.tab !== "patch" || !app.stateA()) return;
    const answer = app.ask(() => app.engine.patch(0));
    text.textContent = answer.ok ? answer.text.trimEnd() : describe(answer.diagnostics);
    copy.disabled = save.disabled = !answer.ok;
    note.textContent = answer.ok ? "" : "There is no patch of this state.";
    showCommand(fileName());
  };
  const later = debounce(100, show);
  app.on("tab", show);
  for (const event of ["loaded", "values", "camera", "size", "scene", "sides"]) app.on(event, later);
}
