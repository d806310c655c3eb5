// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec
//INTERLUME::FEATURES

// Converts a sum or maximum over tetrahedra to a premultiplied color.
in vec2 texCoord;
uniform sampler2D image;
#ifdef LARGEST_SCALAR
uniform samplerBuffer pieces;
uniform samplerBuffer starts;
uniform isamplerBuffer buckets;
uniform float opacityOfExtinction;
#endif

//VTK::Output::Dec

void main()
{
  vec4 sum = texture(image, texCoord);
#ifdef OPTICAL_DEPTH
  if (!(sum.a > 0.0))
  {
    discard;
  }
  float opacity = sum.a < 0.3
    ? sum.a * (1.0 - sum.a * (0.5 - sum.a * (1.0 / 6.0 - sum.a * (1.0 / 24.0 - sum.a / 120.0))))
    : 1.0 - exp(-sum.a);
  gl_FragData[0] = vec4(sum.rgb * (opacity / sum.a), opacity);
#endif
#ifdef LARGEST_SCALAR
  if (sum.r < 0.0)
  {
    discard;
  }
  int piece = texelFetch(buckets, int(sum.r * 1024.0)).x;
  while (sum.r >= texelFetch(starts, piece + 1).x)
  {
    ++piece;
  }
  vec4 color = texelFetch(pieces, 2 * piece) +
    texelFetch(pieces, 2 * piece + 1) * (sum.r - texelFetch(starts, piece).x);
  float opacity = min(color.a * opacityOfExtinction, 1.0);
  gl_FragData[0] = vec4(color.rgb * opacity, opacity);
#endif
}
