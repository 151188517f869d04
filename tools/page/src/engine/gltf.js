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

const broken = (name, reason) => ({
  ok: false,
  diagnostics: [{
    code: 'CV7002',
    severity: 'error',
    message: `the scene '${name}' cannot be read: ${reason}`,
    help: 'export it as a .glb without Draco compression or KTX textures',
    file: '', line: 0, column: 0, length: 0, pointer: '', notes: []
  }]
});

/// Puts the scene of a .glb in the place of the engine's. -> Answer
export async function loadGltf(engine, bytes, name) {
  let document;
  try {
    await MeshoptDecoder.ready;
    const io = new WebIO().registerExtensions(EXTENSIONS).registerDependencies({'meshopt.decoder': MeshoptDecoder});
    document = await io.readBinary(bytes);
    return await new Builder(engine, name).build(document);
  } catch (error) {
    return broken(name, error.message);
  }
}

class Builder {
  constructor(engine, name) {
    this.engine = engine;
    const m = engine.module, n = 'number', s = 'string';
    this.begin = () => m.cwrap('page_build_begin', null, [s])(name);
    this.addTexture = m.cwrap('page_build_texture', n, [s, n, n, n, n]);
    this.addMaterial = m.cwrap('page_build_material', null, [s]);
    this.addMesh = m.cwrap('page_build_mesh', n, [s, n, n, n, n, n]);
    this.addInstance = m.cwrap('page_build_instance', null, [n, n, n]);
    this.addCamera = m.cwrap('page_build_camera', null, [s]);
    this.addLight = m.cwrap('page_build_light', null, [s]);
    this.end = m.cwrap('page_build_end', s, []);
    this.textures = new Map();
    this.materials = new Map();
    this.meshes = new Map();
  }

  async build(document) {
    const root = document.getRoot();
    const scene = root.getDefaultScene() || root.listScenes()[0];
    if (!scene) throw new Error('it holds no scene');
    const nodes = [];
    scene.traverse(node => nodes.push(node));
    const images = await decodeTextures(nodes);
    this.begin();
    for (const node of nodes) this.addNode(node, images);
    return JSON.parse(this.end());
  }

  addNode(node, images) {
    const matrix = node.getWorldMatrix();
    for (const primitive of node.getMesh()?.listPrimitives() ?? []) {
      const mesh = this.meshOf(primitive);
      if (mesh < 0) continue;
      const material = this.materialOf(primitive.getMaterial(), images);
      this.engine.withFloats(new Float64Array(matrix), at => this.addInstance(mesh, material, at));
    }
    if (node.getCamera()) this.addCamera(JSON.stringify(cameraOf(node.getCamera(), matrix)));
    const light = node.getExtension('KHR_lights_punctual');
    if (light) this.addLight(JSON.stringify(lightOf(light, matrix)));
  }

  meshOf(primitive) {
    if (!this.meshes.has(primitive)) this.meshes.set(primitive, this.upload(primitive));
    return this.meshes.get(primitive);
  }

  upload(primitive) {
    const positions = primitive.getAttribute('POSITION'), normals = primitive.getAttribute('NORMAL'),
          uv = primitive.getAttribute('TEXCOORD_0');
    const indices = positions && trianglesOf(primitive, positions.getCount());
    if (!indices || indices.length === 0) return -1;
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
    const list = new Uint32Array(indices);
    return this.engine.withFloats(vertices,
      at => this.engine.withFloats(list,
        from => this.addMesh(primitive.getName(), at, positions.getCount(), from, list.length, normals ? 1 : 0)));
  }

  materialOf(material, images) {
    if (!this.materials.has(material)) {
      this.addMaterial(JSON.stringify(this.materialJson(material, images)));
      this.materials.set(material, this.materials.size);
    }
    return this.materials.get(material);
  }

  materialJson(material, images) {
    if (!material) return {name: '', base_color: [0.8, 0.8, 0.8, 1]};
    const texture = (from, srgb) => this.textureOf(from, images, srgb);
    return {
      name: material.getName(),
      base_color: material.getBaseColorFactor(),
      base_color_texture: texture(material.getBaseColorTexture(), true),
      alpha_cutoff: material.getAlphaMode() === 'MASK' ? material.getAlphaCutoff() : 0,
      normal_texture: texture(material.getNormalTexture(), false),
      normal_scale: material.getNormalScale(),
      occlusion_texture: texture(material.getOcclusionTexture(), false),
      occlusion_strength: material.getOcclusionStrength()
    };
  }

  textureOf(texture, images, srgb) {
    const pixels = images.get(texture);
    if (!pixels) return -1;
    const key = texture.getName() + texture.getURI() + [...images.keys()].indexOf(texture) + srgb;
    if (!this.textures.has(key)) {
      const at = bytes => this.addTexture(texture.getName(), pixels.width, pixels.height, bytes, srgb ? 1 : 0);
      this.textures.set(key, this.engine.withBytes(pixels.rows, at));
    }
    return this.textures.get(key);
  }
}

/// Texels of all textures that are used, lowest row first; without those that the browser cannot read.
async function decodeTextures(nodes) {
  const images = new Map();
  for (const node of nodes)
    for (const primitive of node.getMesh()?.listPrimitives() ?? []) {
      const material = primitive.getMaterial();
      const used = material ?
        [material.getBaseColorTexture(), material.getNormalTexture(), material.getOcclusionTexture()] : [];
      for (const texture of used)
        if (texture?.getImage() && !images.has(texture)) images.set(texture, await decode(texture));
    }
  return images;
}

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
