// SPDX-License-Identifier: BSD-3-Clause
// Returns the fraction of light that a projective light's screen transmits, without its image. s is
// a position in homogeneous screen coordinates; uv is where the light ray intersects the screen.
float lightOfScreen(vec4 s, float edgeWidth, float screenOpacity, out vec2 uv)
{
  uv = s.xy / s.w;
  vec2 inside = min(uv, 1.0 - uv);
  if (!(s.w > 0.0 && min(inside.x, inside.y) >= 0.0))
  {
    return 0.0;
  }
  float share = 1.0;
  if (edgeWidth > 0.0)
  {
    vec2 edge = clamp(inside * (2.0 / edgeWidth), 0.0, 1.0);
    edge *= edge * (3.0 - 2.0 * edge);
    share *= edge.x * edge.y;
  }
  return share * screenOpacity;
}
