// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec
//INTERLUME::FEATURES

// Looks maps up as they are seen from other samples of an emitter: two views of one plane are a
// homography apart. Layers of samples stand one over the other in a texture.
// The place in clip coordinates of the light's buffer.
in vec3 place;
uniform sampler2D map;
#ifdef JOIN
// What two batches let through, in the texels of what is drawn.
uniform sampler2D batch1;
uniform sampler2D batch2;

// Returns the mean of the layers. Lookups between texels, of the layers and of their mean most of all,
// spread an edge, so that penumbras of a few texels would be too wide. A share of the second difference
// takes this back, within the values around; a small difference is that between samples of the emitter.
vec4 getSharpMean(vec2 at)
{
  const float share = 0.5;
  const float small = 0.04;
  vec2 texel = 1.0 / vec2(textureSize(map, 0));
  vec4 here = textureLod(map, at, 0.0);
  vec4 lowest = here;
  vec4 highest = here;
  vec4 difference = 4.0 * here;
  for (int i = 0; i < 4; ++i)
  {
    vec2 move = (i & 1) == 0 ? vec2(texel.x, 0.0) : vec2(0.0, texel.y);
    vec4 other = textureLod(map, i < 2 ? at + move : at - move, 0.0);
    difference -= other;
    lowest = min(lowest, other);
    highest = max(highest, other);
  }
  difference -= clamp(difference, -small, small);
  return clamp(here + share * difference, lowest, highest);
}
#elif defined(MEAN)
// Three columns for each layer: from clip coordinates of the light's buffer to those of the layer.
uniform vec3 layerFromBuffer[3 * LAYERS];
uniform float weights[LAYERS];
// Half a texel of a layer, beyond which its neighbour begins.
uniform float margin;
#else
// Three columns each: from clip coordinates of the light's buffer to the way from the points of the
// plane to the emitter's centre, and to the sample, times the same factor.
uniform mat3 wayToCenter;
uniform mat3 wayToSample;
uniform vec3 sliceNormal;
#endif

//VTK::Output::Dec

void main()
{
#ifdef JOIN
  ivec2 texel = ivec2(gl_FragCoord.xy);
  gl_FragData[0] = getSharpMean(place.xy * 0.5 + 0.5) * texelFetch(batch1, texel, 0) *
    texelFetch(batch2, texel, 0);
#elif defined(MEAN)
  COLOR sum = COLOR(0.0);
  for (int layer = 0; layer < LAYERS; ++layer)
  {
    vec3 seen = layerFromBuffer[3 * layer] * place.x + layerFromBuffer[3 * layer + 1] * place.y +
      layerFromBuffer[3 * layer + 2];
    vec2 at = clamp(seen.xy / seen.z * 0.5 + 0.5, margin, 1.0 - margin);
    at.y = (float(layer) + at.y) * (1.0 / float(LAYERS));
    // Nothing lies in planes behind a light.
    sum += weights[layer] * (seen.z > 0.0 ? textureLod(map, at, 0.0).CHANNELS : COLOR(1.0));
  }
  gl_FragData[0] = vec4(1.0);
  gl_FragData[0].CHANNELS = sum;
#else
  vec3 center = wayToCenter * vec3(place.xy, 1.0);
  vec3 way = wayToSample * vec3(place.xy, 1.0);
  // The way through a slab on the ray to the sample over that on the ray to the centre.
  float rise = dot(center, sliceNormal);
  float fall = dot(way, sliceNormal);
  float longer = sqrt(dot(way, way) / dot(center, center)) * abs(rise / fall);
  gl_FragData[0] = vec4(1.0);
  gl_FragData[0].CHANNELS =
    pow(textureLod(map, place.xy * 0.5 + 0.5, 0.0).CHANNELS, COLOR(longer));
#endif
}
