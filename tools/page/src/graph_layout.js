// SPDX-License-Identifier: MIT
// Places the nodes of a directed graph in layers. Loaded with the plan.
import dagre from "@dagrejs/dagre";

/// nodes: [{id, width, height}], which get x and y of their centres; edges: [[from, to]].
export function layout(nodes, edges) {
  const graph = new dagre.graphlib.Graph();
  graph.setGraph({rankdir: "TB", nodesep: 14, ranksep: 26, marginx: 6, marginy: 6});
  for (const {id, width, height} of nodes) graph.setNode(id, {width, height});
  for (const [from, to] of edges) graph.setEdge(from, to, {});
  dagre.layout(graph);
  for (const node of nodes) Object.assign(node, graph.node(node.id));
  const {width, height} = graph.graph();
  return {width, height, paths: edges.map(([from, to]) => graph.edge(from, to).points)};
}
