// SPDX-License-Identifier: MIT
// The camera: home, those of the scene, its text and a command line; and the picture's size.
import {makeCommand} from "./command_line.js";
import {$, add, button, copyText, debounce, fillSelect} from "./dom.js";

const SIZES = ["480x270", "640x360", "960x540"];
const LARGEST_FIT = 1920 * 1080;  // pixels

export function makeScenePanel(app) {
  const card = add($("view"), "div", {class: "card camera"});
  add(card, "h2", {}, "Camera");
  const row = add(card, "div", {class: "row"});
  makeCameras(app, row);
  makeText(app, card);
  makeSize(app, row);
}

// Home, and those that the scene has.
function makeCameras(app, row) {
  button(row, "Home", () => app.setCamera(""), {id: "home"});
  const own = add(row, "span", {class: "group"});
  app.on("scene", () => {
    own.replaceChildren();
    for (const name of app.engine.scene?.cameras ?? [])
      button(own, name, () => app.setCamera(name), {title: "A camera of the scene"});
  });
}

function makeSize(app, row) {
  const size = add(add(row, "label", {}, "Size "), "select", {id: "size", onchange: () => app.chooseSize(size.value)});
  const show = () => {
    const values = [...new Set([...SIZES, app.sizeChoice])].filter(value => value !== "fit");
    fillSelect(size, [{value: "fit", text: "fit"}, ...values.map(value => ({value, text: value.replace("x", " × ")}))], app.sizeChoice);
    $("picture").style.setProperty("--aspect", app.engine.size[0] / app.engine.size[1]);
  };
  const fit = () => {
    const {clientWidth, clientHeight} = $("stage"), sharp = Math.min(2, devicePixelRatio || 1);
    const wide = Math.min(clientWidth, clientHeight * 16 / 9 || clientWidth) * sharp;
    const [w, h] = [wide, wide * 9 / 16], shrink = Math.min(1, Math.sqrt(LARGEST_FIT / (w * h || 1)));
    return [w, h].map(x => Math.max(16, Math.round(x * shrink / 2) * 2));
  };
  const said = choice => {
    const size = /^\d{2,4}x\d{2,4}$/.test(choice) ? choice.split("x").map(Number) : null;
    return size && size[0] >= 16 && size[1] >= 16 ? size : null;
  };
  app.chooseSize = choice => {
    app.sizeChoice = said(choice) ? choice : "fit";
    app.setSize(said(choice) ?? fit());
    app.emit("size");
  };
  const fitLater = debounce(200, () => app.sizeChoice === "fit" && app.started && app.setSize(fit()));
  new ResizeObserver(() => fitLater()).observe($("stage"));
  app.on("size", show);
}

function makeText(app, card) {
  const row = add(card, "div", {class: "row"});
  const label = add(row, "label", {class: "grow"}, "--camera ");
  const field = add(label, "input", {type: "text", spellcheck: "false", id: "camera-text", placeholder: "the scene's own", onchange: () => {
    const before = app.camera;
    app.camera = field.value.trim();
    if (app.must(() => app.engine.resolveCamera(app.camera, app.engine.size[0] / app.engine.size[1])).ok) app.setCamera(app.camera);
    else app.camera = before;
  }});
  button(row, "Copy", e => copyText(field.value, e.target), {"aria-label": "Copy the camera"});
  const showCommand = makeCommand(app, card, "Copy the command");
  const show = () => {
    if (document.activeElement !== field) field.value = app.camera;
    showCommand();
  };
  for (const event of ["camera", "loaded", "values", "size", "scene", "sides", "text"]) app.on(event, show);
}
