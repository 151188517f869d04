// SPDX-License-Identifier: MIT
// The page in headless Chromium, used as people use it.
import assert from 'node:assert/strict';
import {writeFileSync} from 'node:fs';
import {join} from 'node:path';
import {after, before, test} from 'node:test';
import {Document, NodeIO} from '@gltf-transform/core';
import {crevice, differing, open, quiet, readPfm, rest, start, stop, work} from './browser.mjs';

before(start);
after(stop);

// Planes of its own, so that depth is fine; no silhouette but the picture's, since two rasterisers differ there.
const VIEW = {scene: 'corner', camera: 'eye=0.8,1.4,2.8;at=0,0.45,0;near=1;far=12'};
const SIZE = [480, 270];
const [FIRST_PICTURE_MS, LEAST_FPS, ACTIONS] = [3000, 10, 200];

const configs = page => page.evaluate(() => crevice.engine.configs().map(each => each.name));
const look = (page, view, size) => page.evaluate(async (seen, [width, height]) => {
  crevice.app.chooseScene(seen.scene);
  crevice.app.chooseSize(`${width}x${height}`);
  crevice.app.setCamera(seen.camera);
  await crevice.app.whenIdle();
}, view, size);

// What a config draws in a slot of its own, and whether the picture has what is no number.
const drawn = (page, config, camera) => page.evaluate((name, at) => {
  const {engine} = crevice, slot = 3;
  const loaded = engine.load(slot, {config: name, outputs: ['ao']});
  if (!loaded.ok) return {failed: loaded.diagnostics[0].message};
  const frames = engine.plan(slot).targets.some(each => each.history_texture !== null) ? 32 : 1;
  for (let i = 0; i < frames; ++i) {
    const answer = engine.draw({camera: at, left: {slot, show: 'ao'}});
    if (!answer.ok) return {failed: answer.diagnostics[0].message};
  }
  const {answer, values} = engine.readBack(slot, 'ao');
  return {values: [...values].filter((_, i) => i % answer.channels === 0)};
}, config, camera);

test('The page opens without a word in its console, and soon', async () => {
  const page = await open();
  const ms = await page.evaluate(() => performance.getEntriesByName('first-picture')[0].startTime);
  console.log(`first picture after ${Math.round(ms)} ms`);
  assert(ms < FIRST_PICTURE_MS, `${ms} ms`);
  quiet(page);
  await page.close();
});

test('Every config draws what it draws elsewhere', async () => {
  const page = await open();
  await look(page, VIEW, SIZE);
  const off = [];
  for (const name of await configs(page)) {
    const {values, failed} = await drawn(page, name, VIEW.camera);
    assert.equal(failed, undefined, `${name}: ${failed}`);
    const file = join(work, 'native.pfm');
    await crevice('render', name, '--scene', VIEW.scene, '--camera', VIEW.camera, '--size', SIZE.join('x'), '--out', `ao=${file}`,
      ...(/temporal/.test(name) ? ['--frames', '32'] : []));
    const share = differing(values, readPfm(file));
    console.log(`${name}: ${share.toFixed(2)} % of pixels differ by more than 2/255`);
    if (!(share <= 1)) off.push(name);
  }
  assert.deepEqual(off, []);
  quiet(page);
  await page.close();
});

test('Every knob of every config moves through its range', async () => {
  const page = await open();
  await look(page, VIEW, [96, 54]);
  for (const name of await configs(page)) {
    const faults = await page.evaluate(async config => {
      const {app, engine} = crevice, found = [];
      app.chooseConfig(config);
      const check = what => {
        const answer = engine.draw({camera: app.camera, left: {slot: 0, show: 'ao'}});
        const bad = !answer.ok || engine.readBack(0, 'ao').values.some(value => !Number.isFinite(value));
        if (bad) found.push(what + ': ' + (answer.diagnostics[0]?.message ?? 'not a number'));
      };
      for (const param of engine.state(0).params) {
        app.knobs.begin();
        for (const end of [param.min, param.soft_max || param.max]) {
          const values = param.value.map(() => Math.min(Math.max(end, -1e6), 1e6));
          const answer = app.knobs.turn('param', param.name, values);
          if (!answer.ok) found.push(`${param.name}: ${answer.diagnostics[0].message}`);
          check(`${param.name} ${end}`);
        }
        app.knobs.reset('param', param.name);
      }
      for (const feature of engine.state(0).features)
        for (const word of [...feature.values, feature.value]) {
          if (!app.knobs.turn('feature', feature.name, word).ok) found.push(`${feature.name} ${word}`);
          if (!engine.plan(0).imports.some(each => each.type === 'texture')) check(`${feature.name} ${word}`);
        }
      return found;
    }, name);
    assert.deepEqual(faults, [], name);
  }
  quiet(page);
  await page.close();
});

