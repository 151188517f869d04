// SPDX-License-Identifier: MIT
// Against the truth: traces the view, draws the difference over the picture, and prints how far AO is.
import {$, add, debounce, fillSelect, press} from "./dom.js";
import {shown} from "./scale.js";
import {Truth} from "./engine/truth.js";

const HINT = "Press Truth: the view is ray-traced here, and AO is compared with it.";
const RAYS = [16, 64, 256, 1024];
const TRACE_AFTER_MS = 300;      // of the last move
const SHOW_EVERY_MS = 150;       // while rays come in
const DEFAULT_RADIUS_SHARE = 0.05;  // of the scene's diagonal, for configs without a length

// That of A: its param "radius", else its first length.
function radiusOf(app) {
  const lengths = app.stateA()?.params.filter(p => p.semantic === "length") ?? [];
  const param = lengths.find(p => p.name === "radius") ?? lengths[0];
  return param?.value[0] ?? DEFAULT_RADIUS_SHARE * app.engine.scene.diagonal;
}

export class TruthView {
  constructor(app) {
    Object.assign(this, {app, on: false, image: null, figures: null, stale: true, key: "", rays: 64});
    this.overlay = $("overlay");
    this.paint = this.overlay.getContext("2d");
    this.build(add($("view"), "div", {class: "card truth", id: "truth-card"}));
    this.later = debounce(TRACE_AFTER_MS, () => this.start());
    $("truth").addEventListener("click", () => this.turn(!this.on));
    app.on("drawn", () => this.on && this.check());
    app.on("sides", () => this.clip());
  }

  build(card) {
    const {app} = this;
    add(card, "h2", {}, "Against the truth");
    this.hint = add(card, "p", {class: "soft"}, HINT);
    const row = add(card, "div", {class: "row"});
    const rays = add(add(row, "label", {}, "Rays a pixel "), "select", {id: "truth-rays", onchange: e => {
      this.rays = Number(e.target.value);
      this.key = "";
      app.redraw();
    }});
    fillSelect(rays, RAYS.map(value => ({value})), this.rays);
    this.bar = add(row, "progress", {max: 1, value: 0, "aria-label": "Rays traced", hidden: ""});
    const list = add(card, "dl", {class: "numbers", "aria-live": "off", id: "truth-numbers"});
    this.numbers = Object.fromEntries(["rmse", "bias", "p99"].map(name => {
      add(list, "dt", {}, name);
      return [name, add(list, "dd", {"data-figure": name}, "–")];
    }));
    this.list = list;
  }

  turn(on) {
    this.on = on;
    press($("truth"), on);
    this.key = "";
    if (on) return this.app.redraw();
    this.later.cancel();
    this.endTrace();
    Object.assign(this, {image: null, figures: null});
    this.overlay.hidden = true;
    this.showNumbers();
    this.bar.hidden = true;
  }

  // After each frame: is what was traced still of this view?
  check() {
    const {app} = this, view = this.view();
    const key = JSON.stringify(view);
    if (key !== this.key) {
      this.key = key;
      this.stale = true;
      this.endTrace();
      this.overlay.hidden = true;
      this.tracing = true;
      this.later();
      return this.showNumbers();
    }
    this.compare();
  }
  view() {
    const {app} = this;
    return {camera: app.camera, size: [...app.engine.size], radius: radiusOf(app), rays: this.rays, scene: app.engine.scene.name};
  }
  endTrace() {
    if (!this.tracing) return;
    this.tracing = false;
    this.tracer?.cancel();
  }

  start() {
    const {app} = this, {camera, size, radius, rays} = this.view(), key = this.key;
    if (!this.on) return this.endTrace();
    this.bar.hidden = false;
    this.bar.value = 0;
    app.guard(() => {
      this.tracer ??= new Truth(app.engine);
      this.tracer.start({camera, size, radius, rays}, progress => app.guard(() => this.progress(key, progress)),
        error => this.failed(key, error));
    });
  }
  failed(key, error) {
    if (key !== this.key) return;
    this.endTrace();
    this.bar.hidden = true;
    this.app.fail(error);
  }
  progress(key, {done, image}) {
    if (!this.on || key !== this.key) return;
    this.bar.value = done;
    if (image && (done >= 1 || performance.now() - (this.shownAt ?? 0) > SHOW_EVERY_MS)) {
      this.shownAt = performance.now();
      this.image = image;
      this.stale = false;
      this.compare();
    }
    if (done < 1) return;
    this.bar.hidden = true;
    this.tracing = false;
  }

  compare() {
    const {app} = this;
    if (!this.image || this.stale || app.sides().left.slot !== 0) return this.showNumbers();
    const {picture, ...answer} = app.ask(() => app.engine.compare(0, this.image));
    this.figures = answer.ok ? answer : null;
    this.showNumbers();
    this.drawOverlay(picture);
  }
  showNumbers() {
    const {figures} = this, signed = x => (x >= 0 ? "+" : "−") + Math.abs(x).toFixed(4);
    this.list.classList.toggle("stale", this.stale || !figures);
    this.numbers.rmse.textContent = figures ? figures.rmse.toFixed(4) : "–";
    this.numbers.bias.textContent = figures ? signed(figures.bias) : "–";
    this.numbers.bias.title = figures ? (figures.bias >= 0 ? "too bright" : "too dark") : "";
    this.numbers.p99.textContent = figures ? figures.p99.toFixed(4) : "–";
    this.hint.textContent =
      this.on ? `AO of A minus the truth within ${shown(radiusOf(this.app))} scene units, A's radius:` : HINT;
  }

  drawOverlay(picture) {
    const {app, overlay} = this, [w, h] = app.engine.size;
    overlay.hidden = !this.on || this.stale || !this.image || !this.figures;
    if (overlay.hidden) return;
    const [low, high] = $("scale").querySelectorAll("span"), {range} = this.figures;
    low.textContent = `dark −${range}`;
    high.textContent = `+${range} bright`;
    if (overlay.width !== w || overlay.height !== h) Object.assign(overlay, {width: w, height: h});
    this.paint.putImageData(picture, 0, 0);
    this.clip();
  }
  clip() {
    const {on, at} = this.app.split;
    this.overlay.style.clipPath = on ? `inset(0 ${100 * (1 - at)}% 0 0)` : "";
  }
}
