#include "Mesh/TetrahedronMath.h"

#include <algorithm>
#include <cmath>

namespace interlume
{

namespace TetrahedronMath
{

double PolarSine(const double* a, const double* b, const double* c, const double* d)
{
  const Vector e = Difference(b, a);
  const Vector f = Difference(c, a);
  const Vector g = Difference(d, a);
  const double lengths = std::sqrt(Dot(e, e)) * std::sqrt(Dot(f, f)) * std::sqrt(Dot(g, g));
  return lengths > 0.0 ? Dot(e, Cross(f, g)) / lengths : 0.0;
}

double RadiusEdgeRatio(const double* a, const double* b, const double* c, const double* d)
{
  const Vector e = Difference(b, a);
  const Vector f = Difference(c, a);
  const Vector g = Difference(d, a);
  const Vector fg = Cross(f, g);
  const Vector ge = Cross(g, e);
  const Vector ef = Cross(e, f);
  const double determinant = Dot(e, fg);
  Vector center;
  for (int axis = 0; axis < 3; ++axis)
  {
    center[axis] =
      (Dot(e, e) * fg[axis] + Dot(f, f) * ge[axis] + Dot(g, g) * ef[axis]) / (2.0 * determinant);
  }
  const Vector fe = Difference(c, b);
  const Vector gf = Difference(d, c);
  const Vector eg = Difference(b, d);
  const double shortest =
    std::min({ Dot(e, e), Dot(f, f), Dot(g, g), Dot(fe, fe), Dot(gf, gf), Dot(eg, eg) });
  return std::sqrt(Dot(center, center) / shortest);
}

}

}
