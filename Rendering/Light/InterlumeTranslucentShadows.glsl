// SPDX-License-Identifier: BSD-3-Clause
// Shadows of translucent surfaces, in TRANSLUCENT_LAYERS layers of TRANSLUCENT_VIEWS maps, rendered
// from the lights, in tiles of one texture. Layers are stacked vertically; each is translucentRows
// high. A texel holds the layer's depth and the transmittance through it and all layers in front of
// it.

uniform sampler2D translucentLayers;
uniform int translucentRows;
uniform mat4 translucentFromPosition[TRANSLUCENT_VIEWS];
#ifdef TRANSLUCENT_PLANES
uniform mat4 positionFromTranslucent[TRANSLUCENT_VIEWS];
#endif
// For each view, first column and row of its tile, size of the tile, and depth bias in texels.
uniform vec4 translucentTiles[TRANSLUCENT_VIEWS];
// For each view, coefficients a and b of the depth difference a + b / w that corresponds to the
// width of a texel.
uniform vec2 translucentTexels[TRANSLUCENT_VIEWS];

// Returns the fraction of a light transmitted to a position, bilinearly interpolated between four
// texels. first is the index of the light's first view, and views is the number of its views. plane
// is the plane of the surface at the position; it is used only with TRANSLUCENT_PLANES.
float lightOfTranslucentLayers(int first, int views, vec3 place, vec4 plane)
{
  for (int view = first; view < first + views; ++view)
  {
    vec4 clip = translucentFromPosition[view] * vec4(place, 1.0);
    if (!(clip.w > 0.0 && max(abs(clip.x), abs(clip.y)) <= clip.w))
    {
      continue;
    }
    vec4 tile = translucentTiles[view];
    vec3 at = clip.xyz / clip.w;
    vec2 inTile = (at.xy * 0.5 + 0.5) * tile.z - 0.5;
    vec2 corner = clamp(floor(inTile), vec2(0.0), vec2(tile.z - 2.0));
    vec2 part = clamp(inTile - corner, 0.0, 1.0);
    vec4 depths = vec4(at.z);
#ifdef TRANSLUCENT_PLANES
    // Depth of the plane at each texel center, biased toward the light.
    vec4 seen = plane * positionFromTranslucent[view];
    vec2 slope = (abs(seen.z) > 0.0 ? -seen.xy / seen.z : vec2(0.0)) * (2.0 / tile.z);
    float texel = translucentTexels[view].x + translucentTexels[view].y / clip.w;
    vec2 near = slope * (corner - inTile);
    vec2 far = near + slope;
    depths += clamp(vec4(near.x, far.x, near.x, far.x) + vec2(near.y, far.y).xxyy, -64.0 * texel,
      64.0 * texel) - tile.w * texel;
#endif
    vec4 lit = vec4(1.0);
    for (int i = 0; i < 4; ++i)
    {
      ivec2 from = ivec2(tile.xy + corner) + ivec2(i & 1, i >> 1);
      for (int layer = 0; layer < TRANSLUCENT_LAYERS; ++layer)
      {
        vec2 stored = texelFetch(translucentLayers, from + ivec2(0, layer * translucentRows), 0).rg;
        lit[i] = depths[i] > stored.r * 2.0 - 1.0 ? stored.g : lit[i];
      }
    }
    return mix(mix(lit.x, lit.y, part.x), mix(lit.z, lit.w, part.x), part.y);
  }
  return 1.0;
}
