// SPDX-License-Identifier: MIT
// Turning params and features: the engine's value and the config's text are one state.
import {applyEdits, findNodeAtLocation as nodeAt, getNodeValue, parseTree} from "jsonc-parser";
import {SLOT, describe} from "./app.js";

export class Knobs {
  constructor(app) {
    this.app = app;
    this.cost = null;     // of the last change: {name, compiled, ms}
    this.gesture = 0;     // edits of one drag are undone together
    this.written = null;  // the name that the present drag has written already
    app.on("loaded", () => this.cost = null);
  }

  /// A drag or a held key begins: what it writes is one step of undo.
  begin() {
    ++this.gesture;
    this.written = null;
  }

  /// `kind` is "param" (value: list of numbers) or "feature" (value: its word).
  turn(kind, name, value) {
    const {app} = this;
    app.flushText();
    const call = kind === "param" ? "setParam" : "setFeature";
    const answer = app.ask(() => app.engine[call](SLOT.a, name, value));
    if (!answer.ok) return this.refused(answer);
    if (app.message?.kind === "error" && app.loadedWell) app.say(null);
    this.cost = {name, compiled: answer.compiled ?? [], ms: answer.ms};
    this.write(kind, name, value);
    app.keepShow();
    app.loadOthers();
    app.emit("values", name);
    app.redraw();
    return answer;
  }
  refused(answer) {
    this.app.say(describe(answer.diagnostics), "error");
    this.app.emit("values");
    return answer;
  }

  write(kind, name, value) {
    const {app} = this, path = app.path(), text = app.engine.source(path);
    if (text === null) return;
    const edits = setEdits(text, this.place(kind, name), this.spelled(kind, name, value));
    if (!edits) return app.say(`The value holds, but ${path} has a mistake and does not say it.`, "warning");
    this.edit(path, applyEdits(text, edits), name);
  }
  spelled(kind, name, value) {
    if (kind === "param") return value.length === 1 ? value[0] : value;
    const feature = this.app.stateA().features.find(f => f.name === name);
    return feature?.boolean ? value === "true" : value;
  }
  edit(path, text, name) {
    const joined = this.written === name;
    this.written = name;
    this.app.putText(path, text, joined);
  }

  /// The shipped value, and the text as if nobody had turned the knob.
  reset(kind, name) {
    const {app} = this, path = app.path(), text = app.engine.source(path);
    app.flushText();
    const place = this.place(kind, name), edits = text === null ? null : restoreEdits(text, app.firstText(path), place);
    if (!edits) return app.say(`${path} has a mistake: mend it first.`, "warning");
    this.begin();
    if (edits.length) this.edit(path, applyEdits(text, edits), name);
    app.reload();
  }

  /// Where in the config's text a value counts: in the variant, or in the present word of a feature that sets it.
  place(kind, name) {
    const level = this.levelOf(name);
    if (level) return level;
    const part = kind === "param" ? "params" : "features", {variant} = this.app.a;
    return variant ? ["variants", variant, part, name] : [part, name];
  }
  levelOf(name) {
    const state = this.app.stateA();
    for (const feature of state?.features.filter(f => f.sets) ?? [])
      for (const file of state.files.filter(f => f.endsWith(".json"))) {
        const sets = jsonOf(this.app.engine.source(file))?.features?.[feature.name]?.sets?.[feature.value];
        if (sets && name in sets) return ["features", feature.name, "sets", feature.value, name];
      }
    return null;
  }
}

function jsonOf(text) {
  const tree = text && treeOf(text);
  return tree ? getNodeValue(tree) : null;
}