test('A typo is one squiggle at its place, the last good picture stays, and undo mends it', async () => {
  const page = await open('#config=mobile&scene=corner&show=ao');
  await page.click('#tab-text');
  await page.waitForSelector('.cm-content');
  const before = await page.evaluate(() => crevice.engine.canvas.toDataURL());
  const line = await page.evaluate(() => {
    const path = 'configs/mobile.json', text = crevice.engine.source(path);
    crevice.app.texts.editor.view.dispatch({changes: {from: text.indexOf('ao_scale'), to: text.indexOf('ao_scale') + 8, insert: 'ao_scael'}});
    return text.slice(0, text.indexOf('ao_scale')).split('\n').length;
  });
  await rest(page);
  const marked = await page.$$eval('.cm-lintRange-error, .cm-lintRange-warning', nodes => nodes.map(node => node.textContent));
  assert.equal(marked.length, 1, marked.join(' | '));
  assert.match(marked[0], /ao_scael/);
  const found = await page.evaluate(() => crevice.app.diagnostics.map(({file, line: at}) => [file, at]));
  assert.deepEqual(found, [['configs/mobile.json', line]]);
  const seen = camera => page.evaluate(async at => {
    crevice.app.setCamera(at);
    await crevice.app.whenIdle();
    return crevice.engine.canvas.toDataURL();
  }, camera);
  assert.notEqual(await seen(VIEW.camera), before, 'the last good config is drawn on');
  assert.equal(await seen(''), before);
  await page.focus('.cm-content');
  await page.keyboard.down('Control');
  await page.keyboard.press('z');
  await page.keyboard.up('Control');
  await rest(page);
  assert.deepEqual(await page.evaluate(() => crevice.app.diagnostics), []);
  quiet(page);
  await page.close();
});

test('A slider edits the text, the text moves the slider, and the patch draws the same elsewhere', async () => {
  const page = await open('#config=balanced&scene=corner&show=ao');
  await look(page, VIEW, SIZE);
  await page.evaluate(() => {
    crevice.app.knobs.begin();
    crevice.app.knobs.turn('param', 'radius', [0.9]);
  });
  await rest(page);
  const {text, patch, pixels} = await page.evaluate(() => ({
    text: crevice.engine.source('configs/balanced.json'), patch: crevice.engine.patch(0).text,
    pixels: [...crevice.engine.readBack(0, 'ao').values]
  }));
  assert.match(text, /"radius": 0\.9/);
  assert.deepEqual(JSON.parse(patch), {format: 1, extends: ['balanced'], params: {radius: 0.9}});
  writeFileSync(join(work, 'mine.json'), patch);
  await crevice('render', join(work, 'mine.json'), '--scene', VIEW.scene, '--camera', VIEW.camera, '--size', SIZE.join('x'), '--out',
    `ao=${join(work, 'mine.pfm')}`);
  assert(differing(pixels, readPfm(join(work, 'mine.pfm'))) <= 1);
  await page.evaluate(source => crevice.app.typed('configs/balanced.json', source.replace('0.9', '0.3')), text);
  await rest(page);
  assert.equal(await page.evaluate(() => crevice.engine.state(0).params.find(each => each.name === 'radius').value[0]), 0.3);
  quiet(page);
  await page.close();
});

test('A link holds what was changed', async () => {
  const page = await open('#config=gtao&scene=spheres&show=ao');
  await page.evaluate(() => crevice.app.knobs.turn('param', 'radius', [0.7]));
  await rest(page);
  await page.click('#share');
  await page.waitForFunction(() => location.hash.length > 40);
  const other = await open(await page.evaluate(() => location.hash));
  const seen = await other.evaluate(() => {
    const {app, engine} = crevice;
    return [app.a.config, app.a.show, engine.scene.name, engine.state(0).params.find(each => each.name === 'radius').value[0]];
  });
  assert.deepEqual(seen, ['gtao', 'ao', 'spheres', 0.7]);
  const broken = await open('#not-a-link');
  assert(await broken.evaluate(() => crevice.app.message?.text), 'a bad link is told');
  for (const each of [page, other, broken]) {
    quiet(each);
    await each.close();
  }
});

// A cube without normals, half a metre under its node.
async function boxGlb() {
  const document = new Document(), buffer = document.createBuffer();
  const corners = Array.from({length: 24}, (_, i) => (i % 3 === 0 ? i / 3 & 1 : i % 3 === 1 ? i / 6 & 1 : i / 12 & 1) - 0.5);
  const faces = [0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5];
  const accessor = (type, array) => document.createAccessor().setType(type).setArray(array).setBuffer(buffer);
  const primitive = document.createPrimitive()
    .setAttribute('POSITION', accessor('VEC3', new Float32Array(corners)))
    .setIndices(accessor('SCALAR', new Uint16Array(faces)));
  const node = document.createNode('box').setMesh(document.createMesh().addPrimitive(primitive)).setTranslation([0, -0.5, 0]);
  document.createScene().addChild(node);
  return Buffer.from(await new NodeIO().writeBinary(document));
}

