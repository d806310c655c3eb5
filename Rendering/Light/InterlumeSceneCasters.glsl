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

// Returns the four texels of the maps from one on: first row, then second row.
vec4 casterTexels4(vec2 texel)
{
#if defined(CASTER_GATHER) && defined(GL_ARB_texture_gather)
  return textureGather(casterDepths, (texel + 1.0) / vec2(textureSize(casterDepths, 0))).wzxy;
#else
  ivec2 at = ivec2(texel);
  return vec4(texelFetch(casterDepths, at, 0).r, texelFetch(casterDepths, at + ivec2(1, 0), 0).r,
    texelFetch(casterDepths, at + ivec2(0, 1), 0).r, texelFetch(casterDepths, at + 1, 0).r);
#endif
}

// Returns the share of the four texels around a place in a map, weighted as for bilinear interpolation,
// that the light reaches. The surface that is lit has this slope of depth over the map.
float lightOfTile(int view, vec4 clip, vec2 slope)
{
  vec4 tile = casterTiles[view];
  vec3 at = clip.xyz / clip.w;
  float texelDepth = casterTexels[view].x + casterTexels[view].y / clip.w;
  vec2 place = (at.xy * 0.5 + 0.5) * tile.z - 0.5;
  vec2 first = clamp(floor(place), vec2(0.0), vec2(tile.z - 2.0));
  vec2 part = clamp(place - first, 0.0, 1.0);
  // How much deeper the surface is in the middle of each texel; none is seen more aslant than that.
  vec2 toFirst = slope * (first - place) * (2.0 / tile.z);
  vec2 toSecond = toFirst + slope * (2.0 / tile.z);
  float most = 64.0 * texelDepth;
  vec4 change = clamp(
    vec4(toFirst.x, toSecond.x, toFirst.x, toSecond.x) + vec2(toFirst.y, toSecond.y).xxyy, -most, most);
  // What is behind all that the map has is as deep as the background.
  vec4 depths = min(at.z + change - tile.w * texelDepth, vec4(1.0));
  vec4 lit = step(depths, casterTexels4(tile.xy + first) * 2.0 - 1.0);
  return mix(mix(lit.x, lit.y, part.x), mix(lit.z, lit.w, part.x), part.y);
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
