// SPDX-License-Identifier: MIT
// The library as the page sees it: crevice compiled to WebAssembly, on a canvas.
//
// An Answer is {ok, diagnostics: [{code, severity, message, file, line, column, length, pointer, notes, help}]}; lines
// and columns count from 1, columns in bytes; `file` is the path of a source, such as "configs/mobile.json".
import displayConfig from './display.json';
import displayShader from './display.frag';
import {loadModule} from './engine_module.js';

const TIMED_FRAMES = 60;  // within which a browser has the time of one on the GPU,
const TIMED_MS = 3000;    // or within this time

/// Compiles the library and opens it on a canvas, whose size it takes. Throws an Error with a sentence for the user.
export async function openEngine(canvas) {
  const module = await loadModule();
  const engine = new Engine(module, canvas);
  engine.open();
  return engine;
}

/// What the browser tells of the GPU: WebGL's own answers say as little as they can.
function machineOf(canvas) {
  const gl = canvas.getContext('webgl2'), names = gl.getExtension('WEBGL_debug_renderer_info');
  const renderer = gl.getParameter(names ? names.UNMASKED_RENDERER_WEBGL : gl.RENDERER);
  return {renderer, software: /swiftshader|llvmpipe|software/i.test(renderer)};
}

class Engine {
  constructor(module, canvas) {
    this.module = module;
    this.canvas = canvas;
    this.read = {};  // pictures read back since the last draw, by slot and name
    const text = (name, types) => module.cwrap(name, 'string', types);
    const json = (name, types) => {
      const call = text(name, types);
      return (...values) => JSON.parse(call(...values));
    };
    const s = 'string', n = 'number';
    this.calls = {
      open: json('page_open', [s, s, s, n, n]),
      sourcePaths: json('page_source_paths', []),
      source: json('page_source', [s, n]),
      setSource: module.cwrap('page_set_source', null, [s, s]),
      editedPaths: json('page_edited_paths', []),
      configs: json('page_configs', []),
      schema: json('page_schema', []),
      builtinScenes: json('page_builtin_scenes', []),
      showBuiltinScene: json('page_show_builtin_scene', [s]),
      showSceneBytes: json('page_show_scene_bytes', [n, n, s]),
      scene: json('page_scene', []),
      sceneBytes: module.cwrap('page_scene_bytes', n, []),
      bytes: module.cwrap('page_bytes', n, []),
      resolveCamera: json('page_resolve_camera', [s, n]),
      cameraPaths: json('page_camera_paths', []),
      load: json('page_load', [n, s]),
      unload: module.cwrap('page_unload', null, [n]),
      state: json('page_state', [n]),
      plan: json('page_plan', [n]),
      setParam: json('page_set_param', [n, s, s]),
      setFeature: json('page_set_feature', [n, s, s]),
      patch: json('page_patch', [n]),
      resize: json('page_resize', [n, n]),
      draw: json('page_draw', [s]),
      timed: json('page_timed', [n]),
      startTiming: json('page_start_timing', [n, n]),
      again: json('page_again', [n]),
      times: json('page_times', [n]),
      read: json('page_read', [n, s]),
      pixels: module.cwrap('page_pixels', n, []),
      compare: json('page_compare', [n, n, n]),
    };
  }

  open() {
    if (!this.canvas.id) this.canvas.id = 'crevice-canvas';
    const {width, height} = this.canvas;
    const answer =
      this.calls.open('#' + this.canvas.id, JSON.stringify(displayConfig), displayShader, width, height);
    if (!answer.ok) throw new Error(answer.diagnostics.map(d => [d.message, d.help].join('; ')).join('\n'));
    this.machine = {...answer.machine, ...machineOf(this.canvas)};
    this.size = [width, height];
  }

  // ---- Texts

  sourcePaths() { return this.calls.sourcePaths(); }
  source(path) { return this.calls.source(path, 0); }
  shippedSource(path) { return this.calls.source(path, 1); }
  setSource(path, text) { this.calls.setSource(path, text); }
  editedPaths() { return this.calls.editedPaths(); }
  configs() { return this.calls.configs(); }
  schema() { return this.calls.schema(); }

  // ---- Scene

  builtinScenes() { return this.calls.builtinScenes(); }
  loadBuiltinScene(name) { return this.shown(this.calls.showBuiltinScene(name)); }

  loadSceneBytes(bytes, name) {
    return this.withBytes(bytes, (at, size) => this.shown(this.calls.showSceneBytes(at, size, name)));
  }

  async loadGltf(bytes, name) {
    const {loadGltf} = await import('./gltf.js');  // half of the page's scripts
    return this.shown(await loadGltf(this, bytes, name));
  }

  shown(answer) {
    if (answer.ok) this.scene = this.calls.scene();
    return answer;
  }

  /// A copy of the scene as loadSceneBytes reads it.
  sceneBytes() {
    const size = this.calls.sceneBytes(), at = this.calls.bytes();
    return this.module.HEAPU8.slice(at, at + size);
  }

  resolveCamera(text, aspect = this.size[0] / this.size[1]) { return this.calls.resolveCamera(text, aspect); }
  cameraPaths() { return this.calls.cameraPaths(); }

