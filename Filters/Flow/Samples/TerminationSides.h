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
 * @brief   on which side of their surface samples are that are corners of a cell it passes through
 *
 * A surface passes through a cell where its distance changes sign and the distances of two corners
 * on different sides are together no longer than the cell's diagonal: a distance never changes by
 * more than the way. So two layers of one mesh, with the nearer changing between them, are no
 * surface in between. Only the distance of a sample is kept.
 */
class TerminationSides
{
public:
  /// Takes options that must not change while this is used, and the bounds of the samples.
  TerminationSides(const AdvectionOptions& options, const double bounds[6]);

  /// Sets the number of samples; new ones have no surface.
  void SetNumberOfSamples(vtkIdType number);

  /// Notes how a sample ended. Threads may call it at once for different samples.
  void Add(vtkIdType sample, const double x[3], const AdvectionResult& result);

  /// Returns the corners of cells that their surface passes through, ascending; \a ids are the
  /// samples' TerminationId.
  std::vector<vtkIdType> FindCorners(vtkDataSet* samples, const int* ids) const;

  /// Returns the value of vtkFlowStatus::SideArray for a sample at \a x that goes with \a velocity
  /// at first, against it when backward.
  signed char GetSide(vtkIdType sample, int id, const double x[3], const double velocity[3]) const;

private:
  const vtkTerminationSurface* FindNearest(int id, const double x[3], double& distance) const;

  bool IsBackward;
  std::map<int, std::vector<const vtkTerminationSurface*>> Surfaces;
  // The power of 2 by which the samples' longest side is about 1.
  double Scale;
  // The distance of each sample, multiplied by Scale, so that floats have it; NaN without a
  // surface, 0 only on it.
  std::vector<float> Distances;
};

}

#endif
