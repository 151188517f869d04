// SPDX-License-Identifier: MIT
// The ground truth of a view: ray-traced ambient occlusion, by workers, finer with every pass.

/// Traces views of the engine's scene. One view at a time; a new one takes the place of the one before.
export class Truth {
  constructor(engine) {
    this.engine = engine;
    this.count = Math.max(1, Math.min(4, (navigator.hardwareConcurrency || 2) - 1));  // of workers that trace at once
    this.workers = [];
    this.job = 0;
    this.scene = null;
  }

  /// Calls onProgress({done: 0 to 1, image}) as rows come in; `image` holds size[0] * size[1] visibilities, lowest row
  /// first, NaN where there is no surface or nothing has been traced yet. At done = 1 it is that of
  /// `crevice reference --radius R --rays N`. Nothing is called any more once another has taken its place.
  start({camera, size: [width, height], radius, rays}, onProgress, onError) {
    this.cancel();
    const job = ++this.job;
    this.giveScene();
    const image = new Float32Array(width * height).fill(NaN);
    let finished = 0, passes = 1, traced = 0;
    const listen = ({data}) => {
      if (data.job !== job || job !== this.job) return;
      if (data.error) return onError(new Error(data.error));
      if (data.passes) passes = data.passes;
      if (data.rows) {
        data.rows.forEach((y, k) => image.set(data.values[k], y * width));
        traced += data.rows.length;
      }
      if (data.done) ++finished;
      onProgress({done: finished === this.workers.length ? 1 : Math.min(0.999, traced / (passes * height)), image});
    };
    this.workers.forEach((worker, first) => {
      worker.onmessage = listen;
      worker.onerror = event => onError(new Error(event.message || 'the tracer did not start'));
      worker.postMessage({job, camera, width, height, radius, rays, first, step: this.workers.length});
    });
  }

  cancel() {
    ++this.job;
    for (const worker of this.workers) worker.postMessage({cancel: this.job});
  }

  giveScene() {
    while (this.workers.length < this.count)
      this.workers.push(new Worker(new URL('./trace_worker.js', import.meta.url), {type: 'module'}));
    if (this.scene === this.engine.scene) return;
    this.scene = this.engine.scene;
    const bytes = this.engine.sceneBytes();
    for (const worker of this.workers) worker.postMessage({scene: bytes});
  }
}
