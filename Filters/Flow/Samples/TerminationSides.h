// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_TerminationSides_h
#define interlume_TerminationSides_h

#include "Advection/AdvectionOptions.h"

#include <map>
#include <vector>

class vtkDataSet;

namespace interlume
{

/**
 * @class   TerminationSides
 * @brief   determines on which side of a termination surface nearby samples lie
 *
 * Nearby samples are the corners of cells that the surface crosses. A surface crosses a cell if the
 * signed distance to the surface has both signs at the corners, and the distances of two corners on
 * different sides add up to at most the cell's diagonal. If a surface has several layers, a cell
 * between two layers may have corners with both signs although no layer crosses the cell. The
 * distances of such corners add up to more than the diagonal. Only the distance of each sample is
 * stored.
 */
class TerminationSides
{
public:
  /// \a options must outlive this object and not change. \a bounds are the bounds of the samples.
  TerminationSides(const AdvectionOptions& options, const double bounds[6]);

  /// Sets the number of samples. New samples have not reached a surface.
  void SetNumberOfSamples(vtkIdType number);

  /// Stores the result for a sample. Threads may call it concurrently for different samples.
  void Add(vtkIdType sample, const double x[3], const AdvectionResult& result);

  /// Returns the samples at corners of cells that a surface crosses, in ascending order. \a ids are
  /// the samples' TerminationIds.
  std::vector<vtkIdType> FindCutCellCorners(vtkDataSet* samples, const int* ids) const;

  /// Returns the value of vtkFlowStatus::SideArray for a sample at \a x. \a velocity must not be
  /// negated for backward streamlines.
  signed char GetSide(vtkIdType sample, int id, const double x[3], const double velocity[3]) const;

private:
  const vtkTerminationSurface* FindNearest(int id, const double x[3], double& distance) const;

  bool IsBackward;
  std::map<int, std::vector<const vtkTerminationSurface*>> Surfaces;
  // Power of 2 that scales the longest side of the samples' bounds to about 1.
  double Scale;
  // Signed distance of each sample from the surface that it reached, scaled so that it fits in a
  // float; NaN if it reached no surface, 0 only if it lies on the surface.
  std::vector<float> Distances;
};

}

#endif
