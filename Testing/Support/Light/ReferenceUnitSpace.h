// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceUnitSpace_h
#define ReferenceUnitSpace_h

#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "Space/UnitSpace.h"

#include <array>

namespace reference
{

/// Returns the unit space of an image with \a size points and cell data, and with a matrix that
/// shears x in proportion to y.
inline interlume::UnitSpace MakeUnitSpace(
  const std::array<int, 3>& size, const std::array<double, 3>& spacing, double shear = 0.0)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(size.data());
  image->SetSpacing(spacing.data());
  vtkNew<vtkMatrix4x4> matrix;
  matrix->SetElement(0, 1, shear);
  interlume::UnitSpace space;
  static_cast<void>(space.Set(image, true, matrix));
  return space;
}

}

#endif
