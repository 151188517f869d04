// SPDX-License-Identifier: MIT
// The page: opens the engine, draws the first picture, and only then loads the editor.
import {$, add} from "./dom.js";
import {App} from "./app.js";
import {makeChoice} from "./choice_panel.js";
import {makeCosts, makePlan} from "./cost_panel.js";
import {openEngine} from "./engine/engine.js";
import {readLink} from "./link.js";
import {Panel} from "./panel.js";
import {makePatch} from "./text/patch_panel.js";
import {PictureInput} from "./picture_input.js";
import {makeScenePanel} from "./scene_panel.js";
import {makeSplit} from "./split.js";
import {makeMessage, makeTabs} from "./tabs.js";
import {Texts} from "./text/texts.js";
import {Timing} from "./timing.js";
import {makeToolbar} from "./toolbar.js";
import {TruthView} from "./truth_view.js";
import {ViewFiles, openView, takeModels, viewScene} from "./view_server.js";

const FIRST = {config: "mobile", scene: "street", params: {msaa: 4, ambient: 0.5, intensity: 2}};

function build(app) {
  app.canvas = $("canvas");
  app.timing = new Timing(app);
  makeMessage(app);
  makeToolbar(app);
  makeScenePanel(app);
  app.truth = new TruthView(app);
  app.panel = new Panel(app);
  app.texts = new Texts(app);
  makePatch(app);
  makePlan(app);
  makeCosts(app);
  makeChoice(app);
  makeSplit(app);
  new PictureInput(app, app.canvas);
  makeTabs(app);
}

// Brings the page to what a link or the command says; what cannot be had is the first of its kind.
function show(app, wanted) {
  const {engine} = app, scenes = engine.builtinScenes();
  for (const path of engine.editedPaths()) if (!(path in wanted.files)) engine.setSource(path, null);
  for (const [path, text] of Object.entries(wanted.files)) engine.setSource(path, text);
  const missing = [], has = name => name && engine.source(app.path(name)) !== null;
  if (wanted.config && !has(wanted.config)) missing.push(`config '${wanted.config}'`);
  if (wanted.scene && !scenes.includes(wanted.scene)) missing.push(`scene '${wanted.scene}'`);
  const scene = scenes.includes(wanted.scene) ? wanted.scene : FIRST.scene;
  if (!wanted.sceneShown && app.builtin !== scene) app.chooseScene(scene);
  app.chooseSize(wanted.size ?? "fit");
  app.setCamera(wanted.camera ?? "");
  if (wanted.camera && !app.resolved()) {
    missing.push(`camera '${wanted.camera}'`);
    app.setCamera("");
  }
  const {split} = wanted;
  app.split = {on: false, at: 0.5};
  app.b = split ? {config: has(split.config) ? split.config : "", variant: split.variant, show: split.show} : app.b;
  const show = {lit: "color"}[wanted.show] ?? wanted.show;
  if (show) app.a.show = show;
  app.chooseConfig(has(wanted.config) ? wanted.config : FIRST.config, wanted.variant ?? "");
  for (const [name, value] of Object.entries(wanted.params ?? {})) app.knobs.turn("param", name, [value]);
  if (split?.on) app.setSplit(true, split.at);
  app.emit("sides");
  if (missing.length) app.later = `Not here: ${missing.join(", ")}.`;
  if (app.later && app.loadedWell) app.say(app.later, "warning");
  app.later = null;
}

// The link's words go before the command's, whose files stay as they are edited.
async function wanted(app, view) {
  const link = await readLink(location.hash).catch(e => {
    app.later = e.message;
  });
  if (!view) return link ?? {...FIRST, files: {}};
  const own = Object.entries(view.files ?? {}).map(([path, {text}]) => [path, app.viewFiles ? app.engine.source(path) : text]);
  const said = {...link, files: {...Object.fromEntries(own), ...link?.files}};
  if (!said.config) Object.assign(said, {config: view.config, variant: said.variant || view.variant});
  if (!link && !own.length && view.config === FIRST.config) said.params = FIRST.params;
  return said.scene ? said : {...said, camera: said.camera || view.camera, ...await sceneOf(app, view)};
}
async function sceneOf(app, view) {
  if (!view.scene?.bytes) return {scene: view.scene?.builtin ?? null};
  const answer = app.engine.loadSceneBytes(await viewScene(), view.scene.name);
  if (!answer.ok) throw new Error(answer.diagnostics[0]?.message ?? "The scene cannot be read.");
  app.sceneChanged(null);
  return {sceneShown: true};
}

async function start() {
  const engine = await openEngine($("canvas"));
  const app = new App(engine);
  window.crevice = {engine, app};
  build(app);
  const view = await openView();
  show(app, await wanted(app, view));
  app.started = true;
  await new Promise(drawn => {
    app.on("drawn", drawn);
    app.redraw();
  });
  performance.mark("first-picture");
  $("starting").remove();
  addEventListener("hashchange", () => app.guard(async () => show(app, await wanted(app, view))));
  if (view) app.viewFiles = new ViewFiles(app, view, add(document.querySelector(".bar"), "button", {type: "button", id: "save"}, "Save"));
  takeModels(app, view);
  await app.guard(() => app.texts.start());
  --app.busy;
}

function told(error) {
  const node = $("starting") ?? add($("picture"), "p", {class: "starting"});
  node.setAttribute("role", "alert");
  node.textContent = error?.message || String(error);
}
addEventListener("unhandledrejection", e => {
  e.preventDefault();
  window.crevice?.app.fail(e.reason);
});
start().catch(told);
