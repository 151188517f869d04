// SPDX-License-Identifier: MIT
// The line between A and B: dragged, or moved by keys.
import {$} from "./dom.js";

const KEYS = {ArrowLeft: -0.02, ArrowDown: -0.02, ArrowRight: 0.02, ArrowUp: 0.02, PageUp: 0.1, PageDown: -0.1,
  Home: -1, End: 1};

export function makeSplit(app) {
  const line = $("line"), picture = $("picture");
  let dragged = false;
  const drag = e => {
    if (!dragged) return;
    const box = picture.getBoundingClientRect();
    app.setSplit(true, (e.clientX - box.left) / box.width);
  };
  line.addEventListener("pointerdown", e => {
    dragged = true;
    try {
      line.setPointerCapture(e.pointerId);
    } catch {}  // a pointer of a script cannot be captured
    line.focus();
    e.preventDefault();
  });
  line.addEventListener("pointermove", drag);
  for (const end of ["pointerup", "pointercancel"]) line.addEventListener(end, () => dragged = false);
  line.addEventListener("keydown", e => {
    if (!(e.key in KEYS)) return;
    e.preventDefault();
    app.setSplit(true, app.split.at + KEYS[e.key]);
  });
  app.on("sides", () => {
    const {on, at} = app.split;
    line.hidden = !on;
    line.style.left = `${100 * at}%`;
    line.setAttribute("aria-valuenow", String(Math.round(100 * at)));
    line.setAttribute("aria-valuetext", `${Math.round(100 * at)} % A`);
  });
}
