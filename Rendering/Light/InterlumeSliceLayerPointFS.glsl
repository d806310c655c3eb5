// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec
//INTERLUME::FEATURES

// Computes the mean transmittance of an area light's layers at a point of a surface behind all
// slices. Each layer is looked up as seen from its own emitter sample. Layers are stacked
// vertically in textures. If surfaces also cast shadows, the result is the mean over the samples
// that surfaces do not hide, since the shader of the surface multiplies it by the fraction of these
// samples.
in vec3 place;
uniform mat4 layerFromUnit[LAYERS];
uniform float layerWeights[LAYERS];
// Half a texel of a layer, to avoid sampling the adjacent layer.
uniform float margin;
//INTERLUME::OCCLUDERS
//INTERLUME::STACKS

//VTK::Output::Dec

// Total weight of the samples that surfaces do not hide, and the fraction of light that the medium
// absorbs from all samples and from samples that are not hidden.
float seen = 0.0;
vec4 dark = vec4(0.0);
vec4 darkOfSeen = vec4(0.0);

// Adds count layers of a texture to the sums. first is the index of the first layer.
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
#ifdef SAMPLE_FRACTION
    float share = SAMPLE_FRACTION;
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
