// SPDX-License-Identifier: MIT
// Configs of the shaders of n8ao, three.js and postprocessing: node make.mjs MODULES FOLDER, where MODULES is the node_modules that npm
// made. tools/scripts/peers.sh calls it.
import {mkdirSync, readFileSync} from "node:fs";
import {register} from "node:module";
import {resolve} from "node:path";
import {pathToFileURL} from "node:url";

import {makeN8ao} from "./n8ao.mjs";
import {makePostprocessing, makeThree} from "./three.mjs";

// n8ao imports JSON as bundlers have it, without an attribute.
register("data:text/javascript," + encodeURIComponent(`
  import {readFileSync} from "node:fs";
  export const load = (url, context, next) => url.endsWith(".json") ?
    {format: "module", source: "export default " + readFileSync(new URL(url), "utf8"), shortCircuit: true} :
    next(url, context);`));

// three.js makes its noise by chance; here it is the same each time. The generator is that of Numerical Recipes.
let state = 1;
Math.random = () => (state = (Math.imul(state, 1664525) + 1013904223) >>> 0) / 2 ** 32;

const [modules, folder] = process.argv.slice(2).map(path => resolve(path));
const from = file => import(pathToFileURL(`${modules}/${file}`).href);
mkdirSync(folder, {recursive: true});

const three = await from("three/build/three.module.js");
const {N8AOPass} = await from("n8ao/src/N8AOPass.js");
const {DepthMipAtlas, DEPTH_MIP_LEVELS} = await from("n8ao/src/DepthMipAtlas.js");
const passes = await Promise.all(["GTAO", "SSAO", "SAO"].map(name => from(`three/examples/jsm/postprocessing/${name}Pass.js`)));
const {BlurShaderUtils} = await from("three/examples/jsm/shaders/DepthLimitedBlurShader.js");
const {SSAOEffect} = await from("postprocessing/build/index.js");
const chunks = three.ShaderChunk;
const versionOf = name => JSON.parse(readFileSync(`${modules}/${name}/package.json`)).version;

const made = [
  ...makeN8ao(folder, {
    three, chunks, version: versionOf("n8ao"), N8AOPass, DEPTH_MIP_LEVELS, atlasMaterial: new DepthMipAtlas().quad.material
  }),
  ...makeThree(folder, {three, chunks, BlurShaderUtils, ...Object.assign({}, ...passes)}),
  makePostprocessing(folder, {three, chunks, version: versionOf("postprocessing"), SSAOEffect})
];
console.log(`wrote ${made.length} configs of peers to ${folder}: ${made.join(", ")}`);
