// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Images/RgbaImage.h"

#include "Support/Arrays/ReferenceIndices.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <ostream>

namespace reference
{

RgbaImage::RgbaImage(int width, int height)
  : Width(width)
  , Height(height)
  , Values(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0.0)
{
}

ImageError CompareImages(const RgbaImage& found, const RgbaImage& expected)
{
  constexpr double step = 1e-3;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  ImageError error;
  if (found.Width != expected.Width || found.Height != expected.Height || found.Values.empty())
  {
    error.Max = error.Mean = infinity;
    return error;
  }
  std::size_t above = 0;
  for (const auto& [j, i] : AllIndices(found.Height, found.Width))
  {
    double largest = 0.0;
    for (int channel = 0; channel < 4; ++channel)
    {
      const double difference = std::abs(found.At(i, j)[channel] - expected.At(i, j)[channel]);
      const double distance = std::isfinite(difference) ? difference : infinity;
      largest = std::max(largest, distance);
      error.Mean += distance;
      if (distance > error.Max)
      {
        error.Max = distance;
        error.I = i;
        error.J = j;
        error.Channel = channel;
      }
    }
    above += largest > step ? 1 : 0;
  }
  error.Mean /= static_cast<double>(found.Values.size());
  error.FractionAbove = 4.0 * static_cast<double>(above) / static_cast<double>(found.Values.size());
  return error;
}

std::ostream& operator<<(std::ostream& os, const ImageError& error)
{
  return os << "max " << error.Max << " in channel " << error.Channel << " of pixel " << error.I
            << "," << error.J << ", mean " << error.Mean
            << ", pixels above 1e-3: " << 100.0 * error.FractionAbove << " %";
}

double LargestAlpha(const RgbaImage& image)
{
  double largest = 0.0;
  for (std::size_t at = 3; at < image.Values.size(); at += 4)
  {
    largest = std::max(largest, image.Values[at]);
  }
  return largest;
}

}
