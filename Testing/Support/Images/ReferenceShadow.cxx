// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Images/ReferenceShadow.h"

namespace reference
{

Double3 GetOpticalDepth(const ReferenceMedium& medium, const Double3& world,
  const Double3& direction, double distance, int refinement)
{
  constexpr double node = 0.28867513459481287; // half of 1 / sqrt(3)
  constexpr double dark = 40.0;
  Double3 depth{};
  double begin = 0.0;
  double end = distance;
  const IndexLine line = medium.GetImage().ToIndex(world, direction);
  if (!medium.GetImage().Cut(line, begin, end) || !medium.Clip(world, direction, begin, end))
  {
    return depth;
  }
  ImageInterpolator::Walk(line, begin, end, medium.GetCuts(line),
    [&](double a, double b)
    {
      const double length = (b - a) / refinement;
      for (int step = 0; step < refinement; ++step)
      {
        const double midpoint = a + (step + 0.5) * length;
        for (double at : { midpoint - node * length, midpoint + node * length })
        {
          const Double3 extinction = medium.GetLightExtinction(line.At(at));
          for (int k = 0; k < 3; ++k)
          {
            depth[k] += 0.5 * length * extinction[k];
          }
        }
      }
      return std::min({ depth[0], depth[1], depth[2] }) < dark;
    });
  return depth;
}

Double3 ToTransmittance(const Double3& depth)
{
  return { { std::exp(-depth[0]), std::exp(-depth[1]), std::exp(-depth[2]) } };
}

}
