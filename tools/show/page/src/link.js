// SPDX-License-Identifier: MIT
// All that the page shows, as a link: the part after "#" is base64url of deflated JSON, or plain "config=NAME&...".

async function through(stream, bytes) {
  return new Uint8Array(await new Response(new Blob([bytes]).stream().pipeThrough(stream)).arrayBuffer());
}

export async function pack(object) {
  const bytes = await through(new CompressionStream("deflate-raw"), new TextEncoder().encode(JSON.stringify(object)));
  let text = "";
  for (let i = 0; i < bytes.length; i += 0x8000) text += String.fromCharCode(...bytes.subarray(i, i + 0x8000));
  return btoa(text).replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "");
}
export async function unpack(text) {
  const bytes = Uint8Array.from(atob(text.replaceAll("-", "+").replaceAll("_", "/")), c => c.charCodeAt(0));
  return JSON.parse(new TextDecoder().decode(await through(new DecompressionStream("deflate-raw"), bytes)));
}

export async function shareLink(app) {
  const {engine} = app, used = [app.a.config, app.b.config].map(config => app.path(config));
  const files = Object.fromEntries(engine.editedPaths()
    .filter(path => engine.shippedSource(path) !== null || used.includes(path) || !path.startsWith("configs/"))
    .map(path => [path, engine.source(path)]));
  for (const path of used)
    if (engine.shippedSource(path) === null && engine.source(path) !== null) files[path] = engine.source(path);
  return "#" + await pack({
    config: app.a.config, variant: app.a.variant, files, scene: app.builtin, camera: app.camera,
    size: app.sizeChoice, show: app.a.show, split: {...app.split, ...app.b}
  });
}

const text = (value, otherwise) => typeof value === "string" ? value : otherwise;

/// What a link asks for, with only what is known and of the right type; null for none.
/// Throws a sentence where it cannot be read.
export async function readLink(hash) {
  const body = hash.replace(/^#/, "");
  if (!body) return null;
  if (/^[a-z]+=/.test(body)) return checked(Object.fromEntries(new URLSearchParams(body)));
  try {
    return checked(await unpack(body));
  } catch {
    throw new Error("This link is damaged: what it held cannot be read. Here is the page as it ships.");
  }
}

function checked(said) {
  if (!said || typeof said !== "object") throw new Error();
  const files = Object.entries(said.files ?? {}).filter(([path, body]) =>
    typeof body === "string" && /^[\w./-]+$/.test(path) && !path.includes(".."));
  const split = said.split && typeof said.split === "object" ? said.split : {};
  return {
    config: text(said.config, null), variant: text(said.variant, ""), files: Object.fromEntries(files),
    scene: text(said.scene, null), camera: text(said.camera, ""), size: text(said.size, null),
    show: text(said.show, null),
    split: {
      on: split.on === true, at: Number.isFinite(split.at) ? split.at : 0.5, config: text(split.config, ""),
      variant: text(split.variant, ""), show: text(split.show, "without")
    }
  };
}
