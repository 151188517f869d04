// SPDX-License-Identifier: MIT
// Pointers, wheel and keys on the picture move the camera.
import {cameraText, orbit, pan, upright, zoom} from "./camera.js";

const TURN = Math.PI;        // radians for a drag over the picture's height
const KEY_TURN = 5 * Math.PI / 180;
const KEY_PAN = 0.05;        // of the picture's height
const KEY_ZOOM = 1.1;
const WHEEL_ZOOM = 0.0012;   // exponent for a pixel of the wheel

export class PictureInput {
  constructor(app, canvas) {
    Object.assign(this, {app, canvas, pointers: new Map()});
    canvas.addEventListener("pointerdown", e => this.down(e));
    canvas.addEventListener("pointermove", e => this.move(e));
    for (const end of ["pointerup", "pointercancel"]) canvas.addEventListener(end, e => this.up(e));
    canvas.addEventListener("wheel", e => this.wheel(e), {passive: false});
    canvas.addEventListener("contextmenu", e => e.preventDefault());
    canvas.addEventListener("keydown", e => this.key(e));
  }

  // The engine is asked only for cameras that are not made here: it finds the point to go round by drawing depth.
  change(move) {
    const {app} = this, now = this.made?.text === app.camera ? this.made.camera : app.resolved();
    if (!now) return;
    const camera = move(upright(now)), text = cameraText(camera, app.camera);
    this.made = {text, camera};
    app.setCamera(text);
  }

  down(e) {
    this.canvas.focus({preventScroll: true});
    try {
      this.canvas.setPointerCapture(e.pointerId);
    } catch {}  // a pointer of a script cannot be captured
    this.pointers.set(e.pointerId, {x: e.clientX, y: e.clientY});
    e.preventDefault();
  }
  move(e) {
    const old = this.pointers.get(e.pointerId);
    if (!old) return;
    const others = [...this.pointers].filter(([id]) => id !== e.pointerId).map(([, p]) => p);
    const now = {x: e.clientX, y: e.clientY};
    this.pointers.set(e.pointerId, now);
    const high = this.canvas.clientHeight || 1, dx = (now.x - old.x) / high, dy = (now.y - old.y) / high;
    if (others.length === 1) return this.pinch(others[0], old, now, dx, dy);
    const pans = e.buttons & 2 || e.buttons & 4 || e.shiftKey;
    this.change(c => pans ? pan(c, -dx, dy) : orbit(c, dx * TURN, dy * TURN));
  }
  // Two fingers: their middle pans, their distance zooms.
  pinch(other, old, now, dx, dy) {
    const apart = p => Math.max(10, Math.hypot(p.x - other.x, p.y - other.y));
    this.change(c => zoom(pan(c, -dx / 2, dy / 2), apart(old) / apart(now)));
  }
  up(e) {
    this.pointers.delete(e.pointerId);
  }
  wheel(e) {
    e.preventDefault();
    const pixels = e.deltaY * (e.deltaMode === 1 ? 16 : e.deltaMode === 2 ? 400 : 1);
    this.change(c => zoom(c, Math.exp(WHEEL_ZOOM * Math.max(-400, Math.min(400, pixels)))));
  }

  key(e) {
    if (e.ctrlKey || e.metaKey || e.altKey) return;
    const arrows = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1]}[e.key];
    if (arrows && e.shiftKey) this.change(c => pan(c, KEY_PAN * arrows[0], KEY_PAN * arrows[1]));
    else if (arrows) this.change(c => orbit(c, -KEY_TURN * arrows[0], KEY_TURN * arrows[1]));
    else if (e.key === "+" || e.key === "=") this.change(c => zoom(c, 1 / KEY_ZOOM));
    else if (e.key === "-") this.change(c => zoom(c, KEY_ZOOM));
    else if (e.key === "0" || e.key === "Home") this.app.setCamera("");
    else return;
    e.preventDefault();
  }
}
