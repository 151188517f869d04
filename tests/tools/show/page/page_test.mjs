// SPDX-License-Identifier: MIT
// The page in headless Chromium, used as people use it.
import assert from 'node:assert/strict';
import {mkdirSync, writeFileSync} from 'node:fs';
import {join} from 'node:path';
import {after, before, test} from 'node:test';
import {crevice, differing, open, quiet, readPfm, rest, start, stop, viewing, work} from './browser.mjs';

before(start);
after(stop);

// Planes of its own, so that depth is fine; no silhouette but the picture's, since two rasterisers differ there.
const VIEW = {scene: 'corner', camera: 'eye=0.8,1.4,2.8;at=0,0.45,0;near=1;far=12'};
const SIZE = [480, 270];
// Of a machine that takes twice as long as others for all; what must not come before the picture is a list of its own.
const [FIRST_PICTURE_MS, ACTIONS] = [8000, 200];

// The ordinary run compares each kind of config with this machine's picture, and turns the knobs of two.
const NIGHTLY = 'CREVICE_NIGHTLY' in process.env;
const COMPARED = ['mobile_low', 'mobile', 'balanced', 'balanced_far', 'high', 'hbao_plus', 'vxao', 'learnopengl', 'lettier'];
const TURNED = ['mobile', 'balanced'];
const nightly = {skip: !NIGHTLY && 'takes minutes, and tools/test.sh --nightly runs it'};

const configs = page => page.evaluate(() => crevice.engine.configs().map(each => each.name));
const look = (page, view, size) => page.evaluate(async (seen, [width, height]) => {
  crevice.app.chooseScene(seen.scene);
  crevice.app.chooseSize(`${width}x${height}`);
  crevice.app.setCamera(seen.camera);
  await crevice.app.whenIdle();
}, view, size);

// What a config draws in a slot of its own; of a temporal one `most` frames.
const drawn = (page, config, camera, most) => page.evaluate((name, at, most) => {
  const {engine} = crevice, slot = 1;
  const loaded = engine.load(slot, {config: name, outputs: ['ao']});
  if (!loaded.ok) return {failed: loaded.diagnostics[0].message};
  const frames = engine.plan(slot).targets.some(each => each.history_texture !== null) ? most : 1;
  for (let i = 0; i < frames; ++i) {
    const answer = engine.draw({camera: at, left: {slot, show: 'ao'}});
    if (!answer.ok) return {failed: answer.diagnostics[0].message};
  }
  const {answer, values} = engine.readBack(slot, 'ao');
  return {values: [...values].filter((_, i) => i % answer.channels === 0)};
}, config, camera, most);

test('The page opens without a word in its console, and soon', async () => {
  const page = await open();
  const [ms, before] = await page.evaluate(() => {
    const ms = performance.getEntriesByName('first-picture')[0].startTime;
    return [ms, performance.getEntriesByType('resource').filter(each => each.startTime < ms).map(each => each.name)];
  });
  console.log(`first picture after ${Math.round(ms)} ms`);
  assert(ms < FIRST_PICTURE_MS, `${ms} ms`);
  assert(before.some(name => name.endsWith('.wasm')) && !before.some(name => name.includes('editor')), String(before));
  quiet(page);
  await page.close();
});

test('The first picture is sharp, smooth and shows its AO, with what that takes', async () => {
  const page = await open();
  const [sizes, samples] = await page.evaluate(() => {
    const {clientWidth, clientHeight} = crevice.engine.canvas, msaa = crevice.engine.state(0).params.find(each => each.name === 'msaa');
    return [[crevice.engine.size, [clientWidth, clientHeight]], msaa.value[0]];
  });
  assert(sizes[0].every((pixels, i) => Math.abs(pixels - sizes[1][i]) <= 2), String(sizes));
  assert(samples > 1);
  const lit = await canvas(page);
  await page.select('#show-a', 'without');
  await rest(page);
  const flat = await canvas(page), darker = lit.filter((value, i) => value < flat[i] - 0.05).length / lit.length;
  assert(darker > 0.1, `AO is seen in ${darker} of the picture`);
  await page.waitForFunction(() => /^AO \d[\d.]* ms · mobile/.test(document.querySelector('#name-a').textContent));
  quiet(page);
  await page.close();
});

