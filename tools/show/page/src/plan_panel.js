// SPDX-License-Identifier: MIT
// The plan as a graph: passes and the textures between them; what is left out stands below, with its reason.
import {$, add} from "./dom.js";

const LINE_PX = 15, PAD_PX = 8, CHAR_PX = 7.4;

export class PlanPanel {
  constructor(app) {
    Object.assign(this, {app, root: $("plan"), shown: ""});
    app.on("tab", () => this.show());
    app.on("loaded", () => this.show());
    app.on("values", () => this.show());
    app.on("size", () => this.show());
  }

  show() {
    const {app} = this;
    if (app.tab !== "plan" || !app.stateA()) return;
    const plan = app.guard(() => app.engine.plan(0)), key = JSON.stringify(plan);
    if (!plan || key === this.shown) return;
    this.shown = key;
    return app.during(async () => {
      this.layout ??= (await import("./graph_layout.js")).layout;
      this.root.replaceChildren();
      const megabytes = (plan.texture_bytes / 1e6).toFixed(2);
      add(this.root, "p", {class: "soft"}, `${plan.passes.length} passes, ${plan.textures.length} textures, ` +
        `${megabytes} MB at ${plan.extent.join(" × ")}. Boxes are passes, rounded ones textures.`);
      drawGraph(add(this.root, "div", {class: "graph scroll", tabindex: 0, role: "group", "aria-label": "Graph of the plan"}), plan, this.layout);
      showElided(this.root, plan.elided);
    });
  }
}

const kilobytes = bytes => bytes >= 1e6 ? `${(bytes / 1e6).toFixed(1)} MB` : `${(bytes / 1e3).toFixed(1)} kB`;

/// {nodes: [{id, kind, lines, title}], edges: [[from, to]]} of a plan; each target is a node of its own.
function graphOf(plan) {
  const nodes = [], edges = [];
  for (const pass of plan.passes)
    nodes.push({id: "pass " + pass.name, kind: "pass", lines: [pass.name, `${pass.type} ${pass.extent.join("×")}`],
      title: `reads ${kilobytes(pass.bytes_read)}, writes ${kilobytes(pass.bytes_written)} a frame`});
  for (const target of plan.targets) {
    const texture = plan.textures[target.texture];
    if (!texture) continue;
    const also = texture.targets.filter(name => name !== target.name);
    nodes.push({id: "target " + target.name, kind: "target", lines: [target.name, `${texture.format} ${texture.extent.join("×")}`],
      title: kilobytes(texture.bytes) + (also.length ? `, one texture with ${also.join(", ")}` : "")});
  }
  for (const output of plan.outputs) {
    nodes.push({id: "output " + output.name, kind: "output", lines: [output.name, output.constant === null ? "output" : `constant ${output.constant}`]});
    if (output.target) edges.push(["target " + output.target, "output " + output.name]);
  }
  const known = new Set(nodes.map(n => n.id));
  for (const pass of plan.passes) {
    const own = "pass " + pass.name, written = [...pass.color, ...pass.depth ? [pass.depth] : []].map(a => a.target);
    for (const name of written) edges.push([own, "target " + name]);
    for (const {from} of pass.inputs) if (!written.includes(from)) edges.push(["target " + from, own]);
  }
  const unique = new Set(edges.filter(([a, b]) => known.has(a) && known.has(b)).map(e => e.join("\n")));
  return {nodes, edges: [...unique].map(e => e.split("\n"))};
}

function drawGraph(parent, plan, layout) {
  const {nodes, edges} = graphOf(plan);
  for (const node of nodes) {
    node.width = Math.max(...node.lines.map(l => l.length)) * CHAR_PX + 2 * PAD_PX;
    node.height = node.lines.length * LINE_PX + PAD_PX;
  }
  const {left, width, height, paths} = layout(nodes, edges);
  const svg = add(parent, "svg", {viewBox: `${left} 0 ${width} ${height}`, style: `width:${width}px;height:${height}px`, role: "img",
    "aria-label": `Passes in order: ${plan.passes.map(p => p.name).join(", ")}`});
  const defs = add(svg, "defs");
  const arrow = add(defs, "marker", {id: "arrow", viewBox: "0 0 8 8", refX: 7, refY: 4, markerWidth: 7, markerHeight: 7, orient: "auto"});
  add(arrow, "path", {d: "M0 0L8 4L0 8z"});
  for (const points of paths)
    add(svg, "path", {class: "edge", "marker-end": "url(#arrow)", d: "M" + points.map(p => `${p.x} ${p.y}`).join("L")});
  for (const node of nodes) {
    const group = add(svg, "g", {class: "node " + node.kind, transform: `translate(${node.x - node.width / 2} ${node.y - node.height / 2})`});
    if (node.title) add(group, "title", {}, node.title);
    add(group, "rect", {width: node.width, height: node.height, rx: node.kind === "target" ? 12 : 3});
    node.lines.forEach((line, i) =>
      add(group, "text", {x: node.width / 2, y: PAD_PX / 2 + LINE_PX * (i + 0.8), "text-anchor": "middle", class: i ? "small" : "strong"}, line));
  }
}

function showElided(root, elided) {
  if (!elided.length) return;
  const details = add(root, "details", {open: ""});
  add(details, "summary", {}, `Left out (${elided.length})`);
  const list = add(details, "ul", {class: "elided"});
  for (const each of elided) {
    const item = add(list, "li", {title: each.reason});
    add(item, "strong", {}, each.what);
    add(item, "span", {class: "soft"}, ` ${each.reason} (${each.optimization})`);
  }
}
