// SPDX-License-Identifier: MIT
// The tab of texts: the files of config A, the editor (loaded after the first picture), and the list of diagnostics.
import {$, add, button, fillSelect} from "../dom.js";

export class Texts {
  constructor(app) {
    Object.assign(this, {app, path: null, editor: null});
    const root = $("text"), row = add(root, "div", {class: "row"});
    this.files = add(row, "select", {"aria-label": "File", class: "grow", id: "file", onchange: e => this.open(e.target.value)});
    this.revert = button(row, "Revert file", () => app.takeBack([this.path]), {id: "revert", title: "Back to the text that ships"});
    this.note = add(row, "output", {class: "soft"});
    this.place = add(root, "div", {class: "editor", id: "editor"});
    add(this.place, "p", {class: "soft"}, "The editor is loading…");
    this.list = add(root, "ol", {class: "diagnostics", id: "diagnostics", "aria-live": "polite"});
    app.on("config", () => this.open(app.path()));
    for (const event of ["loaded", "text"]) app.on(event, () => this.showFiles());
    app.on("text", (path, joined) => this.editor?.follow(path, joined));
    app.on("diagnostics", () => this.showDiagnostics());
  }

  /// Loads the editor; until then knobs change the engine's texts alone.
  async start() {
    const {Editor} = await import("./editor.js");
    this.place.replaceChildren();
    this.editor = new Editor(this.app, this.place);
    this.open(this.path ?? this.app.path());
    this.showDiagnostics();
  }

  open(path, place = null) {
    if (this.app.engine.source(path) === null) return;
    this.path = path;
    this.showFiles();
    this.editor?.open(path, place);
  }
  showFiles() {
    const {app} = this, edited = new Set(app.engine.editedPaths().filter(path => app.firstText(path) !== app.engine.source(path)));
    const wrong = new Set(app.diagnostics.filter(d => d.severity === "error").map(d => d.file));
    const own = app.path(), all = [own, ...app.stateA()?.files ?? []];
    if (this.path && !all.includes(this.path)) all.push(this.path);
    const paths = [...new Set(all)].filter(path => app.engine.source(path) !== null);
    const mark = path => (edited.has(path) ? " •" : "") + (wrong.has(path) ? " ⚠" : "");
    const group = path => path.endsWith(".json") ? "JSON" : "GLSL";
    const sorted = [...paths].sort((a, b) => (group(a) === "GLSL") - (group(b) === "GLSL"));
    fillSelect(this.files, sorted.map(value => ({value, text: value + mark(value), group: group(value)})), this.path);
    this.revert.disabled = !edited.has(this.path) || app.firstText(this.path) === null;
    this.note.textContent = edited.has(this.path) ? "changed" : "";
  }

  showDiagnostics() {
    const {app, list} = this;
    list.replaceChildren();
    for (const each of app.diagnostics) {
      const item = add(list, "li", {class: each.severity});
      const place = each.file ? `${each.file}:${each.line || 1}:${each.column || 1}` : "";
      if (place) button(item, place, () => this.jump(each), {class: "link"});
      explain(item, each);
    }
    this.editor?.lint();
    this.showFiles();
  }
  jump(diagnostic) {
    if (this.app.engine.source(diagnostic.file) === null) return;
    this.open(diagnostic.file, {line: diagnostic.line || 1, column: diagnostic.column || 1});
  }
}

/// Writes a diagnostic with its notes and help into a node, which it returns.
export function explain(node, {severity, code, message, notes = [], help}) {
  add(node, "span", {}, ` ${severity} ${code ?? ""}: ${message}`);
  for (const note of notes) add(node, "p", {class: "soft"}, note.text);
  if (help) add(node, "p", {}, `help: ${help}`);
  return node;
}
