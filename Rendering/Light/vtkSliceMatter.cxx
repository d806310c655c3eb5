// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSliceMatter.h"

vtkSliceMatter::~vtkSliceMatter() = default;
