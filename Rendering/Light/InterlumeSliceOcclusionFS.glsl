// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec
//INTERLUME::FEATURES

// Marks fragments behind which nothing can be seen, by a depth that nothing is nearer than. The
// buffer holds opacity in its fourth channel, or a light's transmittance with TRANSMITTANCE.
in vec2 texCoord;
uniform sampler2D slices;

void main()
{
  // The least transmittance that can be seen.
  const float least = 1e-5;
  vec4 texel = texture(slices, texCoord);
#ifdef OPACITY
  bool isOpaque = texel.a > 1.0 - least;
#else
  vec3 light = texel.CHANNELS;
#ifdef DEPTH
  // Of the octahedral map's direction there, times its cosine with the normal. Depths far beyond
  // what lets anything through keep the shadow's edge, between texels, where it is.
  const float enough = 30.0;
  vec2 corner = texCoord * 2.0 - 1.0;
  vec2 across = vec2(corner.x + corner.y, corner.x - corner.y) * 0.5;
  float along = max(1.0 - abs(across.x) - abs(across.y), 1e-6);
  float slope = along / length(vec3(across, along));
  bool isOpaque = min(min(light.r, light.g), light.b) > enough * slope;
#else
  bool isOpaque = max(max(light.r, light.g), light.b) < least;
#endif
#endif
  if (!isOpaque)
  {
    discard;
  }
  gl_FragDepth = 0.0;
}
