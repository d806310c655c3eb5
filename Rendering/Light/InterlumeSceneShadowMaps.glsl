// SPDX-License-Identifier: BSD-3-Clause
// Shadow maps of opaque surfaces for lights without extent: OCCLUDER_VIEWS maps in tiles of one
// texture.

uniform sampler2D occluderDepths;
uniform mat4 occluderFromPosition[OCCLUDER_VIEWS];
#ifdef OCCLUDER_PLANES
uniform mat4 positionFromOccluder[OCCLUDER_VIEWS];
#endif
// For each view, first column and row of its tile, size of the tile, and depth bias in texels.
uniform vec4 occluderTiles[OCCLUDER_VIEWS];
// For each view, coefficients a and b of the depth difference a + b / w that corresponds to the
// width of a texel.
uniform vec2 occluderTexels[OCCLUDER_VIEWS];

// Returns the fraction of a light that reaches a position. first is the index of the light's first
// view, and views is the number of its views. plane is the plane of the surface at the position; it
// is used only with OCCLUDER_PLANES.
float lightOfOccluders(int first, int views, vec3 place, vec4 plane)
{
  for (int view = first; view < first + views; ++view)
  {
    vec4 clip = occluderFromPosition[view] * vec4(place, 1.0);
    if (clip.w > 0.0 && max(abs(clip.x), abs(clip.y)) <= clip.w)
    {
      vec2 slope = vec2(0.0);
#ifdef OCCLUDER_PLANES
      vec4 seen = plane * positionFromOccluder[view];
      slope = abs(seen.z) > 0.0 ? -seen.xy / seen.z : slope;
#endif
      float texelDepth = occluderTexels[view].x + occluderTexels[view].y / clip.w;
      return lightOfTile(occluderDepths, occluderTiles[view], texelDepth, clip.xyz / clip.w, slope);
    }
  }
  return 1.0;
}
