// SPDX-License-Identifier: MIT
// Draws each of `configs` and leaves the pixels of the canvas in the page, as base64 of RGBA from the lowest row; and
// the time of the last frame, where the program takes it.
function pixelsOf(config) {
  part('config').add(new Option(config), 0);
  part('config').selectedIndex = 0;
  drawAll();
  const canvas = part('canvas');
  const gl = canvas.getContext('webgl2');
  const pixels = new Uint8Array(canvas.width * canvas.height * 4);
  gl.readPixels(0, 0, canvas.width, canvas.height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
  let text = '';
  for (const value of pixels) text += String.fromCharCode(value);
  return btoa(text);
}

function show(id, text) {
  const result = document.createElement('pre');
  result.id = id;
  result.textContent = text + '\n';
  document.body.append(result);
}

const started = setInterval(() => {
  if (!draw) return;
  clearInterval(started);
  for (const config of configs) show('pixels_' + config, pixelsOf(config));
  const timed = Module._frameTime && setInterval(() => {
    const ms = Module._frameTime();
    if (ms === 0) return;
    clearInterval(timed);
    show('frame_ms', ms);
  }, 10);
}, 10);
