// SPDX-License-Identifier: MIT
// The panel: variants, features and params of config A, made of its state alone.
import {$, add, fillSelect} from "./dom.js";
import {costText} from "./knobs.js";
import {Param, buildTip} from "./param.js";
import {same} from "./scale.js";

const NO_GROUP = "Other", FIRST = ["intensity", "radius"];  // the last of them first

export class Panel {
  constructor(app) {
    Object.assign(this, {app, root: $("panel"), params: [], features: [], shape: ""});
    this.first = new Map();  // "config/param": what a config of the user's began with
    app.on("loaded", () => this.show());
    app.on("values", () => this.show());
    app.on("scene", () => this.show(true));
  }

  show(anew = false) {
    const state = this.app.stateA();
    if (!state) return;
    const {app} = this, shape = JSON.stringify([
      state.config, state.description, state.variants, app.engine.scene?.diagonal,
      state.params.map(p => [p.name, p.type, p.min, p.max, p.soft_max, p.step, p.unit, p.label, p.group, p.bind]),
      state.features.map(f => [f.name, f.values, f.boolean, f.label])
    ]);
    if (anew || shape !== this.shape) this.build(state);
    this.shape = shape;
    this.update(state);
  }

  build(state) {
    const {root} = this, open = this.openGroups();
    root.replaceChildren();
    this.params = [];
    this.features = [];
    this.buildHead(state);
    const groups = new Map();
    const place = param => FIRST.indexOf(param.name);
    for (const param of [...state.params].sort((a, b) => place(b) - place(a))) {
      const name = param.group || NO_GROUP;
      groups.set(name, [...groups.get(name) ?? [], param]);
    }
    const rank = ([name, params]) => params.some(p => p.semantic === "length") ? 0 : name === NO_GROUP ? 2 : 1;
    for (const [name, params] of [...groups].sort((a, b) => rank(a) - rank(b))) {
      const parent = this.group(name, open);
      for (const param of params) this.params.push(new Param(this.app, parent, param));
    }
    if (state.features.length) this.buildFeatures(this.group("Features", open), state);
  }
  openGroups() {
    return new Map([...this.root.querySelectorAll("details")].map(d => [d.dataset.name, d.open]));
  }
  group(name, open) {
    const node = add(this.root, "details", {class: "knobs", "data-name": name});
    node.open = open.get(name) ?? true;
    add(node, "summary", {}, name);
    return node;
  }

  buildHead(state) {
    const head = add(this.root, "div", {class: "head"});
    add(head, "p", {class: "soft"}, state.description);
    if (state.variants.length) {
      const label = add(head, "label", {}, "Variant ");
      this.variant = add(label, "select", {id: "variant", onchange: e => this.app.chooseVariant(e.target.value)});
      fillSelect(this.variant, [{value: "", text: "none"}, ...state.variants.map(value => ({value}))], this.app.a.variant);
    } else
      this.variant = null;
    const row = add(head, "div", {class: "row"});
    add(row, "button", {type: "button", id: "reset-all", onclick: () => this.resetAll()}, "Reset all");
    this.cost = add(row, "output", {class: "soft", id: "change-cost"});
  }
  resetAll() {
    const {app} = this;
    const broken = path => !app.loadedWell && !path.startsWith("configs/");  // any module may be why
    const own = path => path === app.path() || app.stateA().files.includes(path) || broken(path);
    app.takeBack(app.engine.editedPaths().filter(own));
  }

  buildFeatures(parent, state) {
    for (const feature of state.features) {
      const row = add(parent, "div", {class: "knob feature", "data-feature": feature.name});
      const label = add(row, "label", {}, "");
      const turn = value => {
        this.app.knobs.begin();
        this.app.knobs.turn("feature", feature.name, value);
      };
      const control = feature.boolean
        ? add(label, "input", {type: "checkbox", role: "switch", onchange: e => turn(String(e.target.checked))})
        : add(label, "select", {onchange: e => turn(e.target.value)});
      if (!feature.boolean) fillSelect(control, feature.values.map(value => ({value})), feature.value);
      label.append(feature.label || feature.name.replaceAll("_", " "));
      buildTip(row, feature, "feature-" + feature.name);
      const reset = resetButton(row, feature.name, () => this.app.knobs.reset("feature", feature.name));
      this.features.push({feature, control, reset});
    }
  }

  update(state) {
    for (const entry of this.features) {
      const now = state.features.find(f => f.name === entry.feature.name);
      if (entry.feature.boolean) entry.control.checked = now.value === "true" || now.value === true;
      else entry.control.value = now.value;
      entry.reset.disabled = String(now.value) === String(this.firstOf(state, now.name, now.shipped ?? now.initial));
    }
    for (const param of this.params) {
      const now = state.params.find(p => p.name === param.param.name);
      const first = now.shipped ?? this.firstOf(state, now.name, now.initial);
      param.update(now, !same(now.value, first));
    }
    if (this.variant) this.variant.value = this.app.a.variant;
    const {cost} = this.app.knobs;
    this.cost.textContent = cost ? costText(cost) : "";
  }
  // What a value was when the page first saw it.
  firstOf(state, name, value) {
    const key = `${state.config}:${this.app.a.variant}/${name}`;
    if (!this.first.has(key)) this.first.set(key, value);
    return this.first.get(key);
  }
}

export function resetButton(parent, name, onclick) {
  return add(parent, "button", {
    type: "button", class: "reset", "aria-label": `Reset ${name}`, title: "Back to the first value", onclick
  }, "↺");
}
