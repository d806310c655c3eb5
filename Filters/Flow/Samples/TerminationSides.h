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
 * surface in between. All that is kept of a sample is its distance.
 */
class TerminationSides
{
public:
  /// \a options are to stay as they are.
  explicit TerminationSides(const AdvectionOptions& options);

  /// The samples there are; new ones have no surface.
  void SetNumberOfSamples(vtkIdType number);

  /// Tells how a sample ended. By threads, for different samples.
  void Add(vtkIdType sample, const double x[3], const AdvectionResult& result);

  /// The corners of cells that their surface passes through, ascending; \a ids are the samples'
  /// TerminationId.
  std::vector<vtkIdType> FindCorners(vtkDataSet* samples, const int* ids) const;

  /// What vtkFlowStatus::SideArray has of a sample at \a x that goes with \a velocity at first,
  /// against it when backward.
  signed char GetSide(vtkIdType sample, int id, const double x[3], const double velocity[3]) const;

private:
  const vtkTerminationSurface* FindNearest(int id, const double x[3], double& distance) const;

  bool IsBackward;
  std::map<int, std::vector<const vtkTerminationSurface*>> Surfaces;
  // NaN without a surface, 0 only on it.
  std::vector<float> Distances;
};

}

#endif
