// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec
//INTERLUME::FEATURES

// Writes the nearest depth to pixels that are already opaque, so that the depth test culls further
// fragments. The macro OPACITY, TRANSMITTANCE or DEPTH specifies what the buffer's texels contain:
// see SliceOcclusion.
in vec2 texCoord;
uniform sampler2D slices;

void main()
{
  // Minimum visible transmittance.
  const float least = 1e-5;
  vec4 texel = texture(slices, texCoord);
#ifdef OPACITY
  bool isOpaque = texel.a > 1.0 - least;
#else
  vec3 light = texel.CHANNELS;
#ifdef DEPTH
  // The buffer contains the optical depth along a direction of the octahedral map, times the cosine
  // between that direction and the normal. The threshold is far above visible optical depths, so
  // that interpolation does not shift shadow edges.
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
