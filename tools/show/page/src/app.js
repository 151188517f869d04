// SPDX-License-Identifier: MIT
// What the page shows, and the only place that loads slots and turns knobs. All engine calls go through `ask`.
import {debounce} from "./dom.js";
import {Drawing} from "./drawing.js";
import {Knobs} from "./knobs.js";

export const SLOT = {a: 0, b: 1, without: 2, unit: 3};  // `unit`: what costs are compared with
const OUTPUTS = ["color", "ao"];
const DOUBT = "doubt", DOUBT_RMSE = "doubt_rmse";  // outputs that are drawn on request
const NO_SUCH_TARGET = "CV2209";
const APPLY_AFTER_MS = 250;  // of the last key in an editor

/// A view is "color", "ao", "without" (lit without AO), "doubt", "view:NAME" (a view of the config's) or "target:NAME". The engine's
/// name of what is looked at beside the outputs, or null:
export const lookOf = show =>
  show.startsWith("target:") ? "target." + show.slice(7) : show.startsWith("view:") ? show.slice(5) : show === DOUBT ? show : null;
export const drawnName = show => lookOf(show) ?? (show === "without" ? "color" : show);

export class App {
  constructor(engine) {
    this.engine = engine;
    this.listeners = new Map();
    this.busy = 1;  // until the page has started
    this.a = {config: "", variant: "", show: "color"};
    this.b = {config: "", variant: "", show: "without"};  // without a config: A's
    this.split = {on: false, at: 0.5};
    this.camera = "";
    this.builtin = null;      // the scene's name where it is a built-in one
    this.sizeChoice = "fit";
    this.diagnostics = [];
    this.firstTexts = new Map();  // of files without a shipped text: what they were at first
    this.drawing = new Drawing(this);
    this.knobs = new Knobs(this);
    this.applyLater = debounce(APPLY_AFTER_MS, () => this.reload());
  }

  // ---- listeners; a listener that throws is told to the user
  on(name, call) {
    this.listeners.set(name, [...this.listeners.get(name) ?? [], call]);
  }
  emit(name, ...given) {
    for (const call of this.listeners.get(name) ?? []) this.guard(() => call(...given));
  }
  guard(call) {
    try {
      const result = call();
      if (typeof result?.then === "function") return result.catch(e => this.fail(e));
      return result;
    } catch (e) {
      return this.fail(e);
    }
  }
  fail(error) {
    console.error(error);
    this.say(error?.message || String(error), "error");
    return null;
  }
  /// One message that the user sees; `kind` is "error", "warning" or "note". Null takes it away.
  say(text, kind = "note") {
    this.message = text ? {text, kind} : null;
    this.emit("message", this.message);
  }

  /// The answer of an engine's call; what it throws is an answer that is not ok.
  ask(call) {
    try {
      return call() ?? {ok: true, diagnostics: []};
    } catch (e) {
      return {ok: false, diagnostics: [{severity: "error", code: "", message: e?.message || String(e)}]};
    }
  }
  /// As `ask`, and says what went wrong.
  must(call) {
    const answer = this.ask(call);
    if (!answer.ok) this.say(describe(answer.diagnostics), "error");
    return answer;
  }

  // ---- what is under way; for tests, whenIdle() waits until nothing is
  async during(work) {
    ++this.busy;
    try {
      return await work();
    } catch (e) {
      return this.fail(e);
    } finally {
      --this.busy;
    }
  }
  isIdle() {
    return !this.busy && !this.truth.tracing && !this.applyLater.waits() && !this.drawing.isPending();
  }
  async whenIdle() {
    do await new Promise(done => setTimeout(done, 5));
    while (!this.isIdle());
  }

  // ---- configs
  path(config = this.a.config) {
    return `configs/${config}.json`;
  }
  stateA() {
    return this.engine.state(SLOT.a);
  }
  /// The first texts of a config that is not shipped are what a reset goes back to.
  firstText(path) {
    const shipped = this.engine.shippedSource(path);
    return shipped ?? this.firstTexts.get(path) ?? null;
  }
  rememberFirst(path) {
    if (this.engine.shippedSource(path) === null && !this.firstTexts.has(path))
      this.firstTexts.set(path, this.engine.source(path));
  }

  chooseConfig(config, variant = "") {
    this.a = {...this.a, config, variant};
    this.rememberFirst(this.path());
    const answer = this.loadA();
    this.emit("config");
    return answer;
  }
  chooseVariant(variant) {
    this.a.variant = variant;
    return this.loadA();
  }

  request(side, slot) {
    const {config, variant} = this.effective(side), load = look => this.ask(() => this.engine.load(slot, {
      config, variant, outputs: side.show === DOUBT ? [...OUTPUTS, DOUBT_RMSE] : OUTPUTS, look,
      without_occlusion: side.show === "without" && slot !== SLOT.a
    }));
    const look = lookOf(side.show), answer = load(look ?? undefined);
    if (answer.ok || !look || !answer.diagnostics.some(d => d.code === NO_SUCH_TARGET)) return answer;
    side.show = "ao";  // another config may not have that target
    return load();
  }
  effective(side) {
    return side.config ? side : this.a;
  }

