// SPDX-License-Identifier: MIT
// The loop of frames: draws when something changed, or goes on while something moves or gathers.
export const GATHER_FRAMES = 32;  // after a change, where targets of frames before are read
const TURN_DEGREES = 15;   // a second, of the turntable
const PATH_FRAMES = 240;   // of a camera path without a length of its own

export class Drawing {
  constructor(app) {
    this.app = app;
    this.dirty = false;
    this.gather = 0;
    this.scheduled = 0;
    this.turntable = false;
    this.path = null;      // {name, frame, frames}
    this.frames = [];      // milliseconds between the latest frames
    this.last = 0;
    app.on("loaded", () => this.history = undefined);
  }

  wake() {
    this.dirty = true;
    this.gather = this.hasHistory() ? GATHER_FRAMES : 0;
    this.schedule();
  }
  schedule() {
    if (!this.scheduled) this.scheduled = requestAnimationFrame(now => this.frame(now));
  }
  isMoving() {
    return this.turntable || this.path !== null;
  }
  isPending() {
    return this.dirty || (this.gather > 0 && !this.isMoving());
  }
  hasHistory() {
    if (this.history === undefined)
      this.history = !!this.app.guard(() => this.app.stateA() && this.app.engine.plan(0).targets.some(t => t.history_texture != null));
    return this.history;
  }

  frame(now) {
    this.scheduled = 0;
    const {app} = this, moved = this.step(now - this.last);
    this.noteTime(now);
    if (this.dirty || moved || this.gather > 0) this.draw(moved);
    if (this.gather > 0 || this.isMoving()) this.schedule();
    else this.last = 0;
    app.settle();
  }
  draw(moved) {
    const {app} = this, changed = this.dirty;
    this.dirty = false;
    if (!changed && this.gather > 0) --this.gather;
    if (!app.stateA()) return;
    const answer = app.ask(() => app.engine.draw({camera: app.camera, path: this.path, ...app.sides()}));
    if (!answer.ok && !this.failed) app.must(() => answer);
    if (answer.ok && this.failed) app.say(null);
    this.failed = !answer.ok;
    app.emit("drawn", {answer, changed: changed || moved});
  }

  // Moves the camera by the time since the frame before.
  step(milliseconds) {
    if (!this.isMoving()) return false;
    const seconds = this.last ? Math.min(milliseconds, 200) / 1000 : 0;
    if (this.path) this.path = {...this.path, frame: (this.path.frame + 1) % this.path.frames};
    else this.app.emit("turn", TURN_DEGREES * seconds);
    return true;
  }
  noteTime(now) {
    if (this.last) this.frames = [...this.frames.slice(-29), now - this.last];
    this.last = now;
  }
  /// The median of milliseconds between the latest frames, or null.
  frameTime() {
    const sorted = [...this.frames].sort((a, b) => a - b);
    return sorted.length > 3 ? sorted[sorted.length >> 1] : null;
  }

  setTurntable(on) {
    this.turntable = on;
    this.app.emit("moving");
    this.schedule();
  }
  play(path) {
    this.path = path ? {name: path.name, frame: 0, frames: path.frames ?? PATH_FRAMES} : null;
    this.app.emit("moving");
    this.wake();
  }
}
