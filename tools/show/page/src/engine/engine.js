// SPDX-License-Identifier: MIT
// The library as the page sees it: crevice compiled to WebAssembly, on a canvas.
//
// An Answer is {ok, diagnostics: [{code, severity, message, file, line, column, length, pointer, notes, help}]}; lines
// and columns count from 1, columns in bytes; `file` is the path of a source, such as "configs/mobile.json".
import displayConfig from './display.json';
import displayShader from './display.frag';
import createModule from './crevice_page.js';

const CHOOSER = 4;       // the slot after all others: what is to be timed to choose by
const TIMED_FRAMES = 60;  // within which a browser has the time of one on the GPU,
const TIMED_MS = 3000;    // or within this time

/// Compiles the library and opens it on a canvas, whose size it takes. Throws an Error with a sentence for the user.
export async function openEngine(canvas) {
  const module = await createModule();
  const engine = new Engine(module, canvas);
  engine.open();
  return engine;
}

/// The GPU's name: WebGL's own answer says as little as it can.
function rendererOf(canvas) {
  const gl = canvas.getContext('webgl2'), names = gl.getExtension('WEBGL_debug_renderer_info');
  return gl.getParameter(names ? names.UNMASKED_RENDERER_WEBGL : gl.RENDERER);
}

class Engine {
  constructor(module, canvas) {
    this.module = module;
    this.canvas = canvas;
    this.read = {};  // pictures read back since the last draw, by slot and name
    const s = 'string', n = 'number', bare = (name, gives, ...types) => module.cwrap('page_' + name, gives, types);
    const json = (...call) => {
      const text = bare(call[0], s, ...call.slice(1));
      return (...values) => JSON.parse(text(...values));
    };
    Object.assign(this, {
      setSource: bare('set_source', null, s, s),  // a text of null: the shipped one again
      editedPaths: json('edited_paths'),
      configs: json('configs'),  // [{name, description}]
      schema: json('schema'),
      builtinScenes: json('builtin_scenes'),
      resolveCamera: json('resolve_camera', s, n),  // (text, aspect)
      state: json('state', n),  // (slot), as the next three
      plan: json('plan', n),
      planText: bare('plan_text', s, n),
      patch: json('patch', n),
      foundText: json('found', s)  // ({config, overrides} as JSON): {text}, a config that says them
    });
    this.calls = {
      open: json('open', s, s, s, n, n),
      source: json('source', s, n),
      showBuiltinScene: json('show_builtin_scene', s),
      showSceneBytes: json('show_scene_bytes', n, n, s),
      scene: json('scene'),
      sceneBytes: bare('scene_bytes', n),
      bytes: bare('bytes', n),
      load: json('load', n, s),
      setParam: json('set_param', n, s, s),
      setFeature: json('set_feature', n, s, s),
      resize: json('resize', n, n),
      draw: json('draw', s),
      timed: json('timed', n),
      startTiming: json('start_timing', n, n),
      again: json('again', n),
      times: json('times', n),
      read: json('read', n, s),
      pixels: bare('pixels', n),
      compare: json('compare', n, n, n),
      choose: json('choose', s),
      chooseStep: json('choose_step'),
      chooseTimed: json('choose_timed')
    };
  }

  open() {
    const {width, height} = this.canvas;
    const answer = this.calls.open('#' + this.canvas.id, JSON.stringify(displayConfig), displayShader, width, height);
    if (!answer.ok) throw new Error(answer.diagnostics.map(d => [d.message, d.help].join('; ')).join('\n'));
    this.machine = {timer: answer.timer, renderer: rendererOf(this.canvas)};
    this.size = [width, height];
  }

  // ---- Texts

  source(path) { return this.calls.source(path, 0); }
  shippedSource(path) { return this.calls.source(path, 1); }

  // ---- Scene

  loadBuiltinScene(name) { return this.shown(this.calls.showBuiltinScene(name)); }

  loadSceneBytes(bytes, name) {
    return this.withBytes(bytes, (at, size) => this.shown(this.calls.showSceneBytes(at, size, name)));
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

  // ---- Slots

  /// {config, variant, outputs, look, without_occlusion}, of which all but the first may lack.
  load(slot, request) {
    this.read = {};
    return this.changed(this.calls.load(slot, JSON.stringify(request)));
  }

  setParam(slot, name, values) { return this.changed(this.calls.setParam(slot, name, JSON.stringify(values))); }
  setFeature(slot, name, word) { return this.changed(this.calls.setFeature(slot, name, String(word))); }

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

  /// Measures which config to take as `crevice choose` does, for {camera, radius, budget: "2ms", error: 0.05}. Until that is done
  /// or `stopped()`, it calls onChange({lines, found}) with what was said and, where that is new, all that was measured by rising
  /// cost: [{label, config, overrides, ms, ratio, rmse, margin, front, within, best}].
  async choose(wanted, onChange, stopped) {
    let answer = this.calls.choose(JSON.stringify(wanted));
    for (let more = answer.ok; more && !stopped(); more = answer.ok && answer.more) {
      const timed = answer.due ? await this.timed(CHOOSER) : {ok: true};
      if (!timed.ok) return timed;
      answer = answer.due ? this.calls.chooseTimed() : this.calls.chooseStep();
      if (answer.found || answer.lines?.length) onChange(answer);
      await new Promise(next => setTimeout(next));
    }
    return answer;
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

  /// Figures of the difference from the truth, and `picture`, which is that as ImageData.
  compare(slot, truth) {
    const [width, height] = this.size, size = width * height * 4;
    return this.withFloats(truth, at => {
      const heat = this.module._malloc(size);
      const answer = this.calls.compare(slot, at, heat);
      const pixels = new Uint8ClampedArray(this.module.HEAPU8.slice(heat, heat + size));
      this.module._free(heat);
      return {...answer, picture: new ImageData(pixels, width, height)};
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
