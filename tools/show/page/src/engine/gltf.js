// SPDX-License-Identifier: MIT
// A .glb as a scene of the engine, as `crevice` itself reads one: triangles, base colours, alpha tests, normal and
// occlusion maps, cameras and lights; skins and animations stand still.
import {Primitive, WebIO} from '@gltf-transform/core';
import {
  EXTMeshoptCompression, EXTTextureWebP, KHRLightsPunctual, KHRMaterialsUnlit, KHRMeshQuantization, KHRTextureTransform
} from '@gltf-transform/extensions';
import {MeshoptDecoder} from 'meshoptimizer';

const EXTENSIONS = [
  EXTMeshoptCompression, EXTTextureWebP, KHRLightsPunctual, KHRMaterialsUnlit, KHRMeshQuantization, KHRTextureTransform
];
const {TRIANGLES, TRIANGLE_STRIP, TRIANGLE_FAN} = Primitive.Mode;

/// Puts the scene of a .glb in the place of the engine's. -> Answer
export async function loadGltf(engine, bytes, name) {
  try {
    await MeshoptDecoder.ready;
    const io = new WebIO().registerExtensions(EXTENSIONS).registerDependencies({'meshopt.decoder': MeshoptDecoder});
    const model = new Model(name);
    await model.read(await io.readBinary(bytes));
    return engine.loadModel(model.scene, model.bytes());
  } catch (error) {
    const message = `the scene '${name}' cannot be read: ${error.message}; export it without Draco compression or KTX textures`;
    return {ok: false, diagnostics: [{code: 'CV7002', severity: 'error', message}]};
  }
}

// A scene as engine/model.cpp reads it: JSON, in which arrays are numbers of bytes, at which they begin.
class Model {
  constructor(name) {
    this.scene = {name, textures: [], materials: [], meshes: [], instances: [], cameras: [], lights: []};
    this.arrays = [];
    this.size = 0;
    this.known = new Map();   // the index of each primitive, material and texture that was read
    this.colors = new Map();  // ... and of textures as sRGB
  }

  put(array) {
    const at = this.size;
    this.arrays.push([at, array]);
    this.size += Math.ceil(array.byteLength / 8) * 8;
    return at;
  }
  bytes() {
    const bytes = new Uint8Array(this.size);
    for (const [at, array] of this.arrays) bytes.set(new Uint8Array(array.buffer, array.byteOffset, array.byteLength), at);
    return bytes;
  }
  // The index in a list of what is made of a thing; -1 where that is null.
  async once(known, list, thing, make) {
    if (known.has(thing)) return known.get(thing);
    const made = await make(thing), index = made ? this.scene[list].push(made) - 1 : -1;
    known.set(thing, index);
    return index;
  }

  async read(document) {
    const root = document.getRoot(), scene = root.getDefaultScene() || root.listScenes()[0];
    if (!scene) throw new Error('it holds no scene');
    const nodes = [];
    scene.traverse(node => nodes.push(node));
    for (const node of nodes) await this.addNode(node);
  }

  async addNode(node) {
    const {instances, cameras, lights} = this.scene, matrix = node.getWorldMatrix();
    for (const primitive of node.getMesh()?.listPrimitives() ?? []) {
      const mesh = await this.once(this.known, 'meshes', primitive, () => this.meshOf(primitive));
      if (mesh < 0) continue;
      const material = await this.once(this.known, 'materials', primitive.getMaterial(), each => this.materialOf(each));
      instances.push({mesh, material, world_from_model: this.put(new Float64Array(matrix))});
    }
    if (node.getCamera()) cameras.push(cameraOf(node.getCamera(), matrix));
    const light = node.getExtension('KHR_lights_punctual');
    if (light) lights.push(lightOf(light, matrix));
  }

