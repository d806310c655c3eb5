// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec
//INTERLUME::FEATURES

// What an area light's layers leave at a surface behind all slices, for the pixel that shows it: each
// layer is looked at from its own sample. Layers stand one over the other in textures. Where surfaces
// cast shadows too, the mean is that of the samples that they let through: it is multiplied by these.
in vec3 place;
uniform mat4 layerFromUnit[LAYERS];
uniform float layerWeights[LAYERS];
// Half a texel of a layer, beyond which its neighbour begins.
uniform float margin;
//INTERLUME::CASTERS
//INTERLUME::STACKS

//VTK::Output::Dec

// The shares of all samples and of those that come through surfaces, and what layers take from them.
float seen = 0.0;
vec4 dark = vec4(0.0);
vec4 darkOfSeen = vec4(0.0);

// Adds the layers of a texture, so many from a first one on.
void addLayers(sampler2D stack, int first, int count)
{
  for (int i = 0; i < count; ++i)
  {
    int layer = first + i;
    vec4 taken = vec4(0.0);
    vec4 inLayer = layerFromUnit[layer] * vec4(place, 1.0);
    if (inLayer.w > 0.0 && max(abs(inLayer.x), abs(inLayer.y)) <= inLayer.w)
    {
      vec2 at = clamp(inLayer.xy / inLayer.w * 0.5 + 0.5, margin, 1.0 - margin);
      at.y = (float(i) + at.y) / float(count);
      taken = layerWeights[layer] * (1.0 - textureLod(stack, at, 0.0));
    }
    dark += taken;
#ifdef SAMPLE_SHARE
    float share = SAMPLE_SHARE;
    seen += layerWeights[layer] * share;
    darkOfSeen += share * taken;
#endif
  }
}

void main()
{
//INTERLUME::SUM
  gl_FragData[0] = max(1.0 - (seen > 1e-3 ? darkOfSeen / seen : dark), 0.0);
}
