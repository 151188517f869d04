// SPDX-License-Identifier: MIT
// The camera: bookmarks, turntable, paths, its text and a command line; and the picture's size.
import {makeCommand} from "./command_line.js";
import {$, add, button, copyText, fillSelect, kept, press, toggle} from "./dom.js";

const SIZES = ["480x270", "640x360", "960x540"];
const LARGEST_FIT = 1920 * 1080;  // pixels

export function makeScenePanel(app) {
  const card = add($("view"), "div", {class: "card camera"});
  add(card, "h2", {}, "Camera");
  makeMoves(app, add(card, "div", {class: "row"}));
  makeBookmarks(app, card);
  makeText(app, card);
  makeSize(app);
}

function makeMoves(app, row) {
  button(row, "Home", () => app.setCamera(""), {id: "home"});
  const turntable = toggle(row, "Turntable", on => app.drawing.setTurntable(on), {id: "turntable"});
  const label = add(row, "label", {}, "Path ");
  const path = add(label, "select", {id: "path"});
  fillSelect(path, [{value: "", text: "none"}, ...app.engine.cameraPaths().map(p => ({value: p.name, title: p.what}))], "");
  path.addEventListener("change", () =>
    app.drawing.play(app.engine.cameraPaths().find(p => p.name === path.value) ?? null));
  const size = add(add(row, "label", {}, "Size "), "select", {id: "size"});
  const showSize = () => {
    const values = [...new Set([...SIZES, app.sizeChoice])].filter(value => value !== "fit");
    fillSelect(size, [{value: "fit", text: "fit"}, ...values.map(value => ({value, text: value.replace("x", " × ")}))], app.sizeChoice);
  };
  showSize();
  size.addEventListener("change", () => app.chooseSize(size.value));
  app.on("size", showSize);
  app.on("moving", () => {
    press(turntable, app.drawing.turntable);
    path.value = app.drawing.path?.name ?? "";
  });
}

function makeSize(app) {
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
  app.sizeOf = choice => said(choice) ?? fit();
  app.chooseSize = choice => {
    app.sizeChoice = said(choice) ? choice : "fit";
    app.setSize(app.sizeOf(choice));
    app.emit("size");
  };
  let timer = 0;
  new ResizeObserver(() => {
    if (app.sizeChoice !== "fit" || !app.started) return;
    clearTimeout(timer);
    timer = setTimeout(() => app.sizeChoice === "fit" && app.setSize(fit()), 200);
  }).observe($("stage"));
  app.on("size", () => $("picture").style.setProperty("--aspect", app.engine.size[0] / app.engine.size[1]));
}

function makeBookmarks(app, card) {
  const list = add(card, "ul", {class: "bookmarks", "aria-label": "Camera bookmarks"});
  const form = add(card, "form", {class: "row", onsubmit: e => {
    e.preventDefault();
    const name = field.value.trim() || `view ${app.bookmarks.length + 1}`;
    app.bookmarks = [...app.bookmarks.filter(b => b.name !== name), {name, camera: app.camera}];
    field.value = "";
    keep();
  }});
  const field = add(form, "input", {type: "text", maxlength: 40, placeholder: "name of this view", "aria-label": "Name of a new bookmark", id: "bookmark-name"});
  add(form, "button", {type: "submit", id: "bookmark-add"}, "Add bookmark");
  const keep = () => {
    kept.set("bookmarks." + app.engine.scene.name, app.bookmarks);
    show();
  };
  const go = camera => {
    app.drawing.play(null);
    app.setCamera(camera);
  };
  const show = () => {
    list.replaceChildren();
    for (const name of app.engine.scene?.cameras ?? [])
      button(add(list, "li"), name, () => go(name), {title: "A camera of the scene"});
    app.bookmarks.forEach(bookmark => {
      const item = add(list, "li", {class: "own"});
      button(item, bookmark.name, () => go(bookmark.camera), {title: bookmark.camera || "home"});
      button(item, "×", () => {
        app.bookmarks = app.bookmarks.filter(b => b !== bookmark);
        keep();
      }, {"aria-label": `Delete bookmark ${bookmark.name}`});
    });
  };
  app.on("scene", show);
  app.on("bookmarks", show);
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
