// SPDX-License-Identifier: MIT
// The loop of frames: draws when something changed, and goes on while targets of frames before gather.
export const GATHER_FRAMES = 32;  // after a change, where targets of frames before are read

export class Drawing {
  constructor(app) {
    this.app = app;
    this.dirty = false;
    this.gather = 0;
    this.scheduled = false;
    app.on("loaded", () => this.history = undefined);
  }

  wake() {
    this.dirty = true;
    this.gather = this.hasHistory() ? GATHER_FRAMES : 0;
    this.schedule();
  }
  schedule() {
    if (!this.scheduled) requestAnimationFrame(() => this.frame());
    this.scheduled = true;
  }
  isPending() {
    return this.dirty || this.gather > 0;
  }
  hasHistory() {
    this.history ??= !!this.app.guard(() => this.app.stateA() && gathers(this.app.engine.plan(0)));
    return this.history;
  }

  frame() {
    this.scheduled = false;
    if (this.isPending()) this.draw();
    if (this.gather > 0) this.schedule();
  }
  draw() {
    const {app} = this;
    if (!this.dirty) --this.gather;
    this.dirty = false;
    if (!app.stateA()) return;
    const answer = app.ask(() => app.engine.draw({camera: app.camera, ...app.sides()}));
    if (!answer.ok && !this.failed) app.must(() => answer);
    if (answer.ok && this.failed) app.say(null);
    this.failed = !answer.ok;
    app.emit("drawn");
  }
}

/// Whether a plan reads what frames before wrote.
export const gathers = plan => plan.targets.some(target => target.history_texture != null);
