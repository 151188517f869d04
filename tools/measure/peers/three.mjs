// SPDX-License-Identifier: MIT
// three.js's GTAOPass with its denoiser, as the pass sets them up.
import {Config} from "./config.mjs";

export function makeThree(folder, lib) {
  const pass = new lib.GTAOPass(new lib.three.Scene(), new lib.three.PerspectiveCamera(), 64, 64);
  const config = new Config(folder, "three_gtao", `three.js r${lib.three.REVISION}, GTAOPass.`, "geometry/depth_normal",
    lib.chunks);
  const surface = {tNormal: "normal", tDepth: "depth"};
  config.target("raw", "rgba16f");
  config.target("ao", "r8");
  config.pass("occlusion", pass.gtaoMaterial, ["raw"], {
    samplers: {...surface, tNoise: config.noise("three_gtao_noise", pass.gtaoNoiseTexture)},
    expressions: {radius: "radius", cameraWorldMatrix: "mat4(1.0)"}
  }, {clear: {raw: 1}});
  config.pass("denoise", pass.pdMaterial, ["ao"], {
    samplers: {
      ...surface, tDiffuse: {from: "raw", filter: "linear"},
      tNoise: config.noise("three_denoise_noise", pass.pdNoiseTexture)
    },
    rename: {radius: "denoise_radius"}
  }, {clear: {ao: 1}});
  config.write();
  return ["three_gtao"];
}
