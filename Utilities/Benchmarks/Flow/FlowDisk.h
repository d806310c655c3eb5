// SPDX-License-Identifier: BSD-3-Clause
#ifndef FlowDisk_h
#define FlowDisk_h

#include "vtkFlowVolume.h"
#include "vtkImplicitFlowField.h"
#include "vtkInflowMapping.h"

#include "vtkNew.h"

#include <functional>

/**
 * Stream volumes that start at a disk.
 */
namespace flow
{
/**
 * A disk perpendicular to the x-axis.
 */
struct Disk
{
  double X = 0.0;
  double Y = 0.0;
  double Z = 0.0;
  double Radius = 1.0;

  /// Returns the integral of a function over the disk.
  double Integrate(const std::function<double(const double x[3])>& function) const;
};

/**
 * The implicit stream volume of a disk. Samples are advected backward to the unbounded plane of the
 * disk; the inflow value is the distance from the center of the disk.
 */
struct DiskVolume
{
  /// The caller must set the input of Field.
  explicit DiskVolume(const Disk& disk);

  vtkNew<vtkImplicitFlowField> Field;
  vtkNew<vtkInflowMapping> Mapping;
  vtkNew<vtkFlowVolume> Volume;
};
}

#endif
