// SPDX-License-Identifier: MIT
// The smallest edits of a config's text that set a value or take it away. Comments and layout stay.
import {findNodeAtLocation, parseTree} from "jsonc-parser";

const OPTIONS = {allowTrailingComma: true};

/// The parsed text, or null where it is no JSON.
export function treeOf(text) {
  const errors = [];
  const tree = parseTree(text, errors, OPTIONS);
  return errors.length || tree?.type !== "object" ? null : tree;
}

export const nodeAt = (tree, path) => findNodeAtLocation(tree, path);

/// What a member says: the node of {"default": x}, or of the bare value, or undefined.
export function saidAt(tree, path) {
  const node = tree && nodeAt(tree, path);
  return node?.type === "object" ? nodeAt(node, ["default"]) : node;
}

export function literal(value) {
  if (Array.isArray(value)) return `[${value.map(literal).join(", ")}]`;
  if (value && typeof value === "object") {
    const members = Object.entries(value).map(([key, each]) => `${JSON.stringify(key)}: ${literal(each)}`);
    return members.length ? `{ ${members.join(", ")} }` : "{}";
  }
  return JSON.stringify(value);
}

/// Edits [{offset, length, content}] that make the param or feature at `path` have the value.
export function setEdits(text, path, value) {
  const tree = treeOf(text);
  if (!tree) return null;
  return place(text, tree, memberAt(tree, path), value, literal(value));
}
const memberAt = (tree, path) => nodeAt(tree, path)?.type === "object" ? [...path, "default"] : path;

/// Edits that make `path` say what the text `before` said of it, or nothing.
export function restoreEdits(text, before, path) {
  const tree = treeOf(text), old = before === null ? null : saidAt(treeOf(before), path);
  if (!tree) return null;
  if (old) {
    const raw = before.slice(old.offset, old.offset + old.length);
    return place(text, tree, memberAt(tree, path), JSON.parse(raw), raw);
  }
  let at = path, node = nodeAt(tree, path);
  if (node?.type === "object" && nodeAt(node, ["default"])) at = [...path, "default"], node = nodeAt(tree, at);
  if (!node) return [];
  while (at.length > 1 && node.parent.parent.children.length === 1) {
    const above = at.slice(0, -1);
    if (before !== null && nodeAt(treeOf(before), above)) break;
    at = above;
    node = nodeAt(tree, at);
  }
  return [removal(text, node.parent)];
}

function place(text, tree, path, value, content) {
  const node = nodeAt(tree, path);
  if (node) return [{offset: node.offset, length: node.length, content}];
  let depth = path.length - 1;
  while (depth > 0 && nodeAt(tree, path.slice(0, depth))?.type !== "object") --depth;
  const blocking = nodeAt(tree, path.slice(0, depth + 1));  // a null or a bare value is in the way
  const inner = path.slice(depth + 1).reduceRight((inside, key) => ({[key]: inside}), value);
  if (blocking) return [{offset: blocking.offset, length: blocking.length, content: literal(inner)}];
  return [insertion(text, depth ? nodeAt(tree, path.slice(0, depth)) : tree, path[depth], inner)];
}

function insertion(text, object, key, value) {
  const member = `${JSON.stringify(key)}: ${literal(value)}`, last = object.children.at(-1);
  if (!last) return {offset: object.offset, length: object.length, content: `{ ${member} }`};
  const end = last.offset + last.length, comma = commaAfter(text, end);
  const line = text.slice(0, last.offset).match(/\n([ \t]*)$/);
  const between = line ? "\n" + line[1] : " ";
  if (comma >= 0) return {offset: comma + 1, length: 0, content: between + member + ","};
  return {offset: end, length: 0, content: "," + between + member};
}

// The place of the comma that follows, behind blanks and comments; -1 for none.
function commaAfter(text, offset) {
  const rest = /^(?:\s|\/\/[^\n]*(?:\n|$)|\/\*[\s\S]*?\*\/)*,/.exec(text.slice(offset));
  return rest ? offset + rest[0].length - 1 : -1;
}

function removal(text, property) {
  const all = property.parent.children, i = all.indexOf(property);
  const end = property.offset + property.length, comma = commaAfter(text, end);
  if (i > 0) {
    const from = all[i - 1].offset + all[i - 1].length;
    return {offset: from, length: end - from, content: ""};
  }
  if (all.length > 1)
    return {offset: property.offset, length: all[1].offset - property.offset, content: ""};
  const from = property.parent.offset + 1;
  return {offset: from, length: Math.max(end, comma + 1) - from, content: ""};
}
