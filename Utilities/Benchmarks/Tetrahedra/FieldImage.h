// SPDX-License-Identifier: BSD-3-Clause
#ifndef FieldImage_h
#define FieldImage_h

#include "Support/Images/RgbaImage.h"

#include "vtkCamera.h"
#include "vtkVolumeProperty.h"

#include <array>
#include <functional>

/**
 * Renders a field given by a formula in the cube [low, high]^3 without a mesh. It integrates in
 * double precision by the midpoint rule with \a steps steps along each view ray, composited front
 * to back.
 */
reference::RgbaImage IntegrateField(const std::function<double(double, double, double)>& field,
  double low, double high, vtkVolumeProperty* property, vtkCamera* camera,
  const std::array<int, 2>& size, int steps);

#endif
