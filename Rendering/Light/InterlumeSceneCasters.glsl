// SPDX-License-Identifier: BSD-3-Clause
// What the opaque surfaces of a scene leave of each light without extent: CASTER_VIEWS maps of their
// depths, as lights see them, in tiles of one texture.

uniform sampler2D casterDepths;
uniform mat4 casterFromPlace[CASTER_VIEWS];
#ifdef CASTER_PLANES
uniform mat4 placeFromCaster[CASTER_VIEWS];
#endif
// The first column and row of a tile, their number, and the bias in texels.
uniform vec4 casterTiles[CASTER_VIEWS];
// The depth of a texel's width: the first, plus the second over w.
uniform vec2 casterTexels[CASTER_VIEWS];

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
      float texelDepth = casterTexels[view].x + casterTexels[view].y / clip.w;
      return lightOfTile(casterDepths, casterTiles[view], texelDepth, clip.xyz / clip.w, slope);
    }
  }
  return 1.0;
}
