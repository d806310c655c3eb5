// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Drawing/PixelDifference.h"

#include "vtkImageData.h"

#include <algorithm>
#include <cstdlib>
#include <ostream>
#include <stdexcept>

namespace interlume
{
PixelDifference ComparePixels(vtkImageData* image, vtkImageData* baseline, int step)
{
  if (image->GetScalarType() != VTK_UNSIGNED_CHAR || baseline->GetScalarType() != VTK_UNSIGNED_CHAR)
  {
    throw std::invalid_argument("ComparePixels: both images must have unsigned char scalars.");
  }
  PixelDifference difference;
  int extents[2][3];
  image->GetDimensions(extents[0]);
  baseline->GetDimensions(extents[1]);
  const int channels = image->GetNumberOfScalarComponents();
  difference.SameShape = std::equal(extents[0], extents[0] + 3, extents[1]) &&
    channels == baseline->GetNumberOfScalarComponents();
  if (!difference.SameShape || image->GetNumberOfPoints() == 0)
  {
    return difference;
  }

  const auto* first = static_cast<const unsigned char*>(image->GetScalarPointer());
  const auto* second = static_cast<const unsigned char*>(baseline->GetScalarPointer());
  const vtkIdType pixels = image->GetNumberOfPoints();
  vtkIdType changed = 0;
  double sum = 0.0;
  for (vtkIdType pixel = 0; pixel < pixels; ++pixel)
  {
    int largest = 0;
    for (int channel = 0; channel < channels; ++channel)
    {
      const int distance = std::abs(*first++ - *second++);
      sum += distance;
      largest = std::max(largest, distance);
    }
    changed += largest > step ? 1 : 0;
    difference.Max = std::max(difference.Max, largest);
  }
  difference.Mean = sum / (static_cast<double>(pixels) * channels);
  difference.FractionAboveStep = static_cast<double>(changed) / static_cast<double>(pixels);
  return difference;
}

bool IsWithin(const PixelDifference& difference, const PixelBounds& bounds)
{
  return difference.SameShape && difference.Mean <= bounds.Mean &&
    difference.FractionAboveStep <= bounds.FractionAboveStep;
}

std::ostream& operator<<(std::ostream& os, const PixelDifference& difference)
{
  if (!difference.SameShape)
  {
    return os << "the images differ in size or number of channels";
  }
  return os << "mean " << difference.Mean << "/255, max " << difference.Max
            << "/255, changed pixels " << 100.0 * difference.FractionAboveStep << " %";
}
}
