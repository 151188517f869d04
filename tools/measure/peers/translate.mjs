// SPDX-License-Identifier: MIT
// Turns a fragment shader of three.js's GLSL into one of ours: #version 300 es, uniforms of a camera by our names,
// others as params with the values that the library gave them, so that a compiler knows no more of them than it does
// there. Arrays are constants, since params have none.

const HEADER = `#version 300 es
precision highp float;
precision highp int;
precision highp sampler2D;
#define varying in
#define texture2D texture
#define texture2DLodEXT textureLod
#define gl_FragColor peer_color
layout(location = 0) out vec4 peer_color;
uniform mat4 clip_from_view;
uniform mat4 view_from_window;
uniform vec2 viewport_size;
uniform float radius;
// Clip space is twice the window less one.
mat4 peerInverseProjection()
{
    mat4 m = view_from_window;
    return mat4(0.5 * m[0], 0.5 * m[1], 0.5 * m[2], m[3] + 0.5 * (m[0] + m[1] + m[2]));
}
`;

// Names under which three.js's own passes and n8ao have what a camera says.
const CAMERA = {
  projMat: "clip_from_view",
  cameraProjectionMatrix: "clip_from_view",
  projectionMatrix: "clip_from_view",
  projectionMatrixInv: "peerInverseProjection()",
  cameraProjectionMatrixInverse: "peerInverseProjection()",
  cameraInverseProjectionMatrix: "peerInverseProjection()",
  inverseProjectionMatrix: "peerInverseProjection()",
  resolution: "viewport_size",
  near: "(clip_from_view[3][2] / (clip_from_view[2][2] - 1.0))",
  far: "(clip_from_view[3][2] / (clip_from_view[2][2] + 1.0))"
};
CAMERA.cameraNear = CAMERA.near;
CAMERA.cameraFar = CAMERA.far;

function literal(type, value) {
  if (type === "float") return Number.isInteger(value) ? value.toFixed(1) : String(value);
  if (type === "int") return String(value);
  if (type === "bool") return String(Boolean(value));
  if (/^vec[234]$/.test(type)) return `${type}(${value.toArray().map(x => literal("float", x)).join(", ")})`;
  if (/^mat[234]$/.test(type)) return `${type}(1.0)`;  // that no effect of ours reads: where the camera is
  throw new Error(`a uniform of type ${type} has no value here`);
}

// A uniform under the name of a param: names of several passes are their own, and a bool is a number.
function paramFor(type, name, value, prefix, params) {
  const param = `${prefix}_${name.replace(/[A-Z]/g, letter => "_" + letter.toLowerCase())}`;
  const gl_type = type === "bool" ? "float" : type;
  params[param] = {
    ...(gl_type === "float" ? {} : {type: gl_type}),
    default: typeof value === "object" ? value.toArray() : Number(value)
  };
  return `uniform ${gl_type} ${param};\n#define ${name} ${type === "bool" ? `(${param} > 0.5)` : param}`;
}

function included(source, chunks) {
  return source.replace(/^[ \t]*#include <(\w+)>/gm, (_, name) => {
    if (chunks[name] === undefined) throw new Error(`there is no shader chunk '${name}'`);
    return included(chunks[name], chunks);
  });
}

// `material` as three.js has it. `bind`: `samplers` (uniform to target), `values` and `expressions` by uniform,
// `rename` of words in the text, and `replace`, a list of [text, text]. `made` collects the `inputs` and `params` of the
// text; names of params begin with `prefix`.
export function translate(material, chunks, bind, prefix, made) {
  let text = included(material.fragmentShader, chunks);
  for (const [from, to] of bind.replace || []) {
    if (!text.includes(from)) throw new Error(`the shader no longer has '${from}'`);
    text = text.replaceAll(from, to);
  }
  for (const [from, to] of Object.entries(bind.rename || {})) text = text.replace(new RegExp(`\\b${from}\\b`, "g"), to);
  text = text.replace(/\buniform\b[^;]*;/g, "\n$&\n");  // what becomes a #define needs a line
  text = text.replace(/\baverage\b/g, "peer_average");  // an extension's function that glslang knows
  const expressions = {...CAMERA, ...bind.expressions};
  text = text.replace(
    /\buniform\s+(?:(?:highp|mediump|lowp)\s+)?(\w+)(\[[^\]]+\])?\s+(\w+)(\[[^\]]+\])?\s*;/g,
    (_, type, before, name, after) => {
      // What nothing reads is left out: a macro `r` would spoil swizzles.
      if (text.match(new RegExp(`(?<![.\\w])${name}\\b`, "g")).length === 1) return "";
      if (type === "sampler2D") {
        const from = bind.samplers[name];
        if (!from) throw new Error(`nothing is bound to the sampler '${name}'`);
        made.inputs[name] = from;
        return `uniform highp sampler2D ${name};`;
      }
      const old = Object.entries(bind.rename || {}).find(([, to]) => to === name);
      const value = (bind.values || {})[name] ?? material.uniforms[old ? old[0] : name]?.value;
      if (expressions[name] && (bind.values || {})[name] === undefined)
        return expressions[name] === name ? "" : `#define ${name} ${expressions[name]}`;
      const size = before || after || "";
      if (!size) return /^mat/.test(type) ? `const ${type} ${name} = ${literal(type, value)};` :
                                            paramFor(type, name, value, prefix, made.params);
      return `const ${type} ${name}${size} = ${type}${size}(${value.map(each => literal(type, each)).join(", ")});`;
    });
  const defines = Object.entries(material.defines || {}).map(([name, value]) => `#define ${name} ${value}\n`).join("");
  return HEADER + defines + text;
}
