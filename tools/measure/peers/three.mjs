// SPDX-License-Identifier: MIT
// three.js's GTAOPass with its denoiser, SSAOPass and SAOPass with their blurs, and postprocessing's SSAOEffect, as they set
// them up.
import {Config} from "./config.mjs";

export function makeThree(folder, lib) {
  return [makeGtao(folder, lib), makeSsao(folder, lib), makeSao(folder, lib)];
}

const stage = three => [new three.Scene(), new three.PerspectiveCamera()];
const SURFACE = {tNormal: "normal", tDepth: "depth"};
// They have normals as colours; ours are already what they unpack.
const NORMAL = ["unpackRGBToNormal( texture2D( tNormal, screenPosition ).xyz )", "texture2D( tNormal, screenPosition ).xyz"];

function makeGtao(folder, lib) {
  const pass = new lib.GTAOPass(...stage(lib.three), 64, 64);
  const config = new Config(folder, "three_gtao", `three.js r${lib.three.REVISION}, GTAOPass.`, "geometry/depth_normal",
    lib.chunks);
  config.target("raw", "rgba16f");
  config.target("ao", "r8");
  config.pass("occlusion", pass.gtaoMaterial, ["raw"], {
    samplers: {...SURFACE, tNoise: config.noise("three_gtao_noise", pass.gtaoNoiseTexture)},
    expressions: {radius: "radius", cameraWorldMatrix: "mat4(1.0)"}
  }, {clear: {raw: 1}});
  config.pass("denoise", pass.pdMaterial, ["ao"], {
    samplers: {
      ...SURFACE, tDiffuse: {from: "raw", filter: "linear"},
      tNoise: config.noise("three_denoise_noise", pass.pdNoiseTexture)
    },
    rename: {radius: "denoise_radius"}
  }, {clear: {ao: 1}});
  config.write();
  return "three_gtao";
}

// A noise of floats from -1 to 1, in one channel.
function bytesOf({image: {width, height, data}}) {
  const bytes = new Uint8Array(4 * data.length);
  data.forEach((value, i) => bytes.fill(Math.round(127.5 * (value + 1)), 4 * i, 4 * i + 4));
  return {image: {width, height, data: bytes}};
}

function makeSsao(folder, lib) {
  const pass = new lib.SSAOPass(...stage(lib.three), 64, 64);
  const config = new Config(folder, "three_ssao", `three.js r${lib.three.REVISION}, SSAOPass.`, "geometry/depth_normal",
    lib.chunks);
  config.target("raw", "r8");
  config.target("ao", "r8");
  config.pass("occlusion", pass.ssaoMaterial, ["raw"], {
    samplers: {...SURFACE, tNoise: config.noise("three_ssao_noise", bytesOf(pass.noiseTexture))},
    replace: [NORMAL, ["texture2D( tNoise, vUv * noiseScale ).r", "2.0 * texture2D( tNoise, vUv * noiseScale ).r - 1.0"]],
    expressions: {kernelRadius: "radius"},
    values: {minDistance: pass.minDistance, maxDistance: pass.maxDistance}
  });
  config.pass("blur", pass.blurMaterial, ["ao"], {samplers: {tDiffuse: {from: "raw", filter: "linear"}}});
  config.write();
  return "three_ssao";
}

// Its reach is in pixels, whatever the radius.
function makeSao(folder, lib) {
  const pass = new lib.SAOPass(...stage(lib.three)), {params} = pass;
  const config = new Config(folder, "three_sao", `three.js r${lib.three.REVISION}, SAOPass.`, "geometry/depth_normal",
    lib.chunks);
  const names = ["raw", "across", "ao"].map(name => config.target(name, "r8"));
  config.pass("occlusion", pass.saoMaterial, ["raw"], {
    samplers: SURFACE,
    replace: [NORMAL, ["uniform sampler2D tDiffuse;", ""],
      ["float scaleDividedByCameraFar;", "#define pow2(x) ((x) * (x))\nfloat scaleDividedByCameraFar;"],
      ["vec2 radius =", "vec2 reach ="], ["* radius;", "* reach;"], ["radius += radiusStep", "reach += radiusStep"],
      ["radiusStep = radius", "radiusStep = reach"]],
    expressions: {size: "viewport_size"},
    values: {
      bias: params.saoBias, intensity: params.saoIntensity, scale: params.saoScale, kernelRadius: params.saoKernelRadius,
      minResolution: params.saoMinResolution
    }
  }, {clear: {raw: 1}});
  [pass.vBlurMaterial, pass.hBlurMaterial].forEach((material, i) => {
    lib.BlurShaderUtils.configure(material, params.saoBlurRadius, params.saoBlurStdDev, new lib.three.Vector2(i, 1 - i));
    config.pass(`blur_${i}`, material, [names[i + 1]], {
      samplers: {tDepth: "depth", tDiffuse: {from: names[i], filter: "linear"}},
      replace: [["varying vec2 vInvSize;", ""], ["vInvSize", "(1.0 / viewport_size)"]],
      expressions: {depthCutoff: `(${params.saoBlurDepthCutoff} * (cameraFar - cameraNear))`}
    }, {clear: {[names[i + 1]]: 1}});
  });
  config.write();
  return "three_sao";
}

// Its reach is in pixels, too; what lies further away in depth than the radius fades out. The effect shows one less its ao.
export function makePostprocessing(folder, {three, chunks, version, SSAOEffect}) {
  const material = new SSAOEffect(new three.PerspectiveCamera(), new three.Texture()).ssaoPass.fullscreenMaterial;
  const config = new Config(folder, "postprocessing_ssao", `postprocessing ${version}, SSAOEffect.`, "geometry/depth_normal", chunks);
  const reach = `(${material.radius} * viewport_size.y)`;
  Object.assign(material.defines, {RADIUS: reach, RADIUS_SQ: `(${reach} * ${reach})`});
  config.target("ao", "r8");
  config.pass("occlusion", material, ["ao"], {
    samplers: {
      depthBuffer: "depth", normalBuffer: "normal",
      noiseTexture: config.noise("postprocessing_noise", material.uniforms.noiseTexture.value)
    },
    replace: [
      ["unpackRGBToNormal(normalDepth.rgb)", "normalDepth.rgb"], ["gl_FragColor.r=ao;", "gl_FragColor.r=1.0-clamp(ao,0.0,1.0);"],
      ["uniform vec2 cameraNearFar;\n#define cameraNear cameraNearFar.x\n#define cameraFar cameraNearFar.y",
        "uniform float cameraNear;uniform float cameraFar;"],
      ["uniform highp sampler2D normalDepthBuffer;", ""], ["uniform mediump sampler2D normalDepthBuffer;", ""],
      ["varying vec2 vUv2;", ""], ["vUv2", "(vUv * viewport_size / 64.0)"]
    ],
    expressions: {texelSize: "(1.0 / viewport_size)", proximityCutoff: "(vec2(radius, 1.5 * radius) / (cameraFar - cameraNear))"}
  });
  config.write();
  return "postprocessing_ssao";
}
