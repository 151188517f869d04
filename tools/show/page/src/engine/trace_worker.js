// SPDX-License-Identifier: MIT
// Traces every nth row of a picture, pass after pass; each row that is done goes to the page at once.
//
// In:  {scene: bytes}, {job, camera, width, height, radius, rays, first, step}, {cancel: job}
// Out: {job, passes}, {job, pass, rows: [y...], values: Float32Array}, {job, done: true}, {job, error}
import createModule from './crevice_page.js';

const SLICE_MS = 30;  // between looks at the messages that came

const ready = createModule().then(module => ({
  module,
  setScene: module.cwrap('page_trace_scene', 'string', ['number', 'number']),
  begin: module.cwrap('page_trace_begin', 'string', ['string', 'number', 'number', 'number', 'number']),
  row: module.cwrap('page_trace_row', 'number', ['number', 'number'])
}));
let current = 0;
let queue = Promise.resolve();

onmessage = ({data}) => {
  if (data.cancel || data.job) current = data.job ?? 0;
  if (!data.cancel) queue = queue.then(() => data.scene ? takeScene(data.scene) : trace(data)).catch(
    error => postMessage({job: data.job, error: error.message}));
};

async function takeScene(bytes) {
  const {module, setScene} = await ready;
  const at = module._malloc(bytes.length);
  module.HEAPU8.set(bytes, at);
  const answer = JSON.parse(setScene(at, bytes.length));
  module._free(at);
  if (!answer.ok) throw new Error(answer.diagnostics[0].message);
}

async function trace({job, camera, width, height, radius, rays, first, step}) {
  const {module, begin, row} = await ready;
  if (job !== current) return;
  const answer = JSON.parse(begin(camera, width, height, radius, rays));
  if (!answer.ok) throw new Error(answer.diagnostics[0].message);
  postMessage({job, passes: answer.passes});
  for (let pass = 0; pass < answer.passes; ++pass) {
    let rows = [], values = [], begun = performance.now();
    const send = () => postMessage({job, pass, rows: rows.splice(0), values: values.splice(0)});
    for (let y = first; y < height; y += step) {
      const at = row(pass, y) / 4;
      rows.push(y);
      values.push(module.HEAPF32.slice(at, at + width));
      if (performance.now() - begun < SLICE_MS) continue;
      send();
      await new Promise(next => setTimeout(next));
      if (job !== current) return;
      begun = performance.now();
    }
    send();
    await new Promise(next => setTimeout(next));
    if (job !== current) return;
  }
  postMessage({job, done: true});
}