test('A dropped .glb appears, and one that is broken is told', async () => {
  const page = await open();
  const glb = (await boxGlb()).toString('base64');
  const drop = bytes => page.evaluate(text => {
    const data = new DataTransfer();
    data.items.add(new File([Uint8Array.from(atob(text), c => c.charCodeAt(0))], 'box.glb'));
    for (const type of ['dragenter', 'dragover', 'drop'])
      document.body.dispatchEvent(new DragEvent(type, {dataTransfer: data, bubbles: true, cancelable: true}));
  }, bytes);
  await drop(glb);
  await page.waitForFunction(() => crevice.engine.scene.name.startsWith('box'));
  await rest(page);
  const shades = await page.evaluate(() => new Set(crevice.engine.readBack(0, 'color').values).size);
  assert(shades > 10, `${shades} different values`);
  await drop(glb.slice(0, 400));
  await page.waitForFunction(() => crevice.app.message?.kind === 'error');
  quiet(page);
  await page.close();
});

test('The heat map says what crevice compare says', async () => {
  const page = await open('#config=balanced&scene=spheres&show=ao');
  const camera = 'eye=1,1.7,3.2;at=0.15,0.4,0';
  await look(page, {scene: 'spheres', camera}, [192, 108]);
  await page.click('#truth');
  await rest(page);
  const figures = await page.evaluate(() => crevice.app.truth.figures);
  const written = await page.$eval('[data-figure=rmse]', node => node.textContent);
  assert.equal(written, figures.rmse.toFixed(4));
  const at = ['--scene', 'spheres', '--camera', camera, '--size', '192x108'];
  const [ao, truth] = ['ao.pfm', 'truth.pfm'].map(name => join(work, name));
  await crevice('render', 'balanced', ...at, '--out', `ao=${ao}`);
  await crevice('reference', ...at, '--radius', '0.5', '--rays', '64', '--out', truth);
  const native = JSON.parse(await crevice('compare', ao, truth, '--json'));
  console.log(`rmse ${figures.rmse} in the page, ${native.rmse} elsewhere`);
  for (const name of ['rmse', 'bias']) assert(Math.abs(figures[name] - native[name]) <= 0.005, name);
  quiet(page);
  await page.close();
});

test('mobile is drawn at 10 frames a second and more', async () => {
  const page = await open('#config=mobile&scene=street');
  const fps = await page.evaluate(() => {
    const {engine} = crevice, gl = engine.canvas.getContext('webgl2');
    engine.setSize(480, 270);
    const times = [];
    for (let i = 0; i < 20; ++i) {
      const begin = performance.now();
      engine.draw({camera: `eye=${0.01 * i},1.6,6;at=0,1.2,0`, left: {slot: 0, show: 'color'}});
      gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
      times.push(performance.now() - begin);
    }
    return 1000 / times.sort((x, y) => x - y)[times.length >> 1];  // the first frames have drivers compile for the size
  });
  console.log(`${fps.toFixed(1)} frames a second`);
  assert(fps >= LEAST_FPS);
  await page.close();
});

test('200 random actions leave the page working', async () => {
  const page = await open('#config=mobile_low&scene=corner');
  await look(page, VIEW, [96, 54]);
  let seed = 1;
  const random = n => (seed = seed * 48271 % 2147483647) % n;  // Lehmer's
  const pick = n => {
    const all = 'button, select:not(#size), input[type=range], input[type=checkbox], #canvas, summary, a[href^="#"]';
    const free = [...document.querySelectorAll(all)].filter(each =>
      each.checkVisibility({visibilityProperty: true}) && !each.disabled && !/save|download|copy/i.test(each.textContent));
    return free[n % free.length];
  };
  for (let i = 0; i < ACTIONS; ++i) {
    const node = await page.evaluateHandle(pick, random(1000));
    if (process.env.TRACE) console.log(i, Date.now(), await node.evaluate(each => each.id || each.textContent || each.name));
    const [kind, type] = await node.evaluate(each => [each.tagName, each.type]);
    if (kind === 'SELECT') await node.evaluate((each, n) => {
      each.selectedIndex = n % each.length;
      each.dispatchEvent(new Event('input', {bubbles: true}));
      each.dispatchEvent(new Event('change', {bubbles: true}));
    }, random(1000));
    else if (type === 'range') await node.press(random(2) ? 'ArrowRight' : 'ArrowLeft');
    else if (kind === 'CANVAS') {
      await node.hover();
      await page.mouse.wheel({deltaY: random(200) - 100});
    } else await node.click().catch(() => {});  // what has scrolled away
  }
  await page.evaluate(() => crevice.app.chooseConfig('mobile'));
  await rest(page);
  quiet(page);
  await page.close();
});
