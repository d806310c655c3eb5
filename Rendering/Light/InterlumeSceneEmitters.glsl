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
// their number, the first side and their number.
uniform vec4 emitters[3 * EMITTERS];
// Of each side: right, up, and the axis.
uniform vec3 emitterSides[3 * EMITTER_SIDES];
// Of each sample: its offset from the light's place, or how far its light goes aside for each distance of
// 1 along the axis; the scale and the middle of its window; its share of the light.
uniform vec4 emitterSamples[3 * EMITTER_SAMPLES];
// The columns of tiles, the columns of each tile, and the bias in texels.
uniform vec3 emitterTiles;

// Returns the share of a sample of the emitter, by its number, that reaches a place on a plane. Both are
// in the coordinates of the lights.
float lightOfSample(int emitter, int number, vec3 place, vec4 plane)
{
  vec4 center = emitters[3 * emitter];
  vec4 depth = emitters[3 * emitter + 1];
  vec4 parts = emitters[3 * emitter + 2];
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
  float texelDepth = max(texels.x, texels.y) * depth.y;
  vec3 at;
  vec2 slope = vec2(0.0);
  if (isPositional)
  {
    at = vec3(window.xy * (seen.xy / seen.z - window.zw), depth.x - depth.y / seen.z);
    texelDepth /= seen.z;
  }
  else
  {
    at = vec3(window.xy * (seen.xy - offset.xy * seen.z - window.zw), depth.x + depth.y * seen.z);
  }
#ifdef CASTER_PLANES
  vec3 normal = plane.xyz * axes;
  float facing = isPositional ? dot(plane.xyz, source) + plane.w
                              : -normal.z - dot(normal.xy, offset.xy);
  slope = abs(facing) > 0.0 ? normal.xy * depth.y / (facing * window.xy) : slope;
#endif
  if ((isPositional && !(seen.z > 0.0)) || !(max(abs(at.x), abs(at.y)) <= 1.0))
  {
    return 1.0;
  }
  int tile = int(depth.z) + (number - int(parts.x)) * sides + side;
  int columns = int(emitterTiles.x);
  vec2 corner = vec2(tile % columns, tile / columns) * emitterTiles.y;
  return lightOfTile(emitterDepths, vec4(corner, emitterTiles.yz), texelDepth, at, slope);
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

// Returns the share of a sample, and of the whole light, that reaches a place on a plane; without
// CASTER_PLANES the plane is not used.
float lightOfEmitterSample(int emitter, int number, vec3 place, vec4 plane)
{
  return lightOfSample(emitter, number, inEmitters(place), planeInEmitters(plane));
}

vec3 lightOfEmitter(int emitter, vec3 place, vec4 plane)
{
  vec3 here = inEmitters(place);
  vec4 planeHere = planeInEmitters(plane);
  int first = int(emitters[3 * emitter + 2].x);
  int end = first + int(emitters[3 * emitter + 2].y);
  vec3 dark = vec3(0.0);
  for (int number = first; number < end; ++number)
  {
    dark += emitterSamples[3 * number + 2].xyz *
      (1.0 - lightOfSample(emitter, number, here, planeHere));
  }
  return max(1.0 - dark, vec3(0.0));
}
