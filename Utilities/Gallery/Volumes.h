// SPDX-License-Identifier: BSD-3-Clause
#ifndef Volumes_h
#define Volumes_h

#include "vtkColor.h"
#include "vtkSmartPointer.h"
#include "vtkVolume.h"

#include <string>
#include <vector>

class vtkColorTransferFunction;
class vtkPiecewiseFunction;
class vtkTimeWeightedTetrahedraMapper;
class vtkUnstructuredGrid;

/**
 * Volumes of tetrahedra, rendered by vtkTimeWeightedTetrahedraMapper.
 */
namespace gallery
{
/**
 * Color of an interval, and its extinction per unit of length.
 */
struct IntervalLook
{
  vtkColor3d Color;
  double Extinction;
};

/**
 * Returns a volume whose color and extinction (per unit of length) are functions of the point array
 * \a array.
 */
vtkSmartPointer<vtkVolume> MakeVolume(vtkUnstructuredGrid* tetrahedra, const std::string& array,
  vtkColorTransferFunction* colors, vtkPiecewiseFunction* extinction);

/**
 * Returns a volume with one color and extinction per interval: looks[i] applies to cells with
 * `IntervalId` i.
 */
vtkSmartPointer<vtkVolume> MakeVolumeOfIntervals(
  vtkUnstructuredGrid* tetrahedra, const std::vector<IntervalLook>& looks);

/**
 * Returns a volume of the tetrahedra of vtkTimeVaryingIntervalVolume. A
 * vtkTemporalColorTransferFunction of the step times maps the point array `Time` to colors.
 * \a extinction is per unit of length and time.
 */
vtkSmartPointer<vtkVolume> MakeTimeColoredVolume(
  vtkUnstructuredGrid* tetrahedra, const std::vector<double>& times, double extinction);

/**
 * Draws boundary triangles inside the volume, shaded and glossy. The triangles must share the
 * points of the tetrahedra. \a opacity ranges from 0 to 1.
 */
void SetBoundary(
  vtkVolume* volume, vtkUnstructuredGrid* triangles, const vtkColor3d& color, double opacity);

/**
 * Returns the mapper of a volume created by MakeVolume(), MakeVolumeOfIntervals() or
 * MakeTimeColoredVolume().
 */
vtkTimeWeightedTetrahedraMapper* GetMapper(vtkVolume* volume);
}

#endif
