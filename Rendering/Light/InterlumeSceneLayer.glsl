// SPDX-License-Identifier: BSD-3-Clause
// One pass of layer-by-layer rendering of translucent surfaces; see LayerShader.
uniform int sceneStep;
// Depths of the previous layer in step 3, and of the current layer in later steps.
uniform sampler2D sceneLayer;

// Returns true if a fragment does not belong to the pass.
bool isOutsideOfSceneStep()
{
  float layer = sceneStep > 2 ? texelFetch(sceneLayer, ivec2(gl_FragCoord.xy), 0).r : 0.0;
  return sceneStep == 1 || (sceneStep == 3 && !(gl_FragCoord.z > layer)) ||
    ((sceneStep == 4 || sceneStep == 6) && gl_FragCoord.z != layer) ||
    (sceneStep > 4 && gl_FragCoord.z < layer);
}
