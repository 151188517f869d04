// SPDX-License-Identifier: MIT
// Bundles the page's scripts into a folder: node build.mjs FOLDER
import {build} from "esbuild";
import {copyFileSync, mkdirSync, readFileSync} from "node:fs";
import {dirname, join} from "node:path";
import {fileURLToPath} from "node:url";

const here = dirname(fileURLToPath(import.meta.url)), folder = process.argv[2];
if (!folder) throw new Error("build.mjs: name the folder to build into");

// The reports' chart is a plain script that a page embeds; here it becomes a module.
const CHART_EXPORTS = "SHAPES, three, ms, error, ticks, short, chart, boxAround, nameMarks";
const reportScripts = {
  name: "report scripts",
  setup(builder) {
    builder.onLoad({filter: /report[\\/]chart\.js$/}, ({path}) => ({
      contents: `import {add} from "../page/src/dom.js";\n${readFileSync(path, "utf8")}\nexport {${CHART_EXPORTS}};`
    }));
  }
};

mkdirSync(folder, {recursive: true});
await build({
  entryPoints: {page: join(here, "src/main.js"), trace_worker: join(here, "src/trace_worker.js")},
  outdir: folder, bundle: true, splitting: true, format: "esm", minify: true, target: "es2022", legalComments: "none",
  chunkNames: "[name]-[hash]", external: ["./crevice_page.js", "node:fs", "node:path"], loader: {".frag": "text", ".json": "json"},
  plugins: [reportScripts], logLevel: "warning"
});
for (const name of ["index.html", "page.css"]) copyFileSync(join(here, name), join(folder, name));
