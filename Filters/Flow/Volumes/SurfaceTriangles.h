// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SurfaceTriangles_h
#define interlume_SurfaceTriangles_h

#include "vtkType.h"

#include <array>
#include <vector>

class vtkUnstructuredGrid;

namespace interlume
{

class SurfaceLevels;

/**
 * @class   SurfaceTriangles
 * @brief   the triangles of surfaces inside tetrahedra, each once
 *
 * All triangles face against the gradient of the function they are a level set of: to the side of
 * lower values.
 */
class SurfaceTriangles
{
public:
  using Triangle = std::array<vtkIdType, 3>;

  /**
   * Takes the boundary of an extraction by the items of \a levels. A triangle that two items have
   * in common is taken from the first.
   */
  void Take(vtkUnstructuredGrid* boundary, const SurfaceLevels& levels);

  /**
   * Removes triangles that are faces of no tetrahedron of \a mesh, which occur where values equal
   * to a bound make an interval touch a face of the domain from outside.
   */
  void RemoveLoose(vtkUnstructuredGrid* mesh);

  /**
   * Keeps the parts of the triangles, faces of the tetrahedra \a before, that are left after an
   * extraction from these, made with its origins: faces of the tetrahedra \a after.
   */
  void Cut(vtkUnstructuredGrid* before, vtkUnstructuredGrid* after);

  /// Gives the points of the triangles other ids.
  void Renumber(const std::vector<vtkIdType>& ids);
  /// Adds the triangles of another object.
  void Append(const SurfaceTriangles& other);

  const std::vector<Triangle>& GetTriangles() const { return this->Triangles; }
  /// Returns the surface of each triangle, as in SurfaceLevels::GetSurface.
  const std::vector<int>& GetSurfaces() const { return this->Surfaces; }

private:
  void RemoveCopies(vtkIdType numberOfPoints);
  /// Keeps the triangles for which \a keep, called with the index of each in turn, returns true.
  template <typename Keep>
  void Filter(const Keep& keep);
  /// Finds for each triangle the first tetrahedron that it is a face of; -1 without one.
  std::vector<vtkIdType> FindOwners(vtkUnstructuredGrid* before) const;

  std::vector<Triangle> Triangles;
  std::vector<int> Surfaces;
};

}

#endif