test('Configs stand in the order of the documentation with a word each, and radius and intensity lead the knobs', async () => {
  const page = await open('#config=balanced&scene=corner&size=96x54');
  const groups = await page.$$eval('#config-a optgroup', nodes =>
    nodes.map(node => [node.label, [...node.children].map(option => option.textContent)]));
  assert.deepEqual(groups.map(([label]) => label), ['Presets', 'Methods', 'Authors']);
  for (const [, options] of groups) for (const option of options) assert.match(option, /^\w+ – [^`*[\]]+$/);
  const presets = groups[0][1].map(option => option.split(' ')[0]), place = name => presets.indexOf(name);
  assert(place('mobile_low') === 0 && place('mobile') < place('balanced') && place('balanced') < place('high'));
  for (const name of ['mobile', 'ssdo', 'learnopengl']) {
    await page.select('#config-a', name);
    await rest(page);
    const knobs = await page.$$eval('[data-param]', nodes => nodes.map(node => node.dataset.param));
    assert.deepEqual(knobs.slice(0, 2), ['radius', 'intensity'], name);
  }
  quiet(page);
  await page.close();
});

test('Every config draws what it draws elsewhere', async () => {
  const page = await open('#config=gtao');  // the page as it opens has turned knobs of mobile
  await look(page, VIEW, SIZE);
  const off = [];
  for (const name of await configs(page)) {
    const compared = NIGHTLY || COMPARED.includes(name);
    const {values, failed} = await drawn(page, name, VIEW.camera, compared ? 32 : 1);
    assert.equal(failed, undefined, `${name}: ${failed}`);
    assert(values.every(Number.isFinite), `${name}: not a number`);
    if (!compared) continue;
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

test('Every knob moves through its range', async () => {
  const page = await open();
  await look(page, VIEW, [96, 54]);
  for (const name of NIGHTLY ? await configs(page) : TURNED) {
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

// Rows of the canvas from the lowest on, its red channel as a share.
const canvas = page => page.evaluate(() => {
  const {canvas} = crevice.engine, gl = canvas.getContext('webgl2'), bytes = new Uint8Array(4 * canvas.width * canvas.height);
  const bound = gl.getParameter(gl.READ_FRAMEBUFFER_BINDING);  // what was drawn last, perhaps to be timed
  gl.bindFramebuffer(gl.READ_FRAMEBUFFER, null);
  gl.readPixels(0, 0, canvas.width, canvas.height, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
  gl.bindFramebuffer(gl.READ_FRAMEBUFFER, bound);
  return [...bytes].filter((_, i) => i % 4 === 0).map(byte => byte / 255);
});

test('The canvas shows A, a drag orbits, and a line parts A from B', async () => {
  const page = await open('#config=balanced&scene=corner&show=ao&size=96x54');
  const ao = () => page.evaluate(() => [...crevice.engine.readBack(0, 'ao').values]);
  const home = await ao();
  assert(differing(await canvas(page), home) === 0);
  const {x, y, width, height} = await (await page.$('#canvas')).boundingBox();
  await page.mouse.move(x + width / 2, y + height / 2);
  await page.mouse.down();
  await page.mouse.move(x + width / 2 + 90, y + height / 2, {steps: 3});
  await page.mouse.up();
  await rest(page);
  assert.match(await page.$eval('#camera-text', field => field.value), /^eye=/);
  const turned = await ao();
  assert(differing(turned, home) > 10);
  await page.click('#split');
  await page.select('#config-b', 'learnopengl');
  await rest(page);
  const parted = await canvas(page), right = i => i % 96 >= 48;
  assert(differing(parted.filter((_, i) => !right(i)), turned.filter((_, i) => !right(i))) === 0);
  const b = await page.evaluate(() => [...crevice.engine.readBack(1, 'ao').values]);
  assert(differing(parted.filter((_, i) => right(i)), b.filter((_, i) => right(i))) === 0);
  assert(differing(b, turned) > 1);
  await page.click('#home');
  await rest(page);
  assert.deepEqual(await ao(), home);
  quiet(page);
  await page.close();
});

test('Doubt is shown as heat, with the error that is to be expected', async () => {
  const page = await open('#config=balanced&scene=corner&show=doubt&size=96x54');
  const read = name => page.evaluate(name => [...crevice.engine.readBack(0, name).values], name);
  const [rmse] = await read('doubt_rmse'), red = (await read('doubt')).map(value => Math.min(1, 12 * value));
  assert(rmse > 0.001 && rmse < 0.3, String(rmse));
  assert(differing(await canvas(page), red) === 0 && Math.max(...red) > 0.2);
  const said = `Doubt, rmse about ${Number(rmse.toPrecision(2))}`;
  await page.waitForFunction(said => document.getElementById('name-a').textContent.endsWith(said), {}, said);
  await page.select('#show-a', 'ao');
  await rest(page);
  assert((await page.$eval('#name-a', node => node.textContent)).endsWith('AO'));
  quiet(page);
  await page.close();
});

test('A/B opens with another picture than A', async () => {
  const page = await open('#config=balanced&scene=corner&size=96x54');
  for (const [show, other] of [['color', 'without'], ['without', 'color'], ['ao', 'without']]) {
    await page.select('#show-a', show);
    await rest(page);
    const alone = await canvas(page), right = i => i % 96 >= 48;
    await page.click('#split');
    await rest(page);
    assert.equal(await page.$eval('#show-b', node => node.value), other);
    assert(differing((await canvas(page)).filter((_, i) => right(i)), alone.filter((_, i) => right(i))) > 1, show);
    await page.click('#split');
    await page.evaluate(() => crevice.app.setShow('b', crevice.app.a.show));  // as a user leaves it
    await rest(page);
  }
  quiet(page);
  await page.close();
});

test('The stage keeps its height while the camera moves and the truth is traced', async () => {
  const page = await open('#config=mobile&scene=corner&size=96x54', {width: 1280, height: 800});
  const heights = new Set(), measure = async () => heights.add(await page.$eval('#stage', node => node.clientHeight));
  await measure();
  for (const camera of ['eye=1,2,3;at=0,0,0', 'eye=-1.2345,2.3456,-3.4567;at=0.12345,0.23456,0.34567;up=0.1,0.9,0.2;fov=51.234']) {
    await page.evaluate(at => crevice.app.setCamera(at), camera);
    await rest(page);
    await measure();
  }
  await page.click('#truth');
  await measure();
  await rest(page);
  await measure();
  assert.equal(heights.size, 1, [...heights].join(' '));
  quiet(page);
  await page.close();
});

test('The plan keeps its lines in a narrow window', async () => {
  const page = await open('#config=high&scene=corner&size=96x54', {width: 420, height: 800});
  await page.evaluate(() => crevice.app.openTab('plan'));
  const {lines, rows, wide} = await page.$eval('#plan-text', node => ({
    lines: node.textContent.trimEnd().split('\n').length,
    rows: (node.clientHeight - 2 * parseFloat(getComputedStyle(node).paddingTop)) / parseFloat(getComputedStyle(node).lineHeight),
    wide: document.scrollingElement.scrollWidth
  }));
  assert(Math.abs(rows - lines) < 2, `${lines} lines in ${rows} rows`);
  assert(wide <= 420, `${wide} pixels`);
  quiet(page);
  await page.close();
});

test('Each tab shows what the engine says', async () => {
  const page = await open('#config=balanced&scene=corner&size=96x54');
  const passes = await page.evaluate(() => crevice.engine.plan(0).passes.map(pass => pass.name));
  const words = selector => page.$$eval(selector, nodes => nodes.map(node => node.textContent));
  await page.click('#tab-plan');
  await rest(page);
  const plan = (await words('#plan-text'))[0];
  for (const name of passes) assert.match(plan, new RegExp(`^  ${name}: `, 'm'));
  await page.click('#tab-cost');
  await page.waitForSelector('#passes tr');
  assert.deepEqual(await words('#passes th'), passes);
  assert.deepEqual(await words('#turns th'), ['balanced', 'learnopengl']);
  assert.match((await words('#turns td'))[1], /^[\d.]+ of learnopengl \([\d.]+ to [\d.]+\)$/);
  const [ao, sum] = await page.evaluate(() => {
    const {ao_ms, passes} = crevice.app.timing.sides[0].runs[0];
    const drawn = ['geometry', 'back_faces', 'lighting'];
    return [ao_ms, passes.filter(({name}) => !drawn.includes(name)).reduce((sum, {ms}) => sum + ms, 0)];
  });
  assert(Math.abs(ao - sum) < 1e-6, `${ao} of ${sum} ms`);
  await page.select('#config-a', 'learnopengl');
  await page.waitForFunction(() => document.querySelector('#turns th').textContent === 'learnopengl');
  // A busy machine may shift all turns to one side.
  const [turns, grey] = await page.evaluate(() =>
    [document.querySelectorAll('#turns td')[1].textContent, document.querySelectorAll('#turns tr.soft').length]);
  const [least, most] = turns.match(/([\d.]+) to ([\d.]+)\)$/).slice(1).map(Number);
  if (least < 0.99 && most > 1.01) assert.equal(grey, 2, 'what overlaps is grey');
  if (least > 1.01 || most < 0.99) assert.equal(grey, 0, 'what does not is not');
  await page.select('#config-a', 'balanced');
  await rest(page);
  await page.click('#tab-patch');
  assert.deepEqual(JSON.parse((await words('#patch-text'))[0]), {format: 1, extends: ['balanced']});
  await page.click('#tab-panel');
  const [knobs, params] = [await page.$$('[data-param]'), await page.evaluate(() => crevice.engine.state(0).params.length)];
  assert.equal(knobs.length, params);
  assert.match((await words('.command'))[0], /^crevice render balanced --scene corner --size 96x54 --out color=color.png/);
  quiet(page);
  await page.close();
});

test('Which config to take is measured here as the command measures it, can be stopped, and is used', async () => {
  const page = await open('#config=balanced&scene=spheres&size=96x54&show=ao');
  const words = selector => page.$$eval(selector, nodes => nodes.map(node => node.textContent));
  await page.evaluate(() => crevice.app.knobs.turn('param', 'radius', [0.2]));  // far from what configs have
  await page.click('#tab-cost');
  await page.type('#budget', 'soon');
  await page.click('#measure-all');
  await page.waitForFunction(() => document.querySelector('#message').textContent.includes("'soon'"));
  await page.$eval('#budget', input => input.value = '100x');
  await page.click('#measure-all');
  await page.waitForFunction(() => document.querySelectorAll('#found tr').length > 1, {timeout: 120000});
  assert.equal(await page.$eval('#measure-all', node => node.textContent), 'Stop');
  await page.click('#measure-all');
  await rest(page);
  assert.equal(await page.$eval('#measure-all', node => node.textContent), 'Measure all');
  const rows = await words('#found tr'), best = await words('#found th');
  assert.equal(best.length, 1, String(rows));
  for (const row of rows) assert.match(row, / ms0\.\d{4} ± 0\.\d{4}Use$/);
  assert.match((await words('#choice-said'))[0], /^\d+ s: .*, error 0\.\d+ \(0\.\d+ to 0\.\d+\), /);

  // The error of one of them is what the command says of the same view.
  const row = rows.find(each => each.startsWith('mobile ')) ?? rows.find(each => each.startsWith('balanced ')) ?? rows[0];
  const [, label, error, margin] = row.match(/^(?:➤ )?(.*?)(?: ★)?[\d.]+ ms([\d.]+) ± ([\d.]+)Use$/);
  const [config, ...set] = (label + ' radius=0.2').split(' '), view = ['--scene', 'spheres', '--size', '96x54'];
  const ao = join(work, 'found.pfm'), truth = join(work, 'found_truth.pfm');
  await crevice('render', config, ...set.flatMap(each => ['--set', each]), ...view, '--frames', '32', '--out', `ao=${ao}`);
  await crevice('reference', ...view, '--radius', '0.2', '--out', truth);
  const {rmse} = JSON.parse(await crevice('compare', ao, truth, '--json'));
  assert(Math.abs(rmse - error) <= Number(margin) + 0.005, `${row}: ${rmse}`);

  // A setting beside a config becomes a config of its own.
  const answer = await page.evaluate(() => crevice.engine.foundText(JSON.stringify({config: 'balanced', overrides: ['steps=4']})));
  assert.deepEqual(JSON.parse(answer.text), {format: 1, extends: ['balanced'], params: {steps: 4}});
  await page.click('#found button');
  await rest(page);
  assert(!(await page.$eval('#message', node => !node.hidden)));
  page.heard = page.heard.filter(line => !line.includes('soon'));
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
  await page.evaluate(source => crevice.app.typed('configs/balanced.json', source.replace('"radius": 0.9', '"radius": 0.3')), text);
  await rest(page);
  assert.equal(await page.evaluate(() => crevice.engine.state(0).params.find(each => each.name === 'radius').value[0]), 0.3);
  await page.click('#reset-all');
  await rest(page);
  assert.deepEqual(await page.evaluate(() => crevice.engine.editedPaths()), []);
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

test('crevice view opens what a link says, of one\'s own files too', async () => {
  const folder = join(work, 'a_folder_with_a_name_that_fills_the_box');
  mkdirSync(folder);
  const config = join(folder, 'mine.json'), model = join(folder, 'model.obj');
  writeFileSync(config, '{"format": 1, "extends": ["gtao"], "params": {"radius": 0.3}}\n');
  writeFileSync(model, 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n');
  const seen = page => page.evaluate(() => {
    const {app, engine} = crevice, radius = engine.state(0).params.find(each => each.name === 'radius').value[0];
    return [app.a.config, app.builtin, app.camera, radius];
  });
  await viewing(async address => {
    const page = await open(address + '#size=96x54');
    assert.deepEqual(await seen(page), ['mine', null, '', 0.3]);
    assert.equal(await page.$eval('#scene', node => node.selectedOptions[0].textContent), 'model.obj');
    await page.evaluate(() => location.hash = 'scene=corner&camera=eye=1,2,3&size=96x54');
    await page.waitForFunction(() => crevice.app.builtin === 'corner');
    await page.evaluate(() => crevice.app.knobs.turn('param', 'radius', [0.7]));
    assert.deepEqual(await seen(page), ['mine', 'corner', 'eye=1,2,3', 0.7]);
    await page.click('#share');
    await page.waitForFunction(() => !location.hash.includes('='));
    const linked = await open(address + '#config=sao&scene=spheres&camera=eye=3,2,1&size=96x54');
    assert.deepEqual(await seen(linked), ['sao', 'spheres', 'eye=3,2,1', 0.5]);
    const shared = await open(await page.evaluate(() => location.href));
    assert.deepEqual(await seen(shared), ['mine', 'corner', 'eye=1,2,3', 0.7]);
    for (const each of [page, linked, shared]) {
      quiet(each);
      await each.close();
    }
  }, config, '--scene', model);
});

test('A model that is dropped is the scene of crevice view; a page of its own says how to see it', async () => {
  const drop = (page, name, text) => page.evaluate(async (name, text) => {
    const dataTransfer = new DataTransfer();
    dataTransfer.items.add(new File([text], name));
    dispatchEvent(new DragEvent('drop', {dataTransfer, cancelable: true}));
    await crevice.app.whenIdle();
    return [crevice.engine.scene.name, crevice.app.message?.text ?? ''];
  }, name, text);
  const tent = 'v 0 0 0\nv 2 0 0\nv 0 2 0\nv 0 0 2\nf 1 2 3\nf 1 2 4\n';
  const alone = await open('#scene=corner&size=96x54');
  assert.match((await drop(alone, 'tent.obj', tent))[1], /crevice view --scene tent.obj/);
  await alone.close();
  await viewing(async address => {
    const page = await open(address + '#size=96x54');
    assert.deepEqual(await drop(page, 'tent.obj', tent), ['tent.obj', '']);
    assert.equal(await page.evaluate(() => crevice.app.builtin), null);
    quiet(page);
    const [name, said] = await drop(page, 'broken.glb', 'nothing');
    assert.equal(name, 'tent.obj');
    assert.match(said, /CV7002.*broken.glb/);
    await page.reload();
    await page.waitForFunction(() => window.crevice?.app.started);
    await rest(page);
    assert.equal(await page.evaluate(() => crevice.engine.scene.name), 'tent.obj');
    await page.close();
  });
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
  assert.match(await page.$eval('#scale', node => node.textContent), new RegExp(`−${figures.range}.*0.*\\+${figures.range}`));
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

test('200 random actions leave the page working', nightly, async () => {
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
