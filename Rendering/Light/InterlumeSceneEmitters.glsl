// SPDX-License-Identifier: BSD-3-Clause
// Shadows of opaque surfaces from area lights: one depth map, or six, per sample of the emitter, in
// tiles of one texture. All samples of a light share the same axes. With w the distance along the
// axis, depth is A - B / w for positional lights, otherwise A + B w.

uniform sampler2D emitterDepths;
// Transformation from positions to the unit space of the scene's surfaces.
uniform mat4 emitterFromPosition;
#ifdef OCCLUDER_PLANES
uniform mat4 positionFromEmitter;
#endif
// Five vectors per light:
// - position, and 1 for a positional light, otherwise 0
// - depth coefficients A and B (see above), and the first tile
// - first sample, number of samples, first cube face and number of cube faces
// - width of the filter that smooths a sample's shadow, as a vector on the emitter
// - height of that filter, as a vector on the emitter
uniform vec4 emitters[5 * EMITTERS];
// Three vectors per cube face: right, up and forward.
uniform vec3 emitterSides[3 * EMITTER_SIDES];
// Three vectors per sample:
// - offset from the light's position, or, for a directional light, lateral offset per unit distance
//   along the axis
// - scale and center of the window
// - fraction of the light's color
uniform vec4 emitterSamples[3 * EMITTER_SAMPLES];
// Number of tiles per row, number of columns per tile, and the bias in texels.
uniform vec3 emitterTiles;

// A position projected onto the map of a sample. texelDepth is the depth difference that
// corresponds to the width of a texel. tile, at and slope are arguments of litTexels. moves are the
// shifts in the map, per unit of depth difference to an occluder, that correspond to the width and
// height vectors of the smoothing filter.
struct EmitterProjection
{
  bool isSeen;
  vec4 tile;
  vec3 at;
  vec2 slope;
  float texelDepth;
  vec2 moves[2];
};

// Projects a position on a plane onto the map of a sample. The position and the plane are in the
// unit space of the scene's surfaces.
EmitterProjection seenFromSample(int emitter, int number, vec3 place, vec4 plane)
{
  vec4 center = emitters[5 * emitter];
  vec4 depth = emitters[5 * emitter + 1];
  vec4 parts = emitters[5 * emitter + 2];
  bool isPositional = center.w > 0.0;
  int sides = int(parts.w);
  vec3 offset = emitterSamples[3 * number].xyz;
  vec4 window = emitterSamples[3 * number + 1];
  vec3 source = isPositional ? center.xyz + offset : center.xyz;
  vec3 way = place - source;
  int side = 0;
  if (sides > 1)
  {
    vec3 size = abs(way);
    int axis = size.x >= max(size.y, size.z) ? 0 : size.y >= size.z ? 1 : 2;
    side = 2 * axis + (way[axis] > 0.0 ? 1 : 0);
  }
  int first = 3 * (int(parts.z) + side);
  mat3 axes = mat3(emitterSides[first], emitterSides[first + 1], emitterSides[first + 2]);
  vec3 seen = way * axes;
  vec2 texels = 2.0 / (emitterTiles.y * window.xy);
  EmitterProjection result;
  result.texelDepth = max(texels.x, texels.y) * depth.y;
  result.slope = vec2(0.0);
  if (isPositional)
  {
    result.at =
      vec3(window.xy * (seen.xy / seen.z - window.zw), depth.x - depth.y / seen.z);
    result.texelDepth /= seen.z;
  }
  else
  {
    result.at =
      vec3(window.xy * (seen.xy - offset.xy * seen.z - window.zw), depth.x + depth.y * seen.z);
  }
#ifdef OCCLUDER_PLANES
  vec3 normal = plane.xyz * axes;
  float facing = isPositional ? dot(plane.xyz, source) + plane.w
                              : -normal.z - dot(normal.xy, offset.xy);
  result.slope = abs(facing) > 0.0 ? normal.xy * depth.y / (facing * window.xy) : result.slope;
#endif
  // Different points of the emitter see an occluder at different positions in the map.
  for (int i = 0; i < 2; ++i)
  {
    result.moves[i] = (emitters[5 * emitter + 3 + i].xyz * axes).xy * window.xy / depth.y;
  }
  result.isSeen = !(isPositional && !(seen.z > 0.0)) &&
    max(abs(result.at.x), abs(result.at.y)) <= 1.0;
  int tile = int(depth.z) + (number - int(parts.x)) * sides + side;
  int columns = int(emitterTiles.x);
  result.tile = vec4(vec2(tile % columns, tile / columns) * emitterTiles.y, emitterTiles.yz);
  return result;
}

