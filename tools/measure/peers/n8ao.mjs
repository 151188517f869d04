// SPDX-License-Identifier: MIT
// n8ao's passes, as N8AOPass sets them up in each of its modes.
import {Config} from "./config.mjs";

const MODES = ["Performance", "Low", "Medium", "High", "Ultra", "Neural-Performance", "Neural-Low", "Neural-Medium",
  "Neural-High"];

// The levels of its depth atlas (src/DepthMipAtlas.js): it sets them once a size, we find them where they are read.
function levelsOf(count, base) {
  const lines = [`ivec2 s = max(${base} / 2, 1);`, "float x = 0.0, y = float(s.y);", "levels[0] = vec4(0.0, 0.0, s);"];
  for (let level = 1; level < count; ++level)
    lines.push("s = max(s / 2, 1);", `levels[${level}] = vec4(x, y, s);`, "x += float(s.x);");
  return `void main() {\n    vec4 levels[${count}];\n    { ${lines.join(" ")} }\n`;
}

function addMips(config, lib, depth, scale) {
  const count = lib.DEPTH_MIP_LEVELS, base = "textureSize(sceneDepth, 0)";
  config.target("mips", "r32f", 0.75 * scale);
  config.pass("mips", lib.atlasMaterial, ["mips"], {
    samplers: {sceneDepth: depth},
    replace: [
      ["uniform vec4 levels[DEPTH_MIP_LEVELS];", ""], ["uniform vec2 baseSize;", ""],
      ["ivec2(baseSize)", base],
      // The target is wider than the atlas.
      ["void main() {", levelsOf(count, base) + "if (gl_FragCoord.x > levels[0].z) { peer_color = vec4(0.0); return; }"]
    ]
  });
}

function addDenoise(config, pass, half, depth, noise) {
  const neural = pass.configuration.neuralDenoise;
  for (let index = 0; index < pass.configuration.denoiseIterations; ++index) {
    config.target(`denoised_${index}`, "rgba8", half ? 0.5 : 1);
    const learned = neural && index === 1 ? pass.neuralDenoiseMaterial : pass.standardDenoiseMaterial;
    config.pass(`denoise_${index}`, learned, [`denoised_${index}`], {
      // What a shader of GLSL 3 writes to, our header has.
      replace: neural && index === 1 ?
        [["layout(location = 0) out highp vec4 neuralFragColor;", ""], ["#define gl_FragColor neuralFragColor", ""]] : [],
      samplers: {
        tDiffuse: {from: index ? `denoised_${index - 1}` : "raw", filter: "linear"}, sceneDepth: depth,
        blueNoise: noise, sceneDiffuse: depth
      },
      rename: {radius: "denoise_radius"},
      expressions: {worldRadius: "radius"},
      values: {
        denoise_radius: pass.configuration.denoiseRadius * (half && !neural ? 0.5 : 1), index, poissonDisk: pass.samplesDenoise,
        distanceFalloff: pass.configuration.distanceFalloff
      }
    });
  }
  return `denoised_${pass.configuration.denoiseIterations - 1}`;
}

function addComposition(config, pass, half, denoised) {
  config.target("ao", "r8");
  const learned = half && pass.configuration.neuralDenoise;
  config.pass("compose", learned ? pass.neuralCompositerMaterial : pass.standardCompositerMaterial, ["ao"], {
    samplers: {
      tDiffuse: {from: denoised, filter: "linear"}, sceneDepth: "depth",
      downsampledDepth: half ? "half_depth" : "depth", sceneDiffuse: "depth", blueNoise: "depth", transparencyDWFalse: "depth", transparencyDWTrue: "depth",
      transparencyDWTrueDepth: "depth"
    },
    // The occlusion alone, not yet times the picture.
    replace: [["texture2D(sceneDiffuse, vUv)", "vec4(1.0)"], ["sRGBTransferOETF(gl_FragColor)", "gl_FragColor"]],
    expressions: {radius: "radius"},
    values: {
      renderMode: 1, gammaCorrection: false, fog: false, fogNear: 0, fogFar: 1, transparencyAware: false,
      intensity: pass.configuration.intensity, distanceFalloff: pass.configuration.distanceFalloff,
      screenSpaceRadius: false, aoTones: 0
    }
  });
}

function makeConfig(folder, lib, mode, half) {
  const pass = new lib.N8AOPass(new lib.three.Scene(), new lib.three.PerspectiveCamera(), 64, 64);
  pass.depthMipsSupported = true;  // as on every device with float targets
  pass.configuration.halfRes = half;
  pass.setQualityMode(mode);
  pass.configureSampleDependentPasses();
  pass.configureEffectCompositer(pass.configuration.depthBufferType, false);
  const name = `n8ao_${mode.toLowerCase().replace("-", "_")}${half ? "_half" : ""}`, scale = half ? 0.5 : 1;
  const config = new Config(folder, name, `n8ao ${lib.version}, mode ${mode}${half ? ", half resolution" : ""}.`,
    "geometry/depth_only", lib.chunks);
  const noise = config.noise("n8ao_noise", pass.bluenoise);
  let depth = "depth";
  if (half) {
    depth = config.target("half_depth", "r32f", scale);
    const writes = [depth, config.target("half_normal", "rgba16f", scale)];
    config.pass("downsample", pass.depthDownsampleQuad.material, writes, {
      samplers: {sceneDepth: "depth"},
      expressions: {resolution: "vec2(textureSize(sceneDepth, 0))"},
      values: {logDepth: false, ortho: false}
    });
  }
  addMips(config, lib, depth, scale);
  config.target("raw", "rgba8", scale);
  config.pass("occlusion", pass.effectShaderQuad.material, ["raw"], {
    samplers: {
      sceneDepth: depth, sceneNormal: half ? "half_normal" : "depth", sceneDiffuse: "depth", bluenoise: noise,
      depthMipAtlas: "mips"
    },
    replace: [
      [`uniform vec4 depthMipLevels[${lib.DEPTH_MIP_LEVELS}];`, ""],
      ["void main() {", levelsOf(lib.DEPTH_MIP_LEVELS, "textureSize(sceneDepth, 0)")],
      ["depthMipLevels[", "levels["]
    ],
    expressions: {radius: "radius"},
    values: {samples: pass.samples, distanceFalloff: pass.configuration.distanceFalloff}
  });
  addComposition(config, pass, half, addDenoise(config, pass, half, depth, noise));
  config.write();
  return name;
}

export function makeN8ao(folder, lib) {
  return MODES.flatMap(mode => [false, true].map(half => makeConfig(folder, lib, mode, half)));
}
