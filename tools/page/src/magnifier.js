// SPDX-License-Identifier: MIT
// The magnifier: texels about a pixel, enlarged, and the pixel's value in numbers.
import {$, press} from "./dom.js";
import {shown} from "./scale.js";

const TEXELS = 9;    // a side
const CELL_PX = 16;

export class Magnifier {
  constructor(app) {
    Object.assign(this, {app, on: false, at: null, scheduled: false});
    this.node = $("loupe");
    this.paint = this.node.querySelector("canvas").getContext("2d");
    this.words = this.node.querySelector("output");
    $("magnifier").addEventListener("click", () => this.turn(!this.on));
    this.node.addEventListener("keydown", e => this.key(e));
    app.on("drawn", () => this.on && this.later());
    app.on("size", () => this.at = null);
  }

  turn(on) {
    this.on = on;
    press($("magnifier"), on);
    this.node.hidden = !on;
    if (!on) return;
    this.later();
    this.node.focus();
  }
  follow(e) {
    const box = this.app.canvas.getBoundingClientRect(), [w, h] = this.app.engine.size;
    this.moveTo((e.clientX - box.left) / box.width * w, (e.clientY - box.top) / box.height * h);
  }
  moveTo(x, y) {
    const [w, h] = this.app.engine.size;
    this.at = [Math.min(w - 1, Math.max(0, Math.floor(x))), Math.min(h - 1, Math.max(0, Math.floor(y)))];
    this.later();
  }
  key(e) {
    if (e.key === "Escape") return this.turn(false), $("magnifier").focus();
    const move = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1]}[e.key];
    if (!move || !this.at) return;
    e.preventDefault();
    const step = e.shiftKey ? 10 : 1;
    this.moveTo(this.at[0] + step * move[0], this.at[1] + step * move[1]);
  }
  later() {
    if (this.scheduled) return;
    this.scheduled = true;
    requestAnimationFrame(() => {
      this.scheduled = false;
      if (this.on) this.app.guard(() => this.show());
    });
  }

  show() {
    const {app} = this, [w, h] = app.engine.size;
    if (!app.stateA()) return;
    this.at ??= [w >> 1, h >> 1];
    const [x, y] = this.at, {left, right, split} = app.sides();
    const side = right && x >= split * w ? right : left;
    const answer = app.ask(() => app.engine.pixels(side.slot, side.show, x, y, TEXELS));
    if (!answer.values) return this.words.textContent = "no value here";
    this.draw(answer);
    this.words.textContent = this.text(answer, side);
    this.put(x / w, y / h);
  }
  text({channels, format, extent, values, at}, side) {
    const middle = channels * (TEXELS * TEXELS >> 1);
    const numbers = [...values.slice(middle, middle + channels)].map(v => Number.isFinite(v) ? shown(v) : String(v));
    const head = [side.show.replace("target.", ""), format, extent.join("×")].filter(Boolean).join(" ");
    return `${head}\nat ${at.join(", ")}\n${numbers.join("\n")}`;
  }
  // Values of one channel are stretched to their range where they leave 0..1.
  draw({channels, values}) {
    const finite = [...values].filter(Number.isFinite);
    const low = Math.min(0, ...finite), high = Math.max(1, ...finite);
    const grey = v => Math.round(255 * Math.min(1, Math.max(0, (v - low) / (high - low || 1))));
    for (let i = 0; i < TEXELS * TEXELS; ++i) {
      const v = values.slice(i * channels, (i + 1) * channels);
      const [r, g, b] = channels === 1 ? [v[0], v[0], v[0]] : channels === 2 ? [v[0], v[1], 0] : v;
      this.paint.fillStyle = `rgb(${grey(r)} ${grey(g)} ${grey(b)})`;
      this.paint.fillRect(i % TEXELS * CELL_PX, Math.floor(i / TEXELS) * CELL_PX, CELL_PX, CELL_PX);
    }
    const middle = (TEXELS >> 1) * CELL_PX;
    for (const [color, inset] of [["#000", 0], ["#fff", 1]]) {
      this.paint.strokeStyle = color;
      this.paint.strokeRect(middle + inset + 0.5, middle + inset + 0.5, CELL_PX - 2 * inset - 1, CELL_PX - 2 * inset - 1);
    }
  }
  // Beside the pixel, inside of the picture.
  put(u, v) {
    const {clientWidth, clientHeight} = $("picture"), {offsetWidth, offsetHeight} = this.node;
    const x = u * clientWidth, y = v * clientHeight;
    const left = x + 18 + offsetWidth < clientWidth ? x + 18 : x - 18 - offsetWidth;
    const top = y + 18 + offsetHeight < clientHeight ? y + 18 : y - 18 - offsetHeight;
    this.node.style.left = `${Math.max(0, left)}px`;
    this.node.style.top = `${Math.max(0, Math.min(top, clientHeight - offsetHeight))}px`;
  }
}
