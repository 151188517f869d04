// SPDX-License-Identifier: MIT
// `crevice view` serves this page with the user's files: what is saved here is written there, and the other way round.
import {describe} from "./app.js";

const LOCAL = /^(127\.0\.0\.1|\[::1\]|localhost)$/, TOKEN = /\/[0-9a-f]{32}\/$/;

/// What the command wants to be seen, or null on a plain server. Plain addresses are not asked: a 404 would be noise.
export async function openView() {
  if (!LOCAL.test(location.hostname) || !TOKEN.test(location.pathname)) return null;
  // First, so that no edit falls between the two.
  const source = new EventSource("events"), edits = {early: [], take: edit => edits.early.push(edit)};
  source.addEventListener("file", event => edits.take(JSON.parse(event.data)));
  await new Promise(answered => {
    source.onopen = source.onerror = answered;
  });
  const response = await fetch("view.json");
  return response.ok ? {...await response.json(), edits} : null;
}
export async function viewScene() {
  const response = await fetch("scene");
  if (!response.ok) throw new Error(`The scene did not come: ${response.status} ${response.statusText}`);
  return new Uint8Array(await response.arrayBuffer());
}

/// Shows a model that is dropped on the page. Its reader is the command's; a page of its own has none.
export function takeModels(app, view) {
  addEventListener("dragover", e => e.preventDefault());
  addEventListener("drop", e => {
    e.preventDefault();
    const [file] = e.dataTransfer?.files ?? [];
    if (file) app.during(() => takeModel(app, view, file));
  });
}
async function takeModel(app, view, file) {
  if (!view) return app.say(`This page shows its own scenes. Run: crevice view --scene ${file.name}`, "warning");
  const response = await fetch("scene/" + encodeURIComponent(file.name), {method: "PUT", body: file});
  const {message, diagnostics} = await response.json().catch(() => ({message: response.statusText}));
  if (!response.ok) return app.say(message ?? describe(diagnostics), "error");
  const bytes = await viewScene();
  if (!app.must(() => app.engine.loadSceneBytes(bytes, file.name)).ok) return null;
  app.sceneChanged(null);
  app.reload();
  return diagnostics.length && app.say(describe(diagnostics), "warning");
}

export class ViewFiles {
  constructor(app, view, node) {
    Object.assign(this, {app, node, files: new Map(Object.entries(view.files ?? {}))});
    node.hidden = !view.editable;
    node.addEventListener("click", () => this.save());
    addEventListener("keydown", e => {
      if (!(e.ctrlKey || e.metaKey) || e.key.toLowerCase() !== "s") return;
      e.preventDefault();
      this.save();
    });
    app.on("text", () => this.mark());
    for (const [path, {text}] of this.files) app.firstTexts.set(path, text);
    view.edits.take = edit => app.guard(() => this.changed(edit));
    view.edits.early.forEach(view.edits.take);
    this.mark();
  }

  unsaved() {
    return [...this.files].filter(([path, file]) => this.app.engine.source(path) !== file.text);
  }
  mark() {
    const count = this.unsaved().length;
    this.node.disabled = count === 0;
    this.node.textContent = count ? "Save •" : "Save";
  }

  save() {
    return this.app.during(async () => {
      let saved = 0;
      for (const [path] of this.unsaved()) saved += await this.put(path) ? 1 : 0;
      if (saved) this.app.say(`Saved ${saved === 1 ? "the file" : saved + " files"}.`);
      this.mark();
    });
  }
  async put(path) {
    const {app} = this, file = this.files.get(path), text = app.engine.source(path);
    const response = await fetch("files/" + path.split("/").map(encodeURIComponent).join("/"),
      {method: "PUT", body: text, headers: {"If-Match": file.version}});
    if (response.status === 409) return this.conflict(path, await response.json());
    if (!response.ok) return app.say(`${path} was not saved: ${response.status} ${response.statusText}`, "error"), false;
    this.files.set(path, {text, version: (await response.json()).version});
    app.firstTexts.set(path, text);
    app.emit("text", path);
    return true;
  }
  // Both are kept: what is here stays in the editor, a second save writes over the other.
  conflict(path, {text, version}) {
    this.files.set(path, {text, version});
    this.app.say(`${path} was changed on disk meanwhile and not saved. Save again to write over it, or press Revert file to ` +
      "take what is on disk.", "error");
    this.app.firstTexts.set(path, text);
    return false;
  }

  changed({path, text, version}) {
    const {app} = this, file = this.files.get(path);
    if (file?.version === version) return;
    const edited = file && app.engine.source(path) !== file.text && app.engine.source(path) !== text;
    if (edited) return this.conflict(path, {text, version});
    this.files.set(path, {text, version});
    app.firstTexts.set(path, text);
    app.putText(path, text);
    app.reload();
    this.mark();
  }
}
