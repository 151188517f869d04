// SPDX-License-Identifier: MIT
// One param of the panel: a slider over its soft range and a field over its hard range for each component.
import {add} from "./dom.js";
import {resetButton} from "./panel.js";
import {clamped, round, scaleOf, shown} from "./scale.js";

const AXES = ["x", "y", "z", "w"];
let serial = 0;

export class Param {
  constructor(app, parent, param) {
    Object.assign(this, {app, param, id: `knob-${++serial}`});
    this.scale = scaleOf(param, app.engine.scene?.diagonal);
    this.row = add(parent, "div", {class: "knob", "data-param": param.name, role: "group", "aria-labelledby": this.id});
    this.buildHead();
    this.parts = param.value.map((_, i) => this.buildPart(i));
  }

  buildHead() {
    const {param} = this, head = add(this.row, "div", {class: "name"});
    add(head, "span", {id: this.id}, param.label || param.name);
    const unit = param.unit && param.unit !== "1" ? param.unit : "";
    if (unit) add(head, "span", {class: "unit"}, unit);
    if (param.bind === "define")
      add(head, "span", {class: "badge", title: "Another value compiles shaders again."}, "compiles");
    buildTip(head, param, this.id);
    this.reset = resetButton(head, param.label || param.name, () => this.app.knobs.reset("param", param.name));
  }

  buildPart(i) {
    const {param, scale} = this, many = param.value.length > 1;
    const name = (param.label || param.name) + (many ? " " + AXES[i] : "");
    const line = add(this.row, "div", {class: "line-of"});
    if (many) add(line, "span", {class: "axis-name", "aria-hidden": "true"}, AXES[i]);
    const slider = add(line, "input", {
      type: "range", min: 0, max: scale.places, step: 1, "aria-label": name, "data-component": i,
      "aria-describedby": param.tooltip ? this.id + "-tip" : null,
      onpointerdown: () => this.app.knobs.begin(),
      onkeydown: e => e.repeat || this.app.knobs.begin(),
      oninput: () => this.turn(i, scale.value(Number(slider.value)))
    });
    const field = add(line, "input", {
      type: "number", step: "any", min: bound(param.min), max: bound(param.max), "aria-label": `${name}, number`,
      onchange: () => this.typed(i, field)
    });
    return {slider, field};
  }
  typed(i, field) {
    this.app.knobs.begin();
    if (field.value === "" || !Number.isFinite(field.valueAsNumber)) return this.update(this.now, !this.reset.disabled);
    this.turn(i, round(field.valueAsNumber, 7));
  }
  turn(i, number) {
    const value = this.now.value.map(v => round(v, 7));
    value[i] = clamped(this.param, number);
    this.app.knobs.turn("param", this.param.name, value);
  }

  update(now, changed) {
    this.now = now;
    this.reset.disabled = !changed;
    this.parts.forEach(({slider, field}, i) => {
      const value = now.value[i], place = String(this.scale.place(value));
      if (slider.value !== place) slider.value = place;
      slider.setAttribute("aria-valuetext", `${shown(value)} ${this.param.unit === "1" ? "" : this.param.unit}`.trim());
      if (Number(field.value) !== Number(shown(value)) || field.value === "") field.value = shown(value);
    });
  }
}

// The tooltip of a param or feature, seen when the pointer is over it, when it has the focus, and after a tap.
export function buildTip(head, {name, label, tooltip}, owner) {
  if (!tooltip) return;
  const id = owner + "-tip", info = add(head, "button", {
    type: "button", class: "info", "aria-label": `About ${label || name}`, "aria-describedby": id,
    onclick: () => info.classList.toggle("open"),
    onblur: () => info.classList.remove("open"),
    onkeydown: e => e.key === "Escape" && info.blur()
  }, "?");
  add(head, "span", {class: "tip", role: "tooltip", id}, `${tooltip} (${name})`);
}

const bound = x => Math.abs(x) >= 1e29 ? null : x;
