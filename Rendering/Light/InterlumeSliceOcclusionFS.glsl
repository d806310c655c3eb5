// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec
//INTERLUME::FEATURES

// Keeps the fragments of a slice at pixels that are already opaque. They have the nearest depth, so
// that the depth test culls further fragments. The macro OPACITY, TRANSMITTANCE or DEPTH specifies
// what the buffer's texels contain: see SliceOcclusion.
uniform sampler2D slices;

void main()
{
  vec4 texel = texelFetch(slices, ivec2(gl_FragCoord.xy), 0);
#ifdef OPACITY
  // What is behind contributes at most a quarter of a level of an 8-bit color.
  bool isOpaque = texel.a > 0.999;
#else
  vec3 light = texel.CHANNELS;
#ifdef DEPTH
  // The buffer contains the optical depth along a direction of the octahedral map, times the cosine
  // between that direction and the normal. The threshold is far above visible optical depths, so
  // that interpolation does not shift shadow edges.
  const float enough = 30.0;
  vec2 corner = gl_FragCoord.xy / vec2(textureSize(slices, 0)) * 2.0 - 1.0;
  vec2 across = vec2(corner.x + corner.y, corner.x - corner.y) * 0.5;
  float along = max(1.0 - abs(across.x) - abs(across.y), 1e-6);
  float slope = along / length(vec3(across, along));
  bool isOpaque = min(min(light.r, light.g), light.b) > enough * slope;
#else
  // A larger threshold would shift the edges of shadows: see getOutside in InterlumeSliceLight.
  bool isOpaque = max(max(light.r, light.g), light.b) < 1e-5;
#endif
#endif
  if (!isOpaque)
  {
    discard;
  }
}
