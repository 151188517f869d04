// SPDX-License-Identifier: MIT
// Places the nodes of a directed graph in layers. Loaded with the plan.
import dagre from "@dagrejs/dagre";

const MARGIN = 6;  // pixels

/// nodes: [{id, width, height}], which get x and y of their centres; edges: [[from, to]].
export function layout(nodes, edges) {
  const graph = new dagre.graphlib.Graph();
  graph.setGraph({rankdir: "TB", nodesep: 14, ranksep: 26, marginx: MARGIN, marginy: MARGIN});
  for (const {id, width, height} of nodes) graph.setNode(id, {width, height});
  for (const [from, to] of edges) graph.setEdge(from, to, {});
  dagre.layout(graph);
  for (const node of nodes) Object.assign(node, graph.node(node.id));
  const paths = edges.map(([from, to]) => graph.edge(from, to).points), points = paths.flat();
  const xs = [...points.map(p => p.x), ...nodes.flatMap(n => [n.x - n.width / 2, n.x + n.width / 2])];
  const ys = nodes.map(n => n.y + n.height / 2), left = Math.min(...xs) - MARGIN;
  return {left, width: Math.max(...xs) + MARGIN - left, height: Math.max(...ys) + MARGIN, paths};
}
