// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec
//INTERLUME::FEATURES

// Looks maps up as they are seen from other samples of an emitter: two views of one plane are a
// homography apart. Layers of samples stand one over the other in a texture.
in vec2 texCoord;
uniform sampler2D map;
uniform int layers;
// Three columns for each layer: from clip coordinates of what is drawn to those of the map.
uniform vec3 mapFromTarget[3 * MOST_LAYERS];
#ifdef MEAN
uniform float weights[MOST_LAYERS];
// Half a texel of a layer, beyond which its neighbour begins.
uniform float margin;
#else
// Three columns: from clip coordinates of the map to the plane's points, homogeneous ones.
uniform vec4 pointFromMap[3];
uniform vec3 sliceNormal;
// The place of the emitter's centre and those of the samples, or directions, homogeneous ones.
uniform vec4 center;
uniform vec4 sources[MOST_LAYERS];
#endif

//VTK::Output::Dec

vec3 seenFrom(int layer, vec2 at)
{
  vec2 clip = at * 2.0 - 1.0;
  return mapFromTarget[3 * layer] * clip.x + mapFromTarget[3 * layer + 1] * clip.y +
    mapFromTarget[3 * layer + 2];
}

#ifndef MEAN
// The way through a slab of thickness 1 on a ray to a light.
float slantOf(vec4 source, vec3 at)
{
  vec3 way = source.xyz - source.w * at;
  return length(way) / max(abs(dot(way, sliceNormal)), 1e-6 * length(way));
}
#endif

void main()
{
  // Nothing lies in planes behind a light.
#ifdef MEAN
  vec4 sum = vec4(0.0);
  for (int layer = 0; layer < layers; ++layer)
  {
    vec3 place = seenFrom(layer, texCoord);
    vec2 at = clamp(place.xy / place.z * 0.5 + 0.5, margin, 1.0 - margin);
    at.y = (float(layer) + at.y) / float(layers);
    sum += weights[layer] * (place.z > 0.0 ? textureLod(map, at, 0.0) : vec4(1.0));
  }
  gl_FragData[0] = sum;
#else
  float row = texCoord.y * float(layers);
  int layer = min(int(row), layers - 1);
  vec3 place = seenFrom(layer, vec2(texCoord.x, row - float(layer)));
  gl_FragData[0] = vec4(1.0);
  if (place.z > 0.0)
  {
    vec4 point = pointFromMap[0] * place.x + pointFromMap[1] * place.y + pointFromMap[2] * place.z;
    vec3 at = point.xyz / point.w;
    float longer = slantOf(sources[layer], at) / slantOf(center, at);
    gl_FragData[0] =
      pow(textureLod(map, place.xy / place.z * 0.5 + 0.5, 0.0), vec4(longer));
  }
#endif
}
