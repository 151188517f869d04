// SPDX-License-Identifier: MIT
// Bundles the page's scripts into a folder, with npm's packages from another: node build.mjs FOLDER NODE_MODULES
import {copyFileSync, mkdirSync, readFileSync} from "node:fs";
import {createRequire} from "node:module";
import {dirname, join} from "node:path";
import {fileURLToPath} from "node:url";

const here = dirname(fileURLToPath(import.meta.url)), [folder, modules] = process.argv.slice(2);
if (!modules) throw new Error("build.mjs: name the folder to build into, and node_modules");
const {build} = createRequire(join(modules, "index.js"))("esbuild");

// Order and words of the shipped configs: those of the documentation's tables, by the heading of their second column.
const GROUPS = {"take it for": "Presets", "what it is": "Methods", author: "Authors"}, configs = [];
const pages = ["which_config", "reference/methods"].map(name => readFileSync(join(here, `../../../docs/${name}.md`), "utf8"));
let group;
for (const [, name, second] of pages.join("\n").matchAll(/^\| (?:config|`(\w+)(?:=\w+)?`) \| ([^|]*) \|/gm))
  if (!name) group = GROUPS[second];
  else if (!configs.some(each => each.name === name))
    configs.push({name, group, words: second.replace(/\[([^\]]*)\]\([^)]*\)|[*`]/g, "$1")});

mkdirSync(folder, {recursive: true});
await build({
  entryPoints: {page: join(here, "src/main.js"), trace_worker: join(here, "src/engine/trace_worker.js")},
  outdir: folder, bundle: true, splitting: true, format: "esm", minify: true, target: "es2022", legalComments: "none",
  chunkNames: "[name]-[hash]", external: ["./crevice_page.js", "node:fs", "node:path"], loader: {".frag": "text", ".json": "json"},
  nodePaths: [modules], logLevel: "warning", define: {CONFIGS: JSON.stringify(configs)}
});
for (const name of ["index.html", "page.css"]) copyFileSync(join(here, name), join(folder, name));