/// "compiled 'ssao', 'blur', 34 ms"; the engine's sentences end with what was compiled.
export function costText({name, compiled, ms}) {
  const took = `${ms < 10 ? ms.toFixed(1) : Math.round(ms)} ms`;
  const passes = compiled.map(each => /compiled ('.*)$/.exec(each)?.[1] ?? each);
  return `${name}: ${passes.length ? "compiled " + passes.join(", ") : "nothing compiled"}, ${took}`;
}

// ---- The smallest edits of a config's text that set a value or take it away. Comments and layout stay

const OPTIONS = {allowTrailingComma: true};

/// The parsed text, or null where it is no JSON.
function treeOf(text) {
  const errors = [];
  const tree = parseTree(text, errors, OPTIONS);
  return errors.length || tree?.type !== "object" ? null : tree;
}

/// What a member says: the node of {"default": x}, or of the bare value, or undefined.
function saidAt(tree, path) {
  const node = tree && nodeAt(tree, path);
  return node?.type === "object" ? nodeAt(node, ["default"]) : node;
}

function literal(value) {
  if (Array.isArray(value)) return `[${value.map(literal).join(", ")}]`;
  if (value && typeof value === "object") {
    const members = Object.entries(value).map(([key, each]) => `${JSON.stringify(key)}: ${literal(each)}`);
    return members.length ? `{ ${members.join(", ")} }` : "{}";
  }
  return JSON.stringify(value);
}

/// Edits [{offset, length, content}] that make the param or feature at `path` have the value.
function setEdits(text, path, value) {
  const tree = treeOf(text);
  if (!tree) return null;
  return place(text, tree, memberAt(tree, path), value, literal(value));
}
const memberAt = (tree, path) => nodeAt(tree, path)?.type === "object" ? [...path, "default"] : path;

/// Edits that make `path` say what the text `before` said of it, or nothing.
function restoreEdits(text, before, path) {
  const tree = treeOf(text), old = before === null ? null : saidAt(treeOf(before), path);
  if (!tree) return null;
  if (old) {
    const raw = before.slice(old.offset, old.offset + old.length);
    return place(text, tree, memberAt(tree, path), JSON.parse(raw), raw);
  }
  let at = path, node = nodeAt(tree, path);
  if (node?.type === "object" && nodeAt(node, ["default"])) at = [...path, "default"], node = nodeAt(tree, at);
  if (!node) return [];
  while (at.length > 1 && node.parent.parent.children.length === 1) {
    const above = at.slice(0, -1);
    if (before !== null && nodeAt(treeOf(before), above)) break;
    at = above;
    node = nodeAt(tree, at);
  }
  return [removal(text, node.parent)];
}

function place(text, tree, path, value, content) {
  const node = nodeAt(tree, path);
  if (node) return [{offset: node.offset, length: node.length, content}];
  let depth = path.length - 1;
  while (depth > 0 && nodeAt(tree, path.slice(0, depth))?.type !== "object") --depth;
  const blocking = nodeAt(tree, path.slice(0, depth + 1));  // a null or a bare value is in the way
  const inner = path.slice(depth + 1).reduceRight((inside, key) => ({[key]: inside}), value);
  if (blocking) return [{offset: blocking.offset, length: blocking.length, content: literal(inner)}];
  return [insertion(text, depth ? nodeAt(tree, path.slice(0, depth)) : tree, path[depth], inner)];
}

function insertion(text, object, key, value) {
  const member = `${JSON.stringify(key)}: ${literal(value)}`, last = object.children.at(-1);
  if (!last) return {offset: object.offset, length: object.length, content: `{ ${member} }`};
  const end = last.offset + last.length, comma = commaAfter(text, end);
  const line = text.slice(0, last.offset).match(/\n([ \t]*)$/);
  const between = line ? "\n" + line[1] : " ";
  if (comma >= 0) return {offset: comma + 1, length: 0, content: between + member + ","};
  return {offset: end, length: 0, content: "," + between + member};
}

// The place of the comma that follows, behind blanks and comments; -1 for none.
function commaAfter(text, offset) {
  const rest = /^(?:\s|\/\/[^\n]*(?:\n|$)|\/\*[\s\S]*?\*\/)*,/.exec(text.slice(offset));
  return rest ? offset + rest[0].length - 1 : -1;
}

function removal(text, property) {
  const all = property.parent.children, i = all.indexOf(property);
  const end = property.offset + property.length, comma = commaAfter(text, end);
  if (i > 0) {
    const from = all[i - 1].offset + all[i - 1].length;
    return {offset: from, length: end - from, content: ""};
  }
  if (all.length > 1)
    return {offset: property.offset, length: all[1].offset - property.offset, content: ""};
  const from = property.parent.offset + 1;
  return {offset: from, length: Math.max(end, comma + 1) - from, content: ""};
}
