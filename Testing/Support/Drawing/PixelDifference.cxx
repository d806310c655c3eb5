// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Drawing/PixelDifference.h"

#include "vtkImageData.h"

#include <algorithm>
#include <cstdlib>
#include <ostream>
#include <stdexcept>

namespace interlume
{
PixelDifference ComparePixels(vtkImageData* picture, vtkImageData* baseline, int step)
{
  if (picture->GetScalarType() != VTK_UNSIGNED_CHAR ||
    baseline->GetScalarType() != VTK_UNSIGNED_CHAR)
  {
    throw std::invalid_argument("pictures of unsigned char channels are compared");
  }
  PixelDifference difference;
  int extents[2][3];
  picture->GetDimensions(extents[0]);
  baseline->GetDimensions(extents[1]);
  const int channels = picture->GetNumberOfScalarComponents();
  difference.SameShape = std::equal(extents[0], extents[0] + 3, extents[1]) &&
    channels == baseline->GetNumberOfScalarComponents();
  if (!difference.SameShape || picture->GetNumberOfPoints() == 0)
  {
    return difference;
  }

  const auto* first = static_cast<const unsigned char*>(picture->GetScalarPointer());
  const auto* second = static_cast<const unsigned char*>(baseline->GetScalarPointer());
  const vtkIdType pixels = picture->GetNumberOfPoints();
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
  difference.ShareAboveStep = static_cast<double>(changed) / static_cast<double>(pixels);
  return difference;
}

bool IsWithin(const PixelDifference& difference, const PixelBounds& bounds)
{
  return difference.SameShape && difference.Mean <= bounds.Mean &&
    difference.ShareAboveStep <= bounds.ShareAboveStep;
}

std::ostream& operator<<(std::ostream& os, const PixelDifference& difference)
{
  if (!difference.SameShape)
  {
    return os << "the pictures differ in size or channels";
  }
  return os << "mean " << difference.Mean << "/255, max " << difference.Max
            << "/255, changed pixels " << 100.0 * difference.ShareAboveStep << " %";
}
}