  loadA() {
    this.applyLater.cancel();
    const answer = this.request(this.a, SLOT.a);
    this.diagnostics = answer.diagnostics ?? [];
    this.loadedWell = answer.ok;
    if (answer.ok) {
      this.say(null);
      this.keepShow();
      this.loadOthers();
    } else
      this.say(describe(this.diagnostics) + (this.stateA() ? "\nThe last good config is drawn meanwhile." : ""), "error");
    this.emit("diagnostics");
    this.emit("loaded");
    this.redraw();
    return answer;
  }
  /// A and all that hangs on the same texts.
  reload() {
    const answer = this.loadA();
    if (this.needsB() && this.b.config) this.loadB();
    return answer;
  }
  // What A no longer has cannot be shown.
  keepShow() {
    const choices = this.choices(this.stateA());
    if (!choices.includes(this.a.show)) this.a.show = choices.includes("color") ? "color" : choices[0] ?? "ao";
  }
  choices(state) {
    if (!state) return [];
    const outputs = OUTPUTS.filter(name => state.outputs.includes(name));
    const without = outputs.includes("color") ? ["without"] : [];
    const targets = [...new Set(state.targets.map(t => "target:" + t.name))];
    const doubt = state.outputs.includes(DOUBT) && state.outputs.includes(DOUBT_RMSE) ? [DOUBT] : [];
    return [...outputs, ...without, ...doubt, ...state.views.map(v => "view:" + v.name), ...targets];
  }
  /// The rmse that is expected of what a slot shows, where it shows that; else null.
  expected(side, slot) {
    const read = side.show === DOUBT ? this.ask(() => this.engine.readBack(slot, DOUBT_RMSE)) : {};
    return read.answer?.ok ? read.values[0] : null;
  }
  loadOthers() {
    if (this.a.show === "without") this.must(() => this.request({...this.a}, SLOT.without));
    if (this.needsB() && !this.b.config) this.loadB();
  }

  // ---- what is seen
  needsB() {
    return this.split.on && (this.b.config !== "" || !OUTPUTS.includes(this.b.show));
  }
  loadB() {
    const answer = this.must(() => this.request(this.b, SLOT.b));
    this.emit("loadedB");
    this.redraw();
    return answer;
  }
  setShow(which, show) {
    const side = this[which], before = side.show;
    side.show = show;
    const answer = which === "b" ? this.refreshB() : this.showA(before);
    if (answer && !answer.ok) side.show = before;
    this.emit("sides");
    this.redraw();
  }
  showA(before) {
    if (this.a.show === "without") return this.must(() => this.request(this.a, SLOT.without));
    return lookOf(this.a.show) || lookOf(before) ? this.loadA() : null;
  }
  refreshB() {
    return this.needsB() ? this.loadB() : null;
  }
  chooseB(config, variant = "") {
    const show = this.b.config ? this.b.show : this.a.show;  // at first the same of another config
    this.b = {show, config, variant};
    const answer = this.refreshB();
    if (answer && !answer.ok) this.b.config = "";
    this.emit("sides");
    this.redraw();
  }
  setSplit(on, at = this.split.at) {
    const turned = on !== this.split.on;
    this.split = {on, at: Math.min(1, Math.max(0, at))};
    if (turned) this.openB();
    this.emit("sides");
    this.redraw();
  }
  // Beside A's own picture stands another of its pictures, so that there is something to see.
  openB() {
    const others = this.choices(this.stateA()).filter(show => show !== this.a.show), {b} = this;
    if (this.split.on && !b.config && !others.includes(b.show)) b.show = others.includes("without") ? "without" : others[0] ?? b.show;
    this.refreshB();
  }
  /// What draw() is asked for: {left, right, split}.
  sides() {
    const left = {slot: this.a.show === "without" ? SLOT.without : SLOT.a, show: drawnName(this.a.show)};
    if (!this.split.on) return {left, right: null, split: 1};
    const right = {slot: this.needsB() ? SLOT.b : SLOT.a, show: drawnName(this.b.show)};
    return {left, right, split: this.split.at};
  }

  // ---- scene, camera, size
  sceneChanged(builtin) {
    this.builtin = builtin;
    this.camera = "";
    this.emit("scene");
    this.emit("camera");
    this.redraw();
  }
  chooseScene(name) {
    if (this.must(() => this.engine.loadBuiltinScene(name)).ok) this.sceneChanged(name);
  }
  setCamera(text) {
    this.camera = text;
    this.emit("camera");
    this.redraw();
  }
  /// {eye, at, up, fov_deg | ortho_height} of the camera in force, or null.
  resolved() {
    const answer = this.ask(() => this.engine.resolveCamera(this.camera, this.engine.size[0] / this.engine.size[1]));
    return answer.ok ? answer : null;
  }
  setSize(size) {
    if (String(size) === String(this.engine.size)) return;
    this.must(() => this.engine.setSize(...size));
    this.emit("size");
    this.redraw();
  }

  // ---- texts
  /// A text that somebody typed: it is drawn a little later.
  typed(path, text) {
    this.putText(path, text);
    this.applyLater();
  }
  /// `joined`: part of the step of undo before.
  putText(path, text, joined = false) {
    this.engine.setSource(path, text === this.engine.shippedSource(path) ? null : text);
    this.emit("text", path, joined);
  }
  /// Makes files say again what they said at first.
  takeBack(paths) {
    for (const path of paths) {
      const first = this.firstText(path);
      if (first !== null && first !== this.engine.source(path)) this.putText(path, first);
    }
    this.reload();
  }
  flushText() {
    this.applyLater.flush();
  }

  redraw() {
    this.drawing.wake();
  }
}

/// The first error as one sentence with its place.
export function describe(diagnostics = []) {
  const first = diagnostics.find(d => d.severity === "error") ?? diagnostics[0];
  if (!first) return "It failed, and no reason is known.";
  const place = first.file ? `${first.file}${first.line ? `:${first.line}:${first.column}` : ""}: ` : "";
  const more = diagnostics.filter(d => d.severity === "error").length - 1;
  return `${place}${first.code ? first.code + " " : ""}${first.message}${more > 0 ? ` (and ${more} more)` : ""}`;
}
