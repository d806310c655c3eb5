// SPDX-License-Identifier: BSD-3-Clause
// What the opaque surfaces of a scene leave of each light with an extent: a depth map for each sample
// of its emitter, or six of them, in tiles of one texture. The samples of a light look along the same
// axes. With w the distance along the axis, depth is A - B / w of positional lights, else A + B w.

uniform sampler2D emitterDepths;
// To coordinates of size 1 around the surfaces.
uniform mat4 emitterFromPlace;
#ifdef CASTER_PLANES
uniform mat4 placeFromEmitter;
#endif
// Of each light: its place, and 1 where it is positional; A, B and the first tile; the first sample,
// their number, the first side and their number; the width and the height of what a sample stands for.
uniform vec4 emitters[5 * EMITTERS];
// Of each side: right, up, and the axis.
uniform vec3 emitterSides[3 * EMITTER_SIDES];
// Of each sample: its offset from the light's place, or how far its light goes aside for each distance of
// 1 along the axis; the scale and the middle of its window; its share of the light.
uniform vec4 emitterSamples[3 * EMITTER_SAMPLES];
// The columns of tiles, the columns of each tile, and the bias in texels.
uniform vec3 emitterTiles;

// A place as a sample sees it: where in which tile, the slope there and the depth of a texel's width, and
// how far the place moves for what the sample stands for where the gap to what casts the shadow is 1.
struct EmitterPlace
{
  bool isSeen;
  vec4 tile;
  vec3 at;
  vec2 slope;
  float texelDepth;
  vec2 moves[2];
};

// Looks from a sample, by its number, at a place on a plane, both in the coordinates of the lights.
EmitterPlace seenFromSample(int emitter, int number, vec3 place, vec4 plane)
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
  // Columns of the matrix are axes.
  mat3 axes = mat3(emitterSides[first], emitterSides[first + 1], emitterSides[first + 2]);
  vec3 seen = way * axes;
  vec2 texels = 2.0 / (emitterTiles.y * window.xy);
  EmitterPlace result;
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
#ifdef CASTER_PLANES
  vec3 normal = plane.xyz * axes;
  float facing = isPositional ? dot(plane.xyz, source) + plane.w
                              : -normal.z - dot(normal.xy, offset.xy);
  result.slope = abs(facing) > 0.0 ? normal.xy * depth.y / (facing * window.xy) : result.slope;
#endif
  // Two samples apart see what is nearer to the light at places apart.
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
  return (emitterFromPlace * vec4(place, 1.0)).xyz;
}

vec4 planeInEmitters(vec4 plane)
{
#ifdef CASTER_PLANES
  return plane * placeFromEmitter;
#else
  return plane;
#endif
}

// Returns the share of a sample that reaches a place on a plane; without CASTER_PLANES the plane is not
// used. The gap is how much nearer to the light than the place what casts a shadow is, times the share
// that it takes.
float lightOfSample(int emitter, int number, vec3 place, vec4 plane, out float gap)
{
  EmitterPlace seen = seenFromSample(emitter, number, place, plane);
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

#ifdef CASTER_PLANES
// Returns the same with the mean over what the sample stands for, as its map has it, where what casts the
// shadow has this gap; nothing with less than the least gap does.
float lightAroundSample(int emitter, int number, vec3 place, vec4 plane, float gap, float least)
{
  EmitterPlace seen = seenFromSample(emitter, number, place, plane);
  if (!seen.isSeen)
  {
    return 1.0;
  }
  // Four places of a square, of which no two are on one line along an edge.
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

// Returns the share of the whole light.
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
#ifdef CASTER_PLANES
  // Where some samples are hidden their steps are smoothed. What moves into the way of a sample that
  // shines here is not nearer than what hides others: at the foot of a wall each sample sees the wall
  // beside the place, but no gap.
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
