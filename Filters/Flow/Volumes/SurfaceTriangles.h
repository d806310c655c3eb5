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
 * @brief   distinct triangles of surfaces inside a tetrahedral mesh
 *
 * The surfaces are level sets of a function. All triangles face against its gradient, toward lower
 * values.
 */
class SurfaceTriangles
{
public:
  using Triangle = std::array<vtkIdType, 3>;

  /**
   * Reads the boundary triangles of an extraction whose intervals are the items of \a levels. A
   * triangle shared by two items is assigned to the first item.
   */
  void Take(vtkUnstructuredGrid* boundary, const SurfaceLevels& levels);

  /**
   * Removes triangles that are not faces of tetrahedra of \a mesh. They occur if an interval only
   * touches a face of the domain, because the values on the face equal a bound of the interval.
   */
  void RemoveTrianglesNotInMesh(vtkUnstructuredGrid* mesh);

  /**
   * Replaces the triangles, which are faces of the tetrahedra \a before, with their parts that
   * remain in the tetrahedra \a after. \a after is an extraction from \a before and must have
   * origin arrays.
   */
  void Cut(vtkUnstructuredGrid* before, vtkUnstructuredGrid* after);

  /// Replaces each point id p of the triangles with ids[p].
  void Renumber(const std::vector<vtkIdType>& ids);
  void Append(const SurfaceTriangles& other);

  const std::vector<Triangle>& GetTriangles() const { return this->Triangles; }
  /// Returns the index of the surface of each triangle. See SurfaceLevels::GetSurface().
  const std::vector<int>& GetSurfaces() const { return this->Surfaces; }

private:
  void RemoveCopies(vtkIdType numberOfPoints);
  /// Keeps the triangles for which \a keep, called with ascending indices, returns true.
  template <typename Keep>
  void Filter(const Keep& keep);
  /// Returns, for each triangle, the first tetrahedron that has it as a face, or -1.
  std::vector<vtkIdType> FindOwners(vtkUnstructuredGrid* before) const;

  std::vector<Triangle> Triangles;
  std::vector<int> Surfaces;
};

}

#endif
