// SPDX-License-Identifier: BSD-3-Clause
// Compares depths with a tile of a shadow map.

// Returns a 2 x 2 block of texels: the first row, then the second row.
vec4 occluderTexels4(sampler2D map, vec2 texel)
{
#if defined(OCCLUDER_GATHER) && defined(GL_ARB_texture_gather)
  return textureGather(map, (texel + 1.0) / vec2(textureSize(map, 0))).wzxy;
#else
  ivec2 at = ivec2(texel);
  return vec4(texelFetch(map, at, 0).r, texelFetch(map, at + ivec2(1, 0), 0).r,
    texelFetch(map, at + ivec2(0, 1), 0).r, texelFetch(map, at + 1, 0).r);
#endif
}

// Compares a point of a surface with the four surrounding texels of a depth map. Returns 1 for each
// texel that does not shadow the point, otherwise 0.
// - tile: first column and row of the tile, its size, and the depth bias in units of texelDepth
// - at: the point in normalized device coordinates of the tile
// - slope: derivative of the surface's depth with respect to x and y
// - part: returns the interpolation weights of the second column and row
// - gap: returns the depth differences between the surface and the texels
vec4 litTexels(sampler2D map, vec4 tile, float texelDepth, vec3 at, vec2 slope, out vec2 part, out vec4 gap)
{
  vec2 place = (at.xy * 0.5 + 0.5) * tile.z - 0.5;
  vec2 first = clamp(floor(place), vec2(0.0), vec2(tile.z - 2.0));
  part = clamp(place - first, 0.0, 1.0);
  // Depth change of the surface's plane from the position to each texel center, limited for grazing
  // surfaces.
  vec2 toFirst = slope * (first - place) * (2.0 / tile.z);
  vec2 toSecond = toFirst + slope * (2.0 / tile.z);
  float most = 64.0 * texelDepth;
  vec4 change = clamp(
    vec4(toFirst.x, toSecond.x, toFirst.x, toSecond.x) + vec2(toFirst.y, toSecond.y).xxyy, -most, most);
  // Depths behind the background are clamped to its depth.
  vec4 depths = min(at.z + change - tile.w * texelDepth, vec4(1.0));
  vec4 texels = occluderTexels4(map, tile.xy + first) * 2.0 - 1.0;
  gap = depths - texels;
  return step(depths, texels);
}

// Returns the bilinearly interpolated fraction of lit texels.
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
