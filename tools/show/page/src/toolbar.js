// SPDX-License-Identifier: MIT
// The choices above the picture: scene, configs and views.
import {SLOT} from "./app.js";
import {$, copyText, fillSelect, press} from "./dom.js";
import {shareLink} from "./link.js";
import {round} from "./scale.js";

const NAMES = {color: "Lit", ao: "AO", without: "Without AO", doubt: "Doubt"};
const nameOf = show => NAMES[show] ?? show.replace(/^(target|view):/, "");
const OWN_MODEL = "\u0000own";

export function makeToolbar(app) {
  makeScene(app);
  makeSides(app);
  $("split").addEventListener("click", () => app.setSplit(!app.split.on));
  $("share").addEventListener("click", e => app.during(() => share(app, e.target)));
}

export async function share(app, pressed) {
  const link = await shareLink(app);
  history.replaceState(null, "", link);
  await copyText(location.href, pressed);
  if (app.viewFiles) app.say("The link is copied. It opens on this machine, as long as crevice view runs.", "note");
  else if (location.href.length > 32000) app.say("This link is long: some programs cut it off.", "warning");
  else if (!app.builtin) app.say("The link is copied. It holds all but the model: who opens it sees a built-in scene.", "note");
}

function makeScene(app) {
  const select = $("scene");
  const show = () => {
    const names = app.engine.builtinScenes().map(value => ({value}));
    const own = app.builtin || !app.engine.scene ? [] : [{value: OWN_MODEL, text: endOf(app.engine.scene.name), title: app.engine.scene.name}];
    fillSelect(select, [...own, ...names], app.builtin ?? OWN_MODEL);
  };
  select.addEventListener("change", () => {
    if (select.value !== OWN_MODEL) app.chooseScene(select.value);
    show();
  });
  app.on("scene", show);
}

// A file's name without its folders; of a long one its end.
const endOf = path => path.split("/").pop().replace(/^.+(?=.{25}$)/, "…");

// CONFIGS is that of the documentation's tables, see build.mjs: [{name, words, group}].
function optionsOf(configs) {
  const place = c => CONFIGS.findIndex(each => each.name === c.name);
  return [...configs].sort((a, b) => place(a) - place(b)).map(c => {
    const {words, group} = CONFIGS[place(c)] ?? {group: "Yours"};
    return {value: c.name, text: c.name + (words ? ` – ${words}` : ""), title: c.description, group};
  });
}

function makeSides(app) {
  const [configA, configB, showA, showB] = ["config-a", "config-b", "show-a", "show-b"].map($);
  configA.addEventListener("change", () => app.chooseConfig(configA.value));
  configB.addEventListener("change", () => app.chooseB(configB.value));
  showA.addEventListener("change", () => app.setShow("a", showA.value));
  showB.addEventListener("change", () => app.setShow("b", showB.value));
  const showConfigs = () => {
    const known = app.engine.configs(), isKnown = !app.a.config || known.some(c => c.name === app.a.config);
    const list = optionsOf(isKnown ? known : [{name: app.a.config}, ...known]);
    fillSelect(configA, list, app.a.config);
    fillSelect(configB, [{value: "", text: "same as A"}, ...list], app.b.config);
  };
  const showViews = () => {
    const own = app.engine.state(SLOT.b), {on} = app.split;
    fillSelect(showA, viewsOf(app, app.stateA()), app.a.show);
    fillSelect(showB, viewsOf(app, app.b.config && own ? own : app.stateA()), app.b.show);
    press($("split"), on);
    $("bar-b").hidden = $("name-b").hidden = !on;
    showNames();
  };
  const showNames = () => {
    $("name-a").textContent = (app.split.on ? "A: " : "") + nameOfSide(app, app.a, SLOT.a);
    $("name-b").textContent = "B: " + nameOfSide(app, app.b, SLOT.b);
  };
  app.on("times", showNames);
  for (const event of ["config", "sides"]) app.on(event, showConfigs);
  for (const event of ["loaded", "loadedB", "sides", "values"]) app.on(event, showViews);
}

function viewsOf(app, state) {
  const texts = Object.fromEntries((state?.targets ?? []).map(t => ["target:" + t.name, `${t.name} (${t.format})`]));
  const group = value => value.startsWith("target:") ? "Targets" : value.startsWith("view:") ? "Views" : null;
  return app.choices(state).map(value => ({value, text: texts[value] ?? nameOf(value), group: group(value)}));
}

// Without a config B is another picture of A's, which costs nothing of its own.
function nameOfSide(app, side, slot) {
  const {config, variant} = app.effective(side), cost = side.config ? app.timing.said(slot, config) + " · " : "";
  const rmse = app.expected(side, slot), expected = rmse === null ? "" : `, rmse about ${round(rmse, 2)}`;
  return `${cost}${config}${variant ? ":" + variant : ""} · ${nameOf(side.show)}${expected}`;
}
