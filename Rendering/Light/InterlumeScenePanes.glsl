// SPDX-License-Identifier: BSD-3-Clause
// What translucent surfaces leave of each light: PANE_LAYERS layers of PANE_VIEWS maps, as lights see
// them, in tiles of one texture; layers lie above each other, each paneRows high. A texel has the layer's
// depth and what comes through it and all layers before it.

uniform sampler2D paneLayers;
uniform int paneRows;
uniform mat4 paneFromPlace[PANE_VIEWS];
#ifdef PANE_PLANES
uniform mat4 placeFromPane[PANE_VIEWS];
#endif
// The first column and row of a tile, their number, and the bias in texels.
uniform vec4 paneTiles[PANE_VIEWS];
// The depth of a texel's width: the first, plus the second over w.
uniform vec2 paneTexels[PANE_VIEWS];

// Returns the share of a light, with so many views from a first one on, that comes through to a place on
// a plane: that of the four texels around, weighted as for bilinear interpolation. Without PANE_PLANES
// the plane is not used.
float lightOfPanes(int first, int views, vec3 place, vec4 plane)
{
  for (int view = first; view < first + views; ++view)
  {
    vec4 clip = paneFromPlace[view] * vec4(place, 1.0);
    if (!(clip.w > 0.0 && max(abs(clip.x), abs(clip.y)) <= clip.w))
    {
      continue;
    }
    vec4 tile = paneTiles[view];
    vec3 at = clip.xyz / clip.w;
    vec2 inTile = (at.xy * 0.5 + 0.5) * tile.z - 0.5;
    vec2 corner = clamp(floor(inTile), vec2(0.0), vec2(tile.z - 2.0));
    vec2 part = clamp(inTile - corner, 0.0, 1.0);
    vec4 depths = vec4(at.z);
#ifdef PANE_PLANES
    // How much deeper the surface that is lit is in the middle of each texel, and moved towards the light.
    vec4 seen = plane * placeFromPane[view];
    vec2 slope = (abs(seen.z) > 0.0 ? -seen.xy / seen.z : vec2(0.0)) * (2.0 / tile.z);
    float texel = paneTexels[view].x + paneTexels[view].y / clip.w;
    vec2 near = slope * (corner - inTile);
    vec2 far = near + slope;
    depths += clamp(vec4(near.x, far.x, near.x, far.x) + vec2(near.y, far.y).xxyy, -64.0 * texel,
      64.0 * texel) - tile.w * texel;
#endif
    vec4 lit = vec4(1.0);
    for (int i = 0; i < 4; ++i)
    {
      ivec2 from = ivec2(tile.xy + corner) + ivec2(i & 1, i >> 1);
      for (int layer = 0; layer < PANE_LAYERS; ++layer)
      {
        vec2 pane = texelFetch(paneLayers, from + ivec2(0, layer * paneRows), 0).rg;
        lit[i] = depths[i] > pane.r * 2.0 - 1.0 ? pane.g : lit[i];
      }
    }
    return mix(mix(lit.x, lit.y, part.x), mix(lit.z, lit.w, part.x), part.y);
  }
  return 1.0;
}
