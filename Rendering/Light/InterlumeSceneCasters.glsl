// SPDX-License-Identifier: BSD-3-Clause
// What the opaque surfaces of a scene leave of each light: CASTER_VIEWS maps of their depths, as lights
// see them, in tiles of one texture.

uniform sampler2D casterDepths;
uniform mat4 casterFromPlace[CASTER_VIEWS];
#ifdef CASTER_PLANES
uniform mat4 placeFromCaster[CASTER_VIEWS];
#endif
// The first column and row of a tile, their number, and the bias in texels.
uniform vec4 casterTiles[CASTER_VIEWS];
// The depth of a texel's width: the first, plus the second over w.
uniform vec2 casterTexels[CASTER_VIEWS];

// Returns the share of the four texels around a place in a map, weighted as for bilinear interpolation,
// that the light reaches. The surface that is lit has this slope of depth over the map.
float lightOfTile(int view, vec4 clip, vec2 slope)
{
  vec4 tile = casterTiles[view];
  vec3 at = clip.xyz / clip.w;
  float texelDepth = casterTexels[view].x + casterTexels[view].y / clip.w;
  vec2 place = (at.xy * 0.5 + 0.5) * tile.z - 0.5;
  vec2 first = floor(place);
  vec2 part = place - first;
  float lit[4];
  for (int i = 0; i < 4; ++i)
  {
    vec2 texel = first + vec2(float(i & 1), float(i >> 1));
    // No surface is seen as aslant as that.
    float most = 64.0 * texelDepth;
    float change = clamp(dot(slope, (texel - place) * (2.0 / tile.z)), -most, most);
    // What is behind all that the map has is as deep as the background.
    float depth = min(at.z + change - tile.w * texelDepth, 1.0);
    ivec2 inside = ivec2(tile.xy + clamp(texel, vec2(0.0), vec2(tile.z - 1.0)));
    lit[i] = depth <= texelFetch(casterDepths, inside, 0).r * 2.0 - 1.0 ? 1.0 : 0.0;
  }
  return mix(mix(lit[0], lit[1], part.x), mix(lit[2], lit[3], part.x), part.y);
}

// Returns the share of a light, with so many views from a first one on, that reaches a place on a
// plane; without CASTER_PLANES the plane is not used.
float lightOfCasters(int first, int views, vec3 place, vec4 plane)
{
  for (int view = first; view < first + views; ++view)
  {
    vec4 clip = casterFromPlace[view] * vec4(place, 1.0);
    if (clip.w > 0.0 && max(abs(clip.x), abs(clip.y)) <= clip.w)
    {
      vec2 slope = vec2(0.0);
#ifdef CASTER_PLANES
      vec4 seen = plane * placeFromCaster[view];
      slope = abs(seen.z) > 0.0 ? -seen.xy / seen.z : slope;
#endif
      return lightOfTile(view, clip, slope);
    }
  }
  return 1.0;
}
