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
import {getLocation} from "jsonc-parser";
import {add} from "../dom.js";
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

// ---- From the library's places (lines, and columns in bytes, both from 1) to offsets in a string

/// How many UTF-16 units of the line hold this many bytes of UTF-8.
function unitsOf(line, bytes) {
  const all = new TextEncoder().encode(line), decoder = new TextDecoder("utf-8", {ignoreBOM: true});
  return decoder.decode(all.subarray(0, bytes)).length + Math.max(0, bytes - all.length);
}

/// {from, to} in the text; at least one character long where there is one.
function rangeOf(text, {line = 1, column = 1, length = 0}) {
  const lines = text.split("\n"), row = Math.min(Math.max(1, line), lines.length) - 1;
  const start = lines.slice(0, row).reduce((sum, each) => sum + each.length + 1, 0), own = lines[row];
  const from = Math.min(own.length, unitsOf(own, Math.max(1, column) - 1));
  const to = Math.min(own.length, from + unitsOf(own.slice(from), length || wordBytes(own.slice(from))));
  return to > from ? {from: start + from, to: start + to}
                   : {from: start + Math.max(0, Math.min(from, own.length - 1)), to: start + Math.max(own.length && 1, to)};
}

// Where no length is known: the word there, else one character.
const wordBytes = rest => /^\w+/.exec(rest)?.[0].length ?? 1;

// ---- What a JSON Schema (draft 7) says of a place in a document: its keys, its words, what they mean

function schemasAt(schema, path) {
  let now = expand(schema, schema);
  for (const step of path) now = now.flatMap(each => below(schema, each, step));
  return now;
}

function expand(root, schema, depth = 0) {
  if (!schema || typeof schema !== "object" || depth > 16) return [];
  const parts = [schema];
  if (schema.$ref) parts.push(resolve(root, schema.$ref));
  const more = [...schema.anyOf ?? [], ...schema.oneOf ?? [], ...schema.allOf ?? []];
  const inside = [...parts.slice(1), ...more].flatMap(each => expand(root, each, depth + 1));
  return [schema, ...inside];
}
function resolve(root, ref) {
  return ref.replace(/^#\/?/, "").split("/").filter(Boolean)
    .reduce((node, key) => node?.[key.replaceAll("~1", "/").replaceAll("~0", "~")], root);
}
function below(root, schema, step) {
  if (typeof step === "number") {
    const items = Array.isArray(schema.items) ? schema.items[step] : schema.items;
    return expand(root, items);
  }
  if (schema.properties && Object.hasOwn(schema.properties, step)) return expand(root, schema.properties[step]);
  const pattern = Object.entries(schema.patternProperties ?? {}).find(([key, value]) =>
    new RegExp(key, "u").test(step) && Object.keys(value).length);
  return expand(root, pattern ? pattern[1] : schema.additionalProperties);
}

const description = schemas => schemas.find(s => s.description)?.description ?? "";

/// [{label, detail, info, type}] of keys that an object at the path may have.
function keysAt(schema, path) {
  const keys = new Map();
  for (const each of schemasAt(schema, path)) {
    for (const [label, value] of Object.entries(each.properties ?? {}))
      if (!keys.has(label)) keys.set(label, {label, info: description(expand(schema, value)), type: "property"});
    for (const label of each.propertyNames?.enum ?? [])
      if (!keys.has(label)) keys.set(label, {label, type: "property"});
  }
  return [...keys.values()];
}

/// The same of values: words, and true, false, null where they may stand.
function valuesAt(schema, path) {
  const values = new Map(), put = (value, info) => {
    const label = JSON.stringify(value);
    if (!values.has(label)) values.set(label, {label, info: info ?? "", type: typeof value === "string" ? "text" : "keyword"});
  };
  for (const each of schemasAt(schema, path)) {
    (each.enum ?? []).forEach((value, i) => value !== null && put(value, each.enumDescriptions?.[i]));
    if ("const" in each) put(each.const, each.description);
    if ([each.type].flat().includes("boolean")) put(true), put(false);
  }
  return [...values.values()];
}

/// What the key or value under the offset means: {title, text}, or null.
function meaningAt(schema, text, offset) {
  const {path, previousNode} = getLocation(text, offset);
  if (!path.length) return null;
  const found = schemasAt(schema, path), words = [];
  for (const each of found) {
    const at = previousNode ? (each.enum ?? []).indexOf(previousNode.value) : -1;
    if (at >= 0 && each.enumDescriptions?.[at]) words.push(each.enumDescriptions[at]);
  }
  const said = words[0] ?? description(found), range = rangeText(found);
  const initial = found.find(s => "default" in s);
  const rest = [range, initial ? `default ${JSON.stringify(initial.default)}` : ""].filter(Boolean).join(", ");
  return said || rest ? {title: path.join(" / "), text: [said, rest].filter(Boolean).join("\n")} : null;
}
function rangeText(schemas) {
  const found = schemas.find(s => Math.abs(s.minimum ?? 1e30) < 1e29 || Math.abs(s.maximum ?? 1e30) < 1e29);
  return found ? `[${found.minimum ?? ""}, ${found.maximum ?? ""}]` : "";
}

/// Completion at an offset: {from, to, options, wantsColon}, or null.
function completionAt(schema, text, offset) {
  const location = getLocation(text, offset), {path, previousNode, isAtPropertyKey} = location;
  const inside = previousNode && offset > previousNode.offset && offset <= previousNode.offset + previousNode.length;
  const from = inside ? previousNode.offset : offset - /[\w"\/.-]*$/.exec(text.slice(0, offset))[0].length;
  const to = inside ? previousNode.offset + previousNode.length : offset;
  if (!isAtPropertyKey) return {from, to, options: valuesAt(schema, path), key: false};
  const options = keysAt(schema, path.slice(0, -1));
  return {from, to, options: options.map(o => ({...o, label: JSON.stringify(o.label)})), key: true};
}
