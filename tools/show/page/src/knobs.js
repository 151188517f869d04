// SPDX-License-Identifier: MIT
// Turning params and features: the engine's value and the config's text are one state.
import {applyEdits, getNodeValue} from "jsonc-parser";
import {restoreEdits, setEdits, treeOf} from "./text/json_edit.js";
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
