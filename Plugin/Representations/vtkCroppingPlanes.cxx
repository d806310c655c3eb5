// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCroppingPlanes.h"

#include "vtkVolumeMapper.h"

void vtkCroppingPlanes(
  vtkVolumeMapper* mapper, const double bounds[6], const double origin[3], const double scale[3])
{
  if (!mapper->GetCropping())
  {
    return;
  }
  double planes[6];
  for (int i = 0; i < 6; ++i)
  {
    planes[i] = origin[i / 2] + bounds[i] * scale[i / 2];
  }
  mapper->SetCroppingRegionPlanes(planes);
}
