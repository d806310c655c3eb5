// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SampleGrid_h
#define interlume_SampleGrid_h

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <array>
#include <vector>

class vtkDataSet;

namespace interlume
{

/**
 * @class   SampleGrid
 * @brief   the samples of vtkImplicitFlowField::SAMPLES_AUTOMATIC: a field's points, or fewer
 *
 * A field of MostPoints points or fewer is its own samples. The samples of a larger field have its
 * type: image data over the same box with fewer points, every n-th point along each direction of a
 * rectilinear or structured grid, its last one too, and the voxels of an image over the bounds of
 * an unstructured grid. n grows along the direction that has most points left, until they are few
 * enough. Point arrays are kept where samples are points of the field.
 */
class SampleGrid
{
public:
  static constexpr vtkIdType MostPoints = 32768;

  /// Computes the extent of the samples of a field with an extent: itself, or another that begins
  /// at 0.
  static void GetExtent(const int field[6], int samples[6]);

  /// Returns the places of the samples in the rows of points along each direction, from 0.
  static std::array<std::vector<vtkIdType>, 3> GetPlaces(const int field[6]);

  /// Makes the samples of an unstructured grid of many points with these bounds.
  static vtkSmartPointer<vtkDataSet> MakeVoxels(const double bounds[6]);

  /// Makes the samples; returns \a field itself where it has few points.
  static vtkSmartPointer<vtkDataSet> Make(vtkDataSet* field);
};

}

#endif
