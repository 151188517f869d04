// SPDX-License-Identifier: MIT
// A made-up library with a shader as three.js has them, turned into a config: made_up.mjs TOOLS FOLDER.
import {pathToFileURL} from "node:url";

const [tools, folder] = process.argv.slice(2);
const {Config} = await import(pathToFileURL(`${tools}/config.mjs`).href);
const vector = (...list) => ({toArray: () => list});
const material = {
  defines: {PARTS: 2},
  uniforms: {
    strength: {value: 0.5}, darker: {value: true}, disk: {value: [vector(0, 0), vector(0.5, 1)]}, r: {value: 5},
    radius: {value: 12}, offset: {value: vector(0.125, 0)}
  },
  fragmentShader: `
    uniform sampler2D tNoise;
    uniform float strength; uniform float r;
    uniform vec2[PARTS] disk;
    uniform vec2 offset;
    uniform float radius;
    uniform bool darker;
    uniform mat4 projectionMatrixInv;
    #include <halved>
    varying vec2 vUv;
    void main() {
        // 0 at the far end of the view ray's own clip space, whatever the camera
        float none = (projectionMatrixInv * vec4(0.0, 0.0, 1.0, 1.0)).x;
        float open = strength * disk[1].x + offset.x + (radius - 12.0) + none;
        gl_FragColor = vec4(darker ? halved(open) + texture2D(tNoise, vUv).r * 0.25 : 1.0);
    }`
};
const chunks = {halved: "float halved(float x) { return 0.5 * x; }"};
const config = new Config(folder, "made_up", "Made up.", "geometry/depth_only", chunks);
config.target("ao", "r32f");
const noise = {image: {width: 2, height: 2, data: new Uint8Array(16).fill(128)}};
const samplers = {tNoise: config.noise("made_up_noise", noise)};
config.pass("shade", material, ["ao"], {samplers, rename: {radius: "reach"}});
config.write();
