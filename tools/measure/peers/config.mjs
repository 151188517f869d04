// SPDX-License-Identifier: MIT
// A config of passes over the whole screen, with its shaders and noise, in a folder.
import {writeFileSync} from "node:fs";
import {join} from "node:path";
import {crc32, deflateSync} from "node:zlib";

import {translate} from "./translate.mjs";

const VERTEX = `#version 300 es
precision highp float;
out vec2 vUv;
void main()
{
    vUv = vec2((gl_VertexID << 1) & 2, gl_VertexID & 2);
    gl_Position = vec4(vUv * 2.0 - 1.0, 0.0, 1.0);
}
`;

export class Config {
  constructor(folder, name, description, geometry, chunks) {
    this.folder = folder;
    this.chunks = chunks;
    this.json = {
      format: 1, name, description, extends: [geometry], imports: {},
      params: {radius: {default: 0.5, min: 0.001, max: 1e6, unit: "scene units"}},
      targets: {}, shaders: {}, passes: {}, outputs: {ao: "ao"}
    };
  }

  target(name, format, scale = 1) {
    this.json.targets[name] = {format: [format], ...(scale === 1 ? {} : {size: {scale}})};
    return name;
  }

  // A three.js DataTexture of bytes that repeats.
  noise(name, texture) {
    const {width, height, data} = texture.image;
    writeFileSync(join(this.folder, `${name}.png`), png(width, height, data));
    this.json.imports[name] = {type: "texture", format: "rgba8"};
    return {from: name, wrap: "repeat"};
  }

  // `writes` are names of targets, `bind` as translate() has it.
  pass(name, material, writes, bind, more = {}) {
    const made = {inputs: {}, params: {}};
    const file = `${this.json.name}_${name}.frag`;
    writeFileSync(join(this.folder, file), translate(material, this.chunks, bind, name, made));
    Object.assign(this.json.params, made.params);
    this.json.shaders[name] = {vertex: "./peer.vert", fragment: `./${file}`};
    this.json.passes[name] = {type: "fullscreen", shader: name, color: writes, inputs: made.inputs, ...more};
  }

  write() {
    writeFileSync(join(this.folder, "peer.vert"), VERTEX);
    writeFileSync(join(this.folder, `${this.json.name}.json`), JSON.stringify(this.json, null, 2) + "\n");
  }
}

// ---- A PNG of 8 bits and four channels, as it is

function chunk(type, data) {
  const body = Buffer.concat([Buffer.from(type, "latin1"), data]), out = Buffer.alloc(body.length + 8);
  out.writeUInt32BE(data.length, 0);
  body.copy(out, 4);
  out.writeUInt32BE(crc32(body), body.length + 4);
  return out;
}

// `pixels`: rows from the bottom up, as textures have them.
function png(width, height, pixels) {
  const header = Buffer.alloc(13), rows = [];
  header.writeUInt32BE(width, 0);
  header.writeUInt32BE(height, 4);
  header.set([8, 6, 0, 0, 0], 8);
  for (let y = height - 1; y >= 0; --y)
    rows.push(Buffer.from([0]), Buffer.from(pixels.subarray(4 * width * y, 4 * width * (y + 1))));
  return Buffer.concat([
    Buffer.from([137, 80, 78, 71, 13, 10, 26, 10]), chunk("IHDR", header),
    chunk("IDAT", deflateSync(Buffer.concat(rows))), chunk("IEND", Buffer.alloc(0))
  ]);
}
