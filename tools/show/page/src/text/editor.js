// SPDX-License-Identifier: MIT
// The text editor: CodeMirror on one file at a time, each with its own history. Loaded after the first picture.
import {autocompletion} from "@codemirror/autocomplete";
import {indentWithTab, isolateHistory} from "@codemirror/commands";
import {json} from "@codemirror/lang-json";
import {StreamLanguage, syntaxHighlighting} from "@codemirror/language";
import {shader} from "@codemirror/legacy-modes/mode/clike";
import {lintGutter, setDiagnostics} from "@codemirror/lint";
import {Annotation, EditorState, Transaction} from "@codemirror/state";
import {EditorView, hoverTooltip, keymap} from "@codemirror/view";
import {classHighlighter} from "@lezer/highlight";
import {basicSetup} from "codemirror";
import {add} from "../dom.js";
import {rangeOf} from "./places.js";
import {completionAt, meaningAt} from "./schema_help.js";
import {explain} from "./texts.js";

// {from, to, insert} without what is the same before and behind, or null.
function difference(old, now) {
  if (old === now) return null;
  const least = Math.min(old.length, now.length);
  let from = 0, end = 0;
  while (from < least && old[from] === now[from]) ++from;
  while (end < least - from && old.at(-1 - end) === now.at(-1 - end)) ++end;
  return {from, to: old.length - end, insert: now.slice(from, now.length - end)};
}

const brought = Annotation.define();  // a change that the engine's text has already

export class Editor {
  constructor(app, parent) {
    Object.assign(this, {app, path: null, states: new Map()});
    this.view = new EditorView({parent});
  }

  get schema() {
    return this.known ??= this.app.engine.schema();
  }

  open(path, place) {
    this.change(path);
    this.lint();
    if (!place) return;
    const {from, to} = rangeOf(this.view.state.doc.toString(), {...place, length: 0});
    this.view.dispatch({selection: {anchor: from, head: place.select ? to : from}, effects: EditorView.scrollIntoView(from, {y: "center"})});
    this.view.focus();
  }
  change(path) {
    if (this.path === path) return;
    if (this.path) this.states.set(this.path, this.view.state);
    this.path = path;
    this.view.setState(this.states.get(path) ?? this.fresh(path));
    this.follow(path);
  }
  fresh(path) {
    const isJson = path.endsWith(".json");
    return EditorState.create({
      doc: this.app.engine.source(path),
      extensions: [
        basicSetup, keymap.of([indentWithTab, {key: "Escape", run: leave}]), lintGutter(),
        EditorState.lineSeparator.of(this.app.engine.source(path).includes("\r\n") ? "\r\n" : "\n"),
        syntaxHighlighting(classHighlighter), EditorView.lineWrapping, EditorState.tabSize.of(isJson ? 2 : 4),
        EditorView.contentAttributes.of({"aria-label": `Text of ${path}`}),
        isJson ? this.jsonTools() : StreamLanguage.define(shader),
        EditorView.updateListener.of(update => this.updated(path, update))
      ]
    });
  }
  jsonTools() {
    return [
      json(), autocompletion({icons: false, override: [context => this.complete(context)]}),
      hoverTooltip((view, offset) => this.hover(view, offset))
    ];
  }

  updated(path, update) {
    if (!update.docChanged || update.transactions.some(t => t.annotation(brought))) return;
    this.app.guard(() => this.app.typed(path, update.state.sliceDoc()));
  }

  /// Makes a document say what the engine has, by the smallest change: one step of undo, or part of the step before
  /// where `joined`.
  follow(path, joined = false) {
    const state = path === this.path ? this.view.state : this.states.get(path), source = this.app.engine.source(path);
    if (!state || source === null) return;
    const change = difference(state.doc.toString(), source.replaceAll("\r\n", "\n"));
    if (!change) return;
    // That event's name makes the history join the change with the one before, however long ago it was.
    const undo = joined ? Transaction.userEvent.of("input.type.compose") : isolateHistory.of("before");
    const spec = {changes: change, annotations: [brought.of(true), undo]};
    if (path === this.path) this.view.dispatch(spec);
    else this.states.set(path, state.update(spec).state);
  }

  complete(context) {
    const found = completionAt(this.schema, context.state.doc.toString(), context.pos);
    if (!found?.options.length || (!context.explicit && found.from === context.pos)) return null;
    const colon = found.key && !/^\s*:/.test(context.state.sliceDoc(found.to, found.to + 20));
    return {
      from: found.from, to: found.to, filter: true,
      options: found.options.map(option => ({...option, info: option.info || undefined, apply: colon ? option.label + ": " : option.label}))
    };
  }
  hover(view, offset) {
    const found = meaningAt(this.schema, view.state.doc.toString(), offset);
    if (!found) return null;
    return {pos: offset, above: true, create: () => {
      const dom = document.createElement("div");
      dom.className = "hover-doc";
      add(dom, "strong", {}, found.title);
      add(dom, "p", {}, found.text);
      return {dom};
    }};
  }

  /// Squiggles of the app's diagnostics in the open file, one each.
  lint() {
    if (!this.path) return;
    const text = this.view.state.doc.toString();
    const own = this.app.diagnostics.filter(d => d.file === this.path);
    this.view.dispatch(setDiagnostics(this.view.state, own.map(d => ({
      ...rangeOf(text, d), severity: d.severity === "error" ? "error" : d.severity === "warning" ? "warning" : "info",
      source: d.code, message: d.message, renderMessage: () => explain(document.createElement("div"), d)
    }))));
  }
}

// Tab indents: Escape leaves the editor for those who have only a keyboard.
function leave(view) {
  document.getElementById("file").focus();
  return true;
}