  // ---- Slots

  load(slot, {config, variant = '', outputs = ['color', 'ao'], look = '', without_occlusion = false}) {
    this.read = {};
    return this.changed(
      this.calls.load(slot, JSON.stringify({config, variant, outputs, look: look || '', without_occlusion})));
  }

  unload(slot) { this.calls.unload(slot); }
  state(slot) { return this.calls.state(slot); }
  plan(slot) { return this.calls.plan(slot); }
  setParam(slot, name, values) { return this.changed(this.calls.setParam(slot, name, JSON.stringify(values))); }
  setFeature(slot, name, word) { return this.changed(this.calls.setFeature(slot, name, String(word))); }
  patch(slot) { return this.calls.patch(slot); }

  /// Adds `compiled`: the sentences that say what was compiled.
  changed(answer) {
    answer.compiled = answer.diagnostics.filter(d => d.code === 'CV5010').map(d => d.message);
    return answer;
  }

  // ---- Drawing

  setSize(width, height) {
    this.canvas.width = width;
    this.canvas.height = height;
    this.size = [width, height];
    this.read = {};
    return this.calls.resize(width, height);
  }

  draw(view) {
    this.read = {};
    return this.calls.draw(JSON.stringify(view));
  }

  /// What the passes of a slot take for the view drawn last, all of them drawn anew.
  async timed(slot) {
    if (!this.machine.timer) return this.calls.timed(slot);
    const started = this.calls.startTiming(slot, 1);
    if (!started.ok || started.diagnostics.length) return this.calls.timed(slot);
    const begin = performance.now(), late = () => performance.now() - begin > TIMED_MS;
    let times = null;
    for (let frame = 0; frame < TIMED_FRAMES && !late() && !(times && times.total_ms >= 0); ++frame) {
      const drawn = this.calls.again(slot);
      if (!drawn.ok) return drawn;
      await this.finished();
      times = this.calls.times(slot);
    }
    this.calls.startTiming(slot, 0);
    return times ? {ok: true, diagnostics: [], ...times} : this.calls.timed(slot);
  }

  // Until the GPU has drawn all that it was given: else slow machines would be given frame after frame meanwhile.
  async finished() {
    const gl = this.canvas.getContext('webgl2'), fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    gl.flush();
    do {
      await new Promise(done => setTimeout(done, 4));
    } while (gl.clientWaitSync(fence, 0, 0) === gl.TIMEOUT_EXPIRED);
    gl.deleteSync(fence);
  }

  startTiming(slot, on) { return this.calls.startTiming(slot, on ? 1 : 0); }
  frameMs(slot) { return this.calls.times(slot)?.total_ms ?? null; }

  /// The n x n texels around a pixel of the canvas, counted from its top left: row by row from the top, channels
  /// together. Outside of the picture they are null.
  pixels(slot, show, x, y, n) {
    const {answer, values} = this.readBack(slot, show);
    if (!answer.ok) return answer;
    const [width, height] = answer.extent, channels = answer.channels;
    const tx = Math.floor((x + 0.5) / this.size[0] * width);
    const ty = height - 1 - Math.floor((y + 0.5) / this.size[1] * height);
    const list = [];
    for (let row = 0; row < n; ++row)
      for (let column = 0; column < n; ++column) {
        const px = tx + column - (n >> 1), py = ty + (n >> 1) - row;
        const inside = px >= 0 && py >= 0 && px < width && py < height;
        for (let k = 0; k < channels; ++k) list.push(inside ? values[(py * width + px) * channels + k] : null);
      }
    return {...answer, values: list, at: [tx, ty]};
  }

  /// A picture in full: {answer, values}, lowest row first.
  readBack(slot, show) {
    const key = slot + show;
    if (!this.read[key]) {
      const answer = this.calls.read(slot, show);
      const at = this.calls.pixels() / 4;
      const size = answer.ok ? answer.extent[0] * answer.extent[1] * answer.channels : 0;
      this.read[key] = {answer, values: this.module.HEAPF32.slice(at, at + size)};
    }
    return this.read[key];
  }

  // ---- Against the truth

  compare(slot, truth) { return this.withFloats(truth, at => this.calls.compare(slot, at, 0)); }

  /// The difference from the truth as ImageData; null where there is none.
  heat(slot, truth) {
    const [width, height] = this.size, size = width * height * 4;
    return this.withFloats(truth, at => {
      const heat = this.module._malloc(size);
      const answer = this.calls.compare(slot, at, heat);
      const pixels = new Uint8ClampedArray(this.module.HEAPU8.slice(heat, heat + size));
      this.module._free(heat);
      return answer.ok ? new ImageData(pixels, width, height) : null;
    });
  }

  withFloats(floats, use) {
    return this.withBytes(new Uint8Array(floats.buffer, floats.byteOffset, floats.byteLength), use);
  }

  /// Copies bytes to where the library sees them, for one call.
  withBytes(bytes, use) {
    const at = this.module._malloc(Math.max(bytes.length, 1));
    try {
      this.module.HEAPU8.set(bytes, at);
      return use(at, bytes.length);
    } finally {
      this.module._free(at);
    }
  }
}
