// SPDX-License-Identifier: MIT
// What a JSON Schema (draft 7) says of a place in a document: its keys, its words, what they mean.
import {getLocation} from "jsonc-parser";

/// All schemas that hold at a path; alternatives count as several.
export function schemasAt(schema, path) {
  let now = expand(schema, schema);
  for (const step of path) now = now.flatMap(each => below(schema, each, step));
  return now;
}

function expand(root, schema, depth = 0) {
  if (!schema || typeof schema !== "object" || depth > 16) return [];
  const parts = [schema];
  if (schema.$ref) parts.push(resolve(root, schema.$ref));
  const more = [...schema.anyOf ?? [], ...schema.oneOf ?? [], ...schema.allOf ?? []];
  const inside = [...parts.slice(1), ...more].flatMap(each => expand(root, each, depth + 1));
  return [schema, ...inside];
}
function resolve(root, ref) {
  return ref.replace(/^#\/?/, "").split("/").filter(Boolean)
    .reduce((node, key) => node?.[key.replaceAll("~1", "/").replaceAll("~0", "~")], root);
}
function below(root, schema, step) {
  if (typeof step === "number") {
    const items = Array.isArray(schema.items) ? schema.items[step] : schema.items;
    return expand(root, items);
  }
  if (schema.properties && Object.hasOwn(schema.properties, step)) return expand(root, schema.properties[step]);
  const pattern = Object.entries(schema.patternProperties ?? {}).find(([key, value]) =>
    new RegExp(key, "u").test(step) && Object.keys(value).length);
  return expand(root, pattern ? pattern[1] : schema.additionalProperties);
}

const description = schemas => schemas.find(s => s.description)?.description ?? "";

/// [{label, detail, info, type}] of keys that an object at the path may have.
export function keysAt(schema, path) {
  const keys = new Map();
  for (const each of schemasAt(schema, path)) {
    for (const [label, value] of Object.entries(each.properties ?? {}))
      if (!keys.has(label)) keys.set(label, {label, info: description(expand(schema, value)), type: "property"});
    for (const label of each.propertyNames?.enum ?? [])
      if (!keys.has(label)) keys.set(label, {label, type: "property"});
  }
  return [...keys.values()];
}

/// The same of values: words, and true, false, null where they may stand.
export function valuesAt(schema, path) {
  const values = new Map(), put = (value, info) => {
    const label = JSON.stringify(value);
    if (!values.has(label)) values.set(label, {label, info: info ?? "", type: typeof value === "string" ? "text" : "keyword"});
  };
  for (const each of schemasAt(schema, path)) {
    (each.enum ?? []).forEach((value, i) => value !== null && put(value, each.enumDescriptions?.[i]));
    if ("const" in each) put(each.const, each.description);
    if ([each.type].flat().includes("boolean")) put(true), put(false);
  }
  return [...values.values()];
}

/// What the key or value under the offset means: {title, text}, or null.
export function meaningAt(schema, text, offset) {
  const {path, previousNode} = getLocation(text, offset);
  if (!path.length) return null;
  const found = schemasAt(schema, path), words = [];
  for (const each of found) {
    const at = previousNode ? (each.enum ?? []).indexOf(previousNode.value) : -1;
    if (at >= 0 && each.enumDescriptions?.[at]) words.push(each.enumDescriptions[at]);
  }
  const said = words[0] ?? description(found), range = rangeText(found);
  const initial = found.find(s => "default" in s);
  const rest = [range, initial ? `default ${JSON.stringify(initial.default)}` : ""].filter(Boolean).join(", ");
  return said || rest ? {title: path.join(" / "), text: [said, rest].filter(Boolean).join("\n")} : null;
}
function rangeText(schemas) {
  const found = schemas.find(s => Math.abs(s.minimum ?? 1e30) < 1e29 || Math.abs(s.maximum ?? 1e30) < 1e29);
  return found ? `[${found.minimum ?? ""}, ${found.maximum ?? ""}]` : "";
}

/// Completion at an offset: {from, to, options, wantsColon}, or null.
export function completionAt(schema, text, offset) {
  const location = getLocation(text, offset), {path, previousNode, isAtPropertyKey} = location;
  const inside = previousNode && offset > previousNode.offset && offset <= previousNode.offset + previousNode.length;
  const from = inside ? previousNode.offset : offset - /[\w"\/.-]*$/.exec(text.slice(0, offset))[0].length;
  const to = inside ? previousNode.offset + previousNode.length : offset;
  if (!isAtPropertyKey) return {from, to, options: valuesAt(schema, path), key: false};
  const options = keysAt(schema, path.slice(0, -1));
  return {from, to, options: options.map(o => ({...o, label: JSON.stringify(o.label)})), key: true};
}
