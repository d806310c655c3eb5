// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec
//INTERLUME::FEATURES

// Resamples transmittance maps between the views of an emitter's center and of its samples. Two
// views of a plane are related by a homography. Layers of samples are stacked vertically in one
// texture. place is a position in clip coordinates of the light buffer.
in vec3 place;
uniform sampler2D map;
#ifdef JOIN
// Transmittance of two batches, at the resolution of the output.
uniform sampler2D batch1;
uniform sampler2D batch2;

// Returns the mean of the layers, sharpened. Interpolating the layers and their mean blurs edges,
// so that penumbras of a few texels would be too wide. Subtracting a fraction of the second
// difference compensates for this. The result is clamped to the range of the texel and its
// neighbors. Small differences are ignored because they are steps between the emitter's samples.
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
// Three columns per layer: transformation from clip coordinates of the light buffer to those of the
// layer.
uniform vec3 layerFromBuffer[3 * LAYERS];
uniform float weights[LAYERS];
// Half a texel of a layer, to avoid sampling the adjacent layer.
uniform float margin;
#else
// Matrices that map clip coordinates of the light buffer to the vector from the corresponding point
// of the plane to the emitter's center or to the sample. Both vectors have the same scale.
uniform mat3 vectorToCenter;
uniform mat3 vectorToSample;
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
    // Points behind a light are not occluded.
    sum += weights[layer] * (seen.z > 0.0 ? textureLod(map, at, 0.0).CHANNELS : COLOR(1.0));
  }
  gl_FragData[0] = vec4(1.0);
  gl_FragData[0].CHANNELS = sum;
#else
  vec3 center = vectorToCenter * vec3(place.xy, 1.0);
  vec3 way = vectorToSample * vec3(place.xy, 1.0);
  // Find the length of the path through a slab along the ray to the sample, relative to the path
  // along the ray to the center.
  float rise = dot(center, sliceNormal);
  float fall = dot(way, sliceNormal);
  float longer = sqrt(dot(way, way) / dot(center, center)) * abs(rise / fall);
  gl_FragData[0] = vec4(1.0);
  gl_FragData[0].CHANNELS =
    pow(textureLod(map, place.xy * 0.5 + 0.5, 0.0).CHANNELS, COLOR(longer));
#endif
}
