// SPDX-License-Identifier: MIT
// Quality against cost of all configs on this machine: the present view, one radius, one traced picture.
import {SLOT} from "./app.js";
import {GATHER_FRAMES} from "./drawing.js";
import {Truth} from "./engine/truth.js";
import {radiusOf, radiusParam} from "./truth_view.js";

const TIMES = 5;          // the median of so many frames,
const TIMES_MS = 1000;    // or of those that fit in this time
const SLOW_MS = 3000;     // a frame that takes longer is timed by the clock, once
const RAYS = 64;

const pause = () => new Promise(done => setTimeout(done));

/// Calls onStep({done, of, what}) before each step. Returns {samples, failures, without}; null where `cancelled()` was so.
export async function measureAll(app, onStep, cancelled) {
  const {engine} = app, configs = engine.configs().map(c => c.name);
  const of = configs.length + 1, radius = radiusOf(app), size = engine.size.join(" × "), scene = engine.scene.name;
  onStep({done: 0, of, what: "the traced picture"});
  const truth = await traced(app, radius, part => onStep({done: part, of, what: "the traced picture"}), cancelled);
  if (!truth || cancelled()) return null;
  const samples = [], failures = [];
  for (const [i, config] of configs.entries()) {
    onStep({done: i + 1, of, what: config});
    await pause();
    if (cancelled()) break;
    const answer = await measure(app, config, radius, truth);
    if (answer.failure) failures.push({config, failure: answer.failure});
    else samples.push({config, ...answer});
  }
  engine.unload(SLOT.measure);
  app.redraw();
  return cancelled() ? null : {samples, failures, without: errorWithout(truth), radius, size, scene};
}

async function traced(app, radius, onPart, cancelled) {
  const {truth} = app;
  if (truth.on && truth.image && !truth.stale && !truth.tracing) return truth.image;
  const tracer = new Truth(app.engine, {}), size = [...app.engine.size];
  try {
    return await tracer.start({camera: app.camera, size, radius, rays: RAYS}, ({done}) => {
      onPart(done);
      if (cancelled()) tracer.cancel();
    });
  } finally {
    for (const worker of tracer.workers ?? []) worker.terminate();
  }
}

// Of a picture that is white all over.
function errorWithout(truth) {
  let sum = 0, count = 0;
  for (const v of truth)
    if (!Number.isNaN(v)) sum += (1 - v) ** 2, ++count;
  return Math.sqrt(sum / Math.max(1, count));
}

async function measure(app, config, radius, truth) {
  const {engine} = app, failed = answer => ({failure: answer.diagnostics?.find(d => d.severity === "error")?.message ?? "it failed"});
  const loaded = app.ask(() => engine.load(SLOT.measure, {config, outputs: ["color", "ao"], size: engine.size}));
  if (!loaded.ok) return failed(loaded);
  const length = radiusParam(engine.state(SLOT.measure));
  if (length) {
    const turned = app.ask(() => engine.setParam(SLOT.measure, length.name, [Math.min(length.max, Math.max(length.min, radius))]));
    if (!turned.ok) return failed(turned);
  }
  const frame = await gather(app), slow = frame >= SLOW_MS, times = slow ? [frame] : [];
  let by = "wall clock";
  const begin = performance.now();
  for (let i = 0; !slow && i < TIMES && (i === 0 || performance.now() - begin < TIMES_MS); ++i) {
    const timed = await app.ask(() => engine.timed(SLOT.measure));
    if (!timed.ok) return failed(timed);
    times.push(timed.total_ms);
    by = timed.by;
    await pause();
  }
  const compared = app.ask(() => engine.compare(SLOT.measure, truth));
  if (!compared.ok) return failed(compared);
  const {rmse, bias, p99} = compared;
  return {ms: times.sort((a, b) => a - b)[times.length >> 1], by, rmse, bias, p99};
}

// Draws until what is averaged over frames has settled; returns the milliseconds of the last frame. A frame that takes
// too long is the only one.
async function gather(app) {
  const {engine} = app, plan = engine.plan(SLOT.measure);
  const frames = plan.targets.some(t => t.history_texture != null) ? GATHER_FRAMES : 2;
  let took = 0;
  for (let i = 0; i < frames && took < SLOW_MS; ++i) {
    const begin = performance.now();
    app.ask(() => engine.draw({camera: app.camera, path: null, left: {slot: SLOT.measure, show: "ao"}, right: null, split: 1}));
    await engine.finished();
    took = performance.now() - begin;
  }
  return took;
}
