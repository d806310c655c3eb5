// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSliceMedium.h"

vtkSliceMedium::vtkSliceMedium() = default;
vtkSliceMedium::~vtkSliceMedium() = default;
