// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Measures/PictureEdges.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{
using reference::RgbaPicture;

double Red(const RgbaPicture& picture, int i, int j)
{
  return picture.At(i, j)[0];
}

/// Whether the pixels up to \a reach from i on, one way, are alike.
bool IsLevel(const RgbaPicture& picture, int i, int j, int reach, int way, double most)
{
  for (int k = 1; k < reach; ++k)
  {
    if (std::abs(Red(picture, i + way * k, j) - Red(picture, i, j)) >= most)
    {
      return false;
    }
  }
  return true;
}

bool IsFlat(const RgbaPicture& picture, int i, int j, double flat)
{
  for (int k = 0; k < 9; ++k)
  {
    const double other = Red(picture, i + k % 3 - 1, j + k / 3 - 1);
    if (std::abs(other - Red(picture, i, j)) >= flat)
    {
      return false;
    }
  }
  return true;
}
}

EdgeDistances MeasureEdges(const RgbaPicture& found, const RgbaPicture& expected, int reach)
{
  double most = 0.0;
  for (int j = 0; j < expected.Height; ++j)
  {
    for (int i = 0; i < expected.Width; ++i)
    {
      most = std::max(most, Red(expected, i, j));
    }
  }
  EdgeDistances distances;
  for (int j = 0; j < expected.Height; ++j)
  {
    for (int i = reach - 1; i + reach < expected.Width; ++i)
    {
      const double step = Red(expected, i + 1, j) - Red(expected, i, j);
      const double alike = 0.1 * std::abs(step);
      if (std::abs(step) < 0.25 * most || !IsLevel(expected, i, j, reach, -1, alike) ||
        !IsLevel(expected, i + 1, j, reach, 1, alike))
      {
        continue;
      }
      double more = 0.0;
      for (int k = i - reach + 1; k <= i + reach; ++k)
      {
        more += Red(found, k, j) - Red(expected, k, j);
      }
      const double distance = std::abs(more / step);
      ++distances.Edges;
      distances.Mean += distance;
      distances.Largest = std::max(distances.Largest, distance);
    }
  }
  distances.Mean /= std::max(distances.Edges, 1);
  return distances;
}

double MeasureFlat(const RgbaPicture& found, const RgbaPicture& expected, double flat)
{
  std::vector<double> differences;
  for (int j = 1; j + 1 < expected.Height; ++j)
  {
    for (int i = 1; i + 1 < expected.Width; ++i)
    {
      if (IsFlat(expected, i, j, flat))
      {
        differences.push_back(std::abs(Red(found, i, j) - Red(expected, i, j)));
      }
    }
  }
  if (differences.empty())
  {
    return 0.0;
  }
  std::sort(differences.begin(), differences.end());
  return differences[static_cast<std::size_t>(0.95 * (differences.size() - 1))];
}
