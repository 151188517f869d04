// SPDX-License-Identifier: MIT
// What the page's tests share: the built page served on this machine, a headless Chromium on software WebGL, the crevice
// command.
import assert from 'node:assert/strict';
import {execFile, spawn} from 'node:child_process';
import {once} from 'node:events';
import {createReadStream, mkdtempSync, readFileSync, rmSync, statSync} from 'node:fs';
import {createServer} from 'node:http';
import {tmpdir} from 'node:os';
import {extname, join} from 'node:path';
import {promisify} from 'node:util';
import puppeteer from 'puppeteer-core';

const {BROWSER, CREVICE, PAGE} = process.env;  // page_test.sh says them
const TYPES = {'.css': 'text/css', '.html': 'text/html', '.js': 'text/javascript', '.wasm': 'application/wasm'};
const FLAGS = [
  '--no-sandbox', '--disable-gpu-sandbox', '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'
];
export const work = mkdtempSync(join(tmpdir(), 'crevice_page_'));

/// Runs `crevice view` with these arguments while `use(address)` does.
export async function viewing(use, ...options) {
  const view = spawn(CREVICE, ['view', ...options, '--page', PAGE, '--no-browser']);
  try {
    const [address] = await once(view.stdout, 'data');
    return await use(String(address).trim());
  } finally {
    view.kill('SIGINT');
  }
}

// What a page that `crevice view` serves may do.
const policyOfView = () => viewing(async address => (await fetch(address)).headers.get('content-security-policy'));

let server, chromium;
export async function start() {
  const policy = await policyOfView();
  assert(policy);
  server = createServer((request, response) => {
    const name = new URL(request.url, 'http://page').pathname.slice(1) || 'index.html';
    const file = join(PAGE, name), known = !name.includes('/') && statSync(file, {throwIfNoEntry: false});
    response.writeHead(known ? 200 : 404, {
      'content-type': TYPES[extname(file)] ?? 'application/octet-stream', 'content-security-policy': policy
    });
    known ? createReadStream(file).pipe(response) : response.end();
  });
  await new Promise(listening => server.listen(0, '127.0.0.1', listening));
  chromium = await puppeteer.launch({
    executablePath: BROWSER, args: FLAGS, protocolTimeout: 600000, userDataDir: join(work, 'profile')
  });
}

export async function stop() {
  await chromium?.close();
  server?.closeAllConnections();
  server?.close();
  rmSync(work, {recursive: true, force: true});
}

/// Opens the page at a link, or at an address of `viewing`, and waits until it rests. `heard` gathers what the console and the network complain of.
export async function open(link = '', {width = 1400, height = 900} = {}) {
  const page = await chromium.newPage();
  page.heard = [];
  page.on('pageerror', error => page.heard.push(error.message));
  page.on('console', message => {
    const harmless = /GPU stall due to ReadPixels/.test(message.text());  // tests read pictures back
    if (['error', 'warn'].includes(message.type()) && !harmless) page.heard.push(message.text());
  });
  page.on('response', response => response.status() >= 400 && page.heard.push(response.status() + ' ' + response.url()));
  await page.setViewport({width, height, isMobile: width < 500, hasTouch: width < 500});
  await page.goto(new URL(link, `http://127.0.0.1:${server.address().port}/`));
  await page.waitForFunction('window.crevice');
  await rest(page);
  return page;
}

export const rest = page => page.evaluate(() => crevice.app.whenIdle());

/// Fails with what the console said.
export const quiet = page => assert.deepEqual(page.heard, []);

/// Runs the crevice command; gives its stdout.
export async function crevice(...options) {
  const {stdout} = await promisify(execFile)(CREVICE, options);
  return stdout;
}

/// The first channel of a PFM, lowest row first.
export function readPfm(file) {
  const bytes = readFileSync(file), lines = bytes.toString('latin1', 0, 64).split('\n', 3);
  const begin = lines.join('\n').length + 1, channels = lines[0] === 'PF' ? 3 : 1;
  const all = new Float32Array(bytes.buffer.slice(bytes.byteOffset + begin, bytes.byteOffset + bytes.length));
  return all.filter((_, i) => i % channels === 0);
}

/// The share of values, in per cent, that differ by more than 2/255, or are none.
export function differing(a, b) {
  assert.equal(a.length, b.length);
  let count = 0;
  for (let i = 0; i < a.length; ++i) count += !(Math.abs(a[i] - b[i]) <= 2 / 255 + 1e-6);
  return 100 * count / a.length;
}
