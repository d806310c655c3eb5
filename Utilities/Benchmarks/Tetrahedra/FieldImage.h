// SPDX-License-Identifier: BSD-3-Clause
#ifndef FieldImage_h
#define FieldImage_h

#include "Support/Images/RgbaImage.h"

#include "vtkCamera.h"
#include "vtkVolumeProperty.h"

#include <array>
#include <functional>

/**
 * Renders a field in the cube [low, high]^3 from its formula, without a mesh. Integrates along each
 * view ray in double precision, front to back, using the midpoint rule with \a steps steps.
 */
reference::RgbaImage RenderField(const std::function<double(double, double, double)>& field,
  double low, double high, vtkVolumeProperty* property, vtkCamera* camera,
  const std::array<int, 2>& size, int steps);

#endif