vec3 inEmitters(vec3 place)
{
  return (emitterFromPosition * vec4(place, 1.0)).xyz;
}

vec4 planeInEmitters(vec4 plane)
{
#ifdef OCCLUDER_PLANES
  return plane * positionFromEmitter;
#else
  return plane;
#endif
}

// Returns the fraction of a sample's light that reaches a position. plane is the plane of the
// surface at the position; it is used only with OCCLUDER_PLANES. gap returns the depth difference
// between the position and occluders, weighted by the occluded fraction.
float lightOfSample(int emitter, int number, vec3 place, vec4 plane, out float gap)
{
  EmitterProjection seen = seenFromSample(emitter, number, place, plane);
  gap = 0.0;
  if (!seen.isSeen)
  {
    return 1.0;
  }
  vec2 part;
  vec4 gaps;
  vec4 lit = litTexels(emitterDepths, seen.tile, seen.texelDepth, seen.at, seen.slope, part, gaps);
  gap = interpolated((1.0 - lit) * gaps, part);
  return interpolated(lit, part);
}

float lightOfEmitterSample(int emitter, int number, vec3 place, vec4 plane)
{
  float gap;
  return lightOfSample(emitter, number, inEmitters(place), planeInEmitters(plane), gap);
}

#ifdef OCCLUDER_PLANES
// Returns the fraction from lightOfSample, averaged over the smoothing filter on the emitter. gap
// is the assumed depth difference to the occluder. Occluders with a depth difference below least
// are ignored.
float lightAroundSample(int emitter, int number, vec3 place, vec4 plane, float gap, float least)
{
  EmitterProjection seen = seenFromSample(emitter, number, place, plane);
  if (!seen.isSeen)
  {
    return 1.0;
  }
  // Four points of a square, no two of them on a line parallel to an edge.
  float sum = 0.0;
  for (int i = 0; i < 4; ++i)
  {
    vec2 share = i % 2 == 0 ? vec2(-0.375, -0.125) : vec2(-0.125, 0.375);
    share = i < 2 ? share : -share;
    vec2 move = gap * (share.x * seen.moves[0] + share.y * seen.moves[1]);
    vec3 at = seen.at + vec3(move, dot(seen.slope, move));
    vec2 part;
    vec4 gaps;
    vec4 lit = litTexels(emitterDepths, seen.tile, seen.texelDepth, at, seen.slope, part, gaps);
    sum += interpolated(max(lit, vec4(lessThan(gaps, vec4(least)))), part);
  }
  return 0.25 * sum;
}
#endif

// Returns the fraction of the light of all samples that reaches a position.
vec3 lightOfEmitter(int emitter, vec3 place, vec4 plane)
{
  vec3 here = inEmitters(place);
  vec4 planeHere = planeInEmitters(plane);
  int first = int(emitters[5 * emitter + 2].x);
  int end = first + int(emitters[5 * emitter + 2].y);
  vec3 dark = vec3(0.0);
  float taken = 0.0;
  float gaps = 0.0;
  for (int number = first; number < end; ++number)
  {
    float gap;
    float light = lightOfSample(emitter, number, here, planeHere, gap);
    dark += emitterSamples[3 * number + 2].xyz * (1.0 - light);
    taken += 1.0 - light;
    gaps += gap;
  }
#ifdef OCCLUDER_PLANES
  // In a penumbra, smooth the steps between samples. For an unoccluded sample, ignore occluders
  // that are much closer to the position than occluders are on average. Otherwise, a wall would
  // darken the floor next to it.
  if (taken > 0.0 && taken < float(end - first))
  {
    const float tolerance = 0.5;
    float mean = gaps / taken;
    dark = vec3(0.0);
    for (int number = first; number < end; ++number)
    {
      float own;
      bool isHidden = lightOfSample(emitter, number, here, planeHere, own) < 1.0;
      dark += emitterSamples[3 * number + 2].xyz * (1.0 -
        lightAroundSample(
          emitter, number, here, planeHere, mean, isHidden ? 0.0 : tolerance * mean));
    }
  }
#endif
  return max(1.0 - dark, vec3(0.0));
}
