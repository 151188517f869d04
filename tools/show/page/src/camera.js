// SPDX-License-Identifier: MIT
// A camera that goes round a point, and its text as `--camera` reads it. No page here.
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
export function cameraText(camera, old = "") {
  const rest = old.split(";").filter(part => /^\s*(near|far|shift)=/.test(part));
  const up = point(camera.up) === "0,1,0" ? [] : ["up=" + point(camera.up)];
  const lens = camera.ortho_height ? "ortho=" + number(camera.ortho_height) : "fov=" + number(camera.fov_deg);
  return [`eye=${point(camera.eye)}`, `at=${point(camera.at)}`, ...up, lens, ...rest].join(";");
}

/// The engine's up is across the view: that of the world is better to turn about, where the camera does not roll.
export function upright(camera) {
  const side = unit(cross(sub(camera.at, camera.eye), camera.up));
  const axes = [[0, 1, 0], [0, 0, 1], [1, 0, 0]].flatMap(a => [a, a.map(x => x ? -x : 0)]);
  const level = axes.filter(a => Math.abs(dot(a, side)) < LEVEL && dot(a, camera.up) > 0.1);
  return {...camera, up: level.sort((a, b) => dot(b, camera.up) - dot(a, camera.up))[0] ?? camera.up};
}

/// Angles in radians: how far what is seen turns to the right, and the eye goes up.
export function orbit(camera, right, up) {
  const axis = unit(camera.up);
  let away = turned(sub(camera.eye, camera.at), axis, -right);
  const now = Math.acos(Math.min(1, Math.max(-1, dot(unit(away), axis))));
  const side = cross(axis, away);
  const to = Math.min(Math.PI - LEAST_ANGLE, Math.max(LEAST_ANGLE, now - up));
  if (length(side) > 1e-9) away = turned(away, unit(side), to - now);
  return {...camera, eye: plus(camera.at, away)};
}

/// Shares of the picture's height.
export function pan(camera, right, up) {
  const back = sub(camera.eye, camera.at);
  const x = unit(cross(camera.up, back)), y = unit(cross(back, x));
  const high = camera.ortho_height || 2 * length(back) * Math.tan(camera.fov_deg * Math.PI / 360);
  const move = plus(x.map(c => c * right * high), y, up * high);
  return {...camera, eye: plus(camera.eye, move), at: plus(camera.at, move)};
}

/// Below 1 comes nearer.
export function zoom(camera, factor) {
  if (camera.ortho_height) return {...camera, ortho_height: camera.ortho_height * factor};
  return {...camera, eye: plus(camera.at, sub(camera.eye, camera.at), factor)};
}
