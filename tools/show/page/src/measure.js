// SPDX-License-Identifier: MIT
// Time of one config, and quality against cost of all on this machine: the present view, one radius, one traced picture.
import {SLOT, describe} from "./app.js";
import {GATHER_FRAMES, gathers} from "./drawing.js";
import {Truth} from "./engine/truth.js";
import {clamped} from "./scale.js";
import {radiusOf, radiusParam} from "./truth_view.js";

const TIMES = 5;        // the median of so many frames,
const TIMES_MS = 1000;  // or of those that fit in this time
const SLOW_MS = 3000;   // a frame that takes longer is the only one that is gathered
const RAYS = 64;

const pause = () => new Promise(done => setTimeout(done));

/// The answer of the engine's timed() whose total is the median; `ended()` says to stop early.
export async function medianTime(app, slot, ended = () => false) {
  const runs = [], begin = performance.now();
  while (!runs.length || (runs.length < TIMES && performance.now() - begin < TIMES_MS && !ended())) {
    const answer = await app.ask(() => app.engine.timed(slot));
    if (!answer.ok) return answer;
    runs.push(answer);
    await pause();
  }
  return runs.sort((a, b) => a.total_ms - b.total_ms)[runs.length >> 1];
}

/// Calls onStep({done, of, what}) before each step. Returns {samples, failures}; null where `cancelled()` was so.
export async function measureAll(app, onStep, cancelled) {
  const {engine} = app, configs = engine.configs().map(c => c.name);
  const of = configs.length + 1, radius = radiusOf(app), size = engine.size.join(" × "), scene = engine.scene.name;
  const truth = await traced(app, radius, done => onStep({done, of, what: "the traced picture"}), cancelled);
  const samples = [], failures = [];
  for (const [i, config] of configs.entries()) {
    if (!truth || cancelled()) break;
    onStep({done: i + 1, of, what: config});
    await pause();
    const answer = await measure(app, config, radius, truth);
    if (answer.ok) samples.push({config, ...answer});
    else failures.push({config, failure: describe(answer.diagnostics)});
  }
  engine.unload(SLOT.measure);
  app.redraw();
  return !truth || cancelled() ? null : {samples, failures, radius, size, scene};
}

async function traced(app, radius, onPart, cancelled) {
  const {truth} = app;
  if (truth.on && truth.image && !truth.stale && !truth.tracing) return truth.image;
  const tracer = new Truth(app.engine), size = [...app.engine.size];
  try {
    return await tracer.start({camera: app.camera, size, radius, rays: RAYS}, ({done}) => {
      onPart(done);
      if (cancelled()) tracer.cancel();
    });
  } finally {
    for (const worker of tracer.workers) worker.terminate();
  }
}

// {ok, total_ms, by, rmse, bias, p99} of a config, or the answer of what failed.
async function measure(app, config, radius, truth) {
  const {engine} = app, loaded = app.ask(() => engine.load(SLOT.measure, {config}));
  if (!loaded.ok) return loaded;
  const length = radiusParam(engine.state(SLOT.measure));
  if (length) {
    const turned = app.ask(() => engine.setParam(SLOT.measure, length.name, [clamped(length, radius)]));
    if (!turned.ok) return turned;
  }
  await gather(app);
  const timed = await medianTime(app, SLOT.measure);
  return timed.ok ? {...timed, ...app.ask(() => engine.compare(SLOT.measure, truth))} : timed;
}

// Draws until what is averaged over frames has settled.
async function gather(app) {
  const {engine} = app, frames = gathers(engine.plan(SLOT.measure)) ? GATHER_FRAMES : 2;
  for (let i = 0, took = 0; i < frames && took < SLOW_MS; ++i) {
    const begin = performance.now();
    app.ask(() => engine.draw({camera: app.camera, left: {slot: SLOT.measure, show: "ao"}}));
    await engine.finished();
    took = performance.now() - begin;
  }
}
