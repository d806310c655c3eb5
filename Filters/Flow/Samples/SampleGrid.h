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
 * @brief   creates the samples of vtkImplicitFlowField::SAMPLES_AUTOMATIC
 *
 * If a field has at most MaximumPoints points, its points are the samples. Larger fields get fewer
 * samples, in a dataset of the same type. Image data become a coarser image over the same box.
 * Rectilinear and structured grids keep every n-th point and the last one along each direction.
 * Unstructured grids get the voxels of an image over their bounds. The stride n grows along the
 * direction with the most remaining points until at most MaximumPoints samples remain. Point arrays
 * are copied if samples are points of the field.
 */
class SampleGrid
{
public:
  static constexpr vtkIdType MaximumPoints = 32768;

  /// Computes the extent of the samples from the extent of the field. It is unchanged if the field
  /// has few points, and otherwise begins at 0.
  static void GetExtent(const int field[6], int samples[6]);

  /// Returns the point indices of the samples along each direction. The first index is 0.
  static std::array<std::vector<vtkIdType>, 3> GetIndices(const int field[6]);

  /// Creates the samples for an unstructured grid with many points, from its bounds.
  static vtkSmartPointer<vtkDataSet> MakeVoxels(const double bounds[6]);

  /// Creates the samples. Returns \a field itself if it has few points.
  static vtkSmartPointer<vtkDataSet> Make(vtkDataSet* field);
};

}

#endif
