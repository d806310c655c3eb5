// SPDX-License-Identifier: BSD-3-Clause
// One of the steps in which translucent surfaces are drawn layer by layer; see LayerShader.
uniform int sceneStep;
// The depths of the layer before, or of this one.
uniform sampler2D sceneLayer;

// Returns whether a fragment has no part in the step.
bool isOutsideOfSceneStep()
{
  float layer = sceneStep > 2 ? texelFetch(sceneLayer, ivec2(gl_FragCoord.xy), 0).r : 0.0;
  return sceneStep == 1 || (sceneStep == 3 && !(gl_FragCoord.z > layer)) ||
    ((sceneStep == 4 || sceneStep == 6) && gl_FragCoord.z != layer) ||
    (sceneStep > 4 && gl_FragCoord.z < layer);
}
