// SPDX-License-Identifier: BSD-3-Clause
// How much of a light reaches a place whose depth is compared with a tile of a depth map.

// Returns the four texels of a map from one on: first row, then second row.
vec4 casterTexels4(sampler2D map, vec2 texel)
{
#if defined(CASTER_GATHER) && defined(GL_ARB_texture_gather)
  return textureGather(map, (texel + 1.0) / vec2(textureSize(map, 0))).wzxy;
#else
  ivec2 at = ivec2(texel);
  return vec4(texelFetch(map, at, 0).r, texelFetch(map, at + ivec2(1, 0), 0).r,
    texelFetch(map, at + ivec2(0, 1), 0).r, texelFetch(map, at + 1, 0).r);
#endif
}

// Returns which of the four texels around a place in a map the light reaches, 0 or 1, the place between
// them, and how much nearer to the light than the surface they are. The place is in normalised device
// coordinates of a tile: its first column and row, their number, and the bias in texels, each as deep as
// texelDepth. The surface that is lit has this slope of depth over the map.
vec4 litTexels(sampler2D map, vec4 tile, float texelDepth, vec3 at, vec2 slope, out vec2 part, out vec4 gap)
{
  vec2 place = (at.xy * 0.5 + 0.5) * tile.z - 0.5;
  vec2 first = clamp(floor(place), vec2(0.0), vec2(tile.z - 2.0));
  part = clamp(place - first, 0.0, 1.0);
  // How much deeper the surface is in the middle of each texel; none is seen more aslant than that.
  vec2 toFirst = slope * (first - place) * (2.0 / tile.z);
  vec2 toSecond = toFirst + slope * (2.0 / tile.z);
  float most = 64.0 * texelDepth;
  vec4 change = clamp(
    vec4(toFirst.x, toSecond.x, toFirst.x, toSecond.x) + vec2(toFirst.y, toSecond.y).xxyy, -most, most);
  // What is behind all that the map has is as deep as the background.
  vec4 depths = min(at.z + change - tile.w * texelDepth, vec4(1.0));
  vec4 texels = casterTexels4(map, tile.xy + first) * 2.0 - 1.0;
  gap = depths - texels;
  return step(depths, texels);
}

// Returns the share of the texels that the light reaches, weighted as for bilinear interpolation.
float interpolated(vec4 texels, vec2 part)
{
  return mix(mix(texels.x, texels.y, part.x), mix(texels.z, texels.w, part.x), part.y);
}

float lightOfTile(sampler2D map, vec4 tile, float texelDepth, vec3 at, vec2 slope)
{
  vec2 part;
  vec4 gap;
  vec4 lit = litTexels(map, tile, texelDepth, at, slope, part, gap);
  return interpolated(lit, part);
}
