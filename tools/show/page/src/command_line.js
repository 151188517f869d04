// SPDX-License-Identifier: MIT
// The crevice command that draws what the page shows.
import {drawnName} from "./app.js";
import {add, button, copyText} from "./dom.js";
import {GATHER_FRAMES} from "./drawing.js";

/// Adds the command to `parent`, with a button that copies it. Returns what shows it anew; `patch`, where it is given, is the
/// name of a file that holds the patch.
export function makeCommand(app, parent, label) {
  const row = add(parent, "div", {class: "row"}), code = add(row, "code", {class: "grow command"});
  button(row, "Copy", e => copyText(code.textContent.trim(), e.target), {"aria-label": label});
  return (patch = null) => {
    code.replaceChildren();
    for (const word of commandLine(app, patch).split(" ")) {
      add(code, "span", {}, word);  // so that no line ends within an option
      code.append(" ");
    }
  };
}

const quoted = word => /^[\w.,\/=:+-]+$/.test(word) ? word : `'${word.replaceAll("'", "'\\''")}'`;

function commandLine(app, patch) {
  const state = app.stateA();
  if (!state) return "";
  const camera = app.camera ? ["--camera", quoted(app.camera)] : [];
  const frames = app.drawing.hasHistory() ? [`--frames ${GATHER_FRAMES}`] : [];
  const {show} = app.a, output = drawnName(show), file = output.replace("target.", "");
  return ["crevice render", ...patch ? [patch] : configOf(app, state), ...show === "without" ? withoutAo(state) : [], "--scene",
    quoted(app.engine.scene?.name ?? "room"), ...camera, "--size", app.engine.size.join("x"), ...frames,
    `--out ${quoted(`${output}=${file}.png`)}`, ...!patch && isUnsaved(app) ? ["# after a save"] : []].join(" ");
}

// With params and features that differ from the shipped ones as --set.
function configOf(app, state) {
  const isOwn = app.engine.shippedSource(app.path()) === null;
  const params = state.params.filter(p => p.shipped && String(p.shipped) !== String(p.value))
    .map(p => setting(p.name, p.value.map(v => Number(v.toPrecision(6))).join(",")));
  const features = state.features.filter(f => f.shipped !== null && f.shipped !== f.value).map(f => setting(f.name, f.value));
  return [state.config + (isOwn ? ".json" : ""), ...app.a.variant ? ["--variant", app.a.variant] : [], ...params, ...features];
}
const setting = (name, value) => `--set ${quoted(`${name}=${value}`)}`;
const withoutAo = state => state.features.filter(f => f.values.includes("no_ao")).map(f => setting(f.name, "no_ao"));

// A config of the user's own is read from its file.
function isUnsaved(app) {
  const path = app.path();
  return app.engine.shippedSource(path) === null && app.firstText(path) !== app.engine.source(path);
}
