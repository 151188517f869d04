// SPDX-License-Identifier: MIT
// Pointers, wheel and keys on the picture move the camera, which goes round a point; its text is as `--camera` reads it.
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

const LEAST_ANGLE = 2 * Math.PI / 180;  // between the view and the up axis

const LEVEL = 0.01;  // cosine between the picture's horizon and an axis across it

const sub = (a, b) => a.map((x, i) => x - b[i]);
const plus = (a, b, k = 1) => a.map((x, i) => x + k * b[i]);
const dot = (a, b) => a.reduce((sum, x, i) => sum + x * b[i], 0);
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const length = a => Math.hypot(...a);
const unit = a => a.map(x => x / (length(a) || 1));
// About a unit axis [Rodrigues].
const turned = (v, axis, angle) => plus(plus(v.map(x => x * Math.cos(angle)), cross(axis, v), Math.sin(angle)),
  axis, dot(axis, v) * (1 - Math.cos(angle)));

const number = x => String(Number(x.toPrecision(5)));
const point = p => p.map(number).join(",");

/// Near, far and shift stay as the old text has them.
function cameraText(camera, old = "") {
  const rest = old.split(";").filter(part => /^\s*(near|far|shift)=/.test(part));
  const up = point(camera.up) === "0,1,0" ? [] : ["up=" + point(camera.up)];
  const lens = camera.ortho_height ? "ortho=" + number(camera.ortho_height) : "fov=" + number(camera.fov_deg);
  return [`eye=${point(camera.eye)}`, `at=${point(camera.at)}`, ...up, lens, ...rest].join(";");
}

/// The engine's up is across the view: that of the world is better to turn about, where the camera does not roll.
function upright(camera) {
  const side = unit(cross(sub(camera.at, camera.eye), camera.up));
  const axes = [[0, 1, 0], [0, 0, 1], [1, 0, 0]].flatMap(a => [a, a.map(x => x ? -x : 0)]);
  const level = axes.filter(a => Math.abs(dot(a, side)) < LEVEL && dot(a, camera.up) > 0.1);
  return {...camera, up: level.sort((a, b) => dot(b, camera.up) - dot(a, camera.up))[0] ?? camera.up};
}

/// Angles in radians: how far what is seen turns to the right, and the eye goes up.
function orbit(camera, right, up) {
  const axis = unit(camera.up);
  let away = turned(sub(camera.eye, camera.at), axis, -right);
  const now = Math.acos(Math.min(1, Math.max(-1, dot(unit(away), axis))));
  const side = cross(axis, away);
  const to = Math.min(Math.PI - LEAST_ANGLE, Math.max(LEAST_ANGLE, now - up));
  if (length(side) > 1e-9) away = turned(away, unit(side), to - now);
  return {...camera, eye: plus(camera.at, away)};
}

/// Shares of the picture's height.
function pan(camera, right, up) {
  const back = sub(camera.eye, camera.at);
  const x = unit(cross(camera.up, back)), y = unit(cross(back, x));
  const high = camera.ortho_height || 2 * length(back) * Math.tan(camera.fov_deg * Math.PI / 360);
  const move = plus(x.map(c => c * right * high), y, up * high);
  return {...camera, eye: plus(camera.eye, move), at: plus(camera.at, move)};
}

/// Below 1 comes nearer.
function zoom(camera, factor) {
  if (camera.ortho_height) return {...camera, ortho_height: camera.ortho_height * factor};
  return {...camera, eye: plus(camera.at, sub(camera.eye, camera.at), factor)};
}