  meshOf(primitive) {
    const positions = primitive.getAttribute('POSITION'), normals = primitive.getAttribute('NORMAL'),
          uv = primitive.getAttribute('TEXCOORD_0');
    const indices = positions && trianglesOf(primitive, positions.getCount());
    if (!indices || indices.length === 0) return null;
    const vertices = new Float32Array(positions.getCount() * 8), element = [];
    for (let i = 0; i < positions.getCount(); ++i) {
      vertices.set(positions.getElement(i, element).slice(0, 3), i * 8);
      if (normals) vertices.set(normals.getElement(i, element).slice(0, 3), i * 8 + 3);
      if (!uv) continue;
      const [u, v] = uv.getElement(i, element);
      vertices.set([u, 1 - v], i * 8 + 6);  // v upwards
    }
    const finite = indices.every(index => index < positions.getCount()) && vertices.every(Number.isFinite);
    if (!finite) throw new Error('a mesh has vertices that are not finite, or indices past its vertices');
    return {
      name: primitive.getName(), has_normals: normals !== null,
      vertices: this.put(vertices), vertex_count: positions.getCount(),
      indices: this.put(new Uint32Array(indices)), index_count: indices.length
    };
  }

  async materialOf(material) {
    if (!material) return {name: '', base_color: [0.8, 0.8, 0.8, 1]};
    return {
      name: material.getName(),
      base_color: material.getBaseColorFactor(),
      base_color_texture: await this.textureOf(material.getBaseColorTexture(), true),
      alpha_cutoff: material.getAlphaMode() === 'MASK' ? material.getAlphaCutoff() : 0,
      normal_texture: await this.textureOf(material.getNormalTexture(), false),
      normal_scale: material.getNormalScale(),
      occlusion_texture: await this.textureOf(material.getOcclusionTexture(), false),
      occlusion_strength: material.getOcclusionStrength()
    };
  }

  async textureOf(texture, srgb) {
    if (!texture?.getImage()) return -1;
    return this.once(srgb ? this.colors : this.known, 'textures', texture, async () => {
      const pixels = await decode(texture);
      return pixels && {...pixels, name: texture.getName(), srgb, rows: this.put(pixels.rows)};
    });
  }
}

// Texels, lowest row first; null where the browser cannot read them.
async function decode(texture) {
  const blob = new Blob([texture.getImage()], {type: texture.getMimeType()});
  const options = {colorSpaceConversion: 'none', premultiplyAlpha: 'none', imageOrientation: 'flipY'};
  const bitmap = await createImageBitmap(blob, options).catch(() => null);
  if (!bitmap) return null;
  const {width, height} = bitmap;
  const context = new OffscreenCanvas(width, height).getContext('2d', {willReadFrequently: true});
  context.drawImage(bitmap, 0, 0);
  return {width, height, rows: new Uint8Array(context.getImageData(0, 0, width, height).data.buffer)};
}

function trianglesOf(primitive, count) {
  const accessor = primitive.getIndices();
  const index = accessor ? i => accessor.getScalar(i) : i => i;
  const length = accessor ? accessor.getCount() : count, list = [];
  switch (primitive.getMode()) {
    case TRIANGLES:
      for (let i = 0; i + 2 < length; i += 3) list.push(index(i), index(i + 1), index(i + 2));
      return list;
    case TRIANGLE_STRIP:
      for (let i = 0; i + 2 < length; ++i) list.push(index(i), index(i + 1 + i % 2), index(i + 2 - i % 2));
      return list;
    case TRIANGLE_FAN:
      for (let i = 1; i + 1 < length; ++i) list.push(index(0), index(i), index(i + 1));
      return list;
    default:
      return null;  // points and lines occlude nothing
  }
}

const column = (matrix, k) => [0, 1, 2].map(row => matrix[4 * k + row]);
const unit = v => v.map(x => x / (Math.hypot(...v) || 1));

function cameraOf(camera, matrix) {
  const orthographic = camera.getType() === 'orthographic';
  return {
    name: camera.getName(),
    eye: column(matrix, 3),
    back: unit(column(matrix, 2)),
    up: unit(column(matrix, 1)),
    ...(orthographic ? {half_height: camera.getYMag()} : {fov_y_rad: camera.getYFov()})
  };
}

function lightOf(light, matrix) {
  const strongest = Math.max(...light.getColor(), 1e-6);
  return {
    name: light.getName(),
    type: light.getType(),
    position: column(matrix, 3),
    direction: unit(column(matrix, 2)).map(x => -x),
    color: light.getColor().map(x => x / strongest),
    intensity: light.getIntensity(),
    inner: light.getInnerConeAngle(),
    outer: light.getOuterConeAngle()
  };
}
