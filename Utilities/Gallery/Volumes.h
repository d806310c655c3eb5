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
 * Tetrahedra as volumes, drawn by vtkTimeWeightedTetrahedraMapper.
 */
namespace gallery
{
/**
 * How one interval looks: its colour and its extinction, per unit of length.
 */
struct IntervalLook
{
  vtkColor3d Colour;
  double Extinction;
};

/**
 * A volume whose colour and extinction, per unit of length, are functions of point array \a array.
 */
vtkSmartPointer<vtkVolume> MakeVolume(vtkUnstructuredGrid* tetrahedra, const std::string& array,
  vtkColorTransferFunction* colours, vtkPiecewiseFunction* extinction);

/**
 * A volume in which each interval has one colour and extinction; looks[i] is that of cells with
 * `IntervalId` i.
 */
vtkSmartPointer<vtkVolume> MakeVolumeOfIntervals(
  vtkUnstructuredGrid* tetrahedra, const std::vector<IntervalLook>& looks);

/**
 * A volume of vtkTimeVaryingIntervalVolume with the colours that vtkTemporalColorTransferFunction
 * gives to the times of the steps, by point array `Time`; \a extinction per unit of length and
 * time.
 */
vtkSmartPointer<vtkVolume> MakeVolumeInTime(
  vtkUnstructuredGrid* tetrahedra, const std::vector<double>& times, double extinction);

/**
 * Draws boundary triangles over the points of the tetrahedra between the parts of the volume,
 * shaded and glossy; \a opacity 0 to 1.
 */
void SetBoundary(
  vtkVolume* volume, vtkUnstructuredGrid* triangles, const vtkColor3d& colour, double opacity);

/**
 * The mapper of a volume made by one of these.
 */
vtkTimeWeightedTetrahedraMapper* GetMapper(vtkVolume* volume);
}

#endif
