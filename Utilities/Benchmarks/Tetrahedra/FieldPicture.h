// SPDX-License-Identifier: BSD-3-Clause
#ifndef FieldPicture_h
#define FieldPicture_h

#include "Support/Pictures/RgbaPicture.h"

#include "vtkCamera.h"
#include "vtkVolumeProperty.h"

#include <array>
#include <functional>

/**
 * The picture of a field that is a formula, in the cube [low, high]^3, without any mesh: in double,
 * by the midpoint rule in so many steps along each line of sight, composited front to back.
 */
reference::RgbaPicture IntegrateField(const std::function<double(double, double, double)>& field,
  double low, double high, vtkVolumeProperty* property, vtkCamera* camera,
  const std::array<int, 2>& size, int steps);

#endif
