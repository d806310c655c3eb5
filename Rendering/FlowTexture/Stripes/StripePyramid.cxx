// SPDX-License-Identifier: BSD-3-Clause
#include "Stripes/StripePyramid.h"

#include <algorithm>
#include <cmath>

namespace interlume
{

int StripePyramid::GetNumberOfLevels() const
{
  int levels = 1;
  while (this->NumberOfLines >> levels > 0)
  {
    ++levels;
  }
  return levels;
}

double StripePyramid::GetCoveredLength(double position) const
{
  // A period begins and ends with half a line.
  const double half = 0.5 * this->LineWidth;
  const double period = std::floor(position);
  const double rest = position - period;
  return period * this->LineWidth + std::min(rest, half) + std::max(rest - (1.0 - half), 0.0);
}

std::vector<unsigned char> StripePyramid::GetTexels(int level) const
{
  // An invisible background uses the line color, so that blending does not change the color of
  // edges.
  Color background = this->Background;
  if (background[3] <= 0.0)
  {
    std::copy(this->Line.begin(), this->Line.begin() + 3, background.begin());
  }
  const double shift = (this->Offset - std::floor(this->Offset)) * (this->NumberOfLines >> level);
  std::vector<unsigned char> texels;
  texels.reserve(4 * static_cast<std::size_t>(this->GetLength(level)));
  for (int i = 0; i < this->GetLength(level); ++i)
  {
    const double position = static_cast<double>(i) / this->TexelsPerLine - shift;
    const double coverage = this->TexelsPerLine *
      (this->GetCoveredLength(position + 1.0 / this->TexelsPerLine) -
        this->GetCoveredLength(position));
    for (std::size_t channel = 0; channel < 4; ++channel)
    {
      const double value =
        background[channel] + coverage * (this->Line[channel] - background[channel]);
      texels.push_back(
        static_cast<unsigned char>(std::lround(255.0 * std::clamp(value, 0.0, 1.0))));
    }
  }
  return texels;
}

}
