// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec
//INTERLUME::FEATURES

// What an area light's layers leave at a surface behind all slices, for the pixel that shows it: each
// layer is looked at from its own sample. Layers stand one over the other in textures.
in vec3 place;
uniform mat4 layerFromUnit[LAYERS];
uniform float layerWeights[LAYERS];
// Half a texel of a layer, beyond which its neighbour begins.
uniform float margin;
//INTERLUME::STACKS

//VTK::Output::Dec

// Returns what layers of a texture, so many from a first one on, take from the light.
vec4 darkOf(sampler2D stack, int first, int count)
{
  vec4 dark = vec4(0.0);
  for (int i = 0; i < count; ++i)
  {
    vec4 inLayer = layerFromUnit[first + i] * vec4(place, 1.0);
    if (inLayer.w > 0.0 && max(abs(inLayer.x), abs(inLayer.y)) <= inLayer.w)
    {
      vec2 at = clamp(inLayer.xy / inLayer.w * 0.5 + 0.5, margin, 1.0 - margin);
      at.y = (float(i) + at.y) / float(count);
      dark += layerWeights[first + i] * (1.0 - textureLod(stack, at, 0.0));
    }
  }
  return dark;
}

void main()
{
  vec4 dark = vec4(0.0);
  //INTERLUME::SUM
  gl_FragData[0] = max(1.0 - dark, 0.0);
}
