// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SurfaceCuts_h
#define interlume_SurfaceCuts_h

#include "Samples/ImplicitFlowArrays.h"
#include "Volumes/CutGrid.h"
#include "Volumes/InterpolableCells.h"
#include "Volumes/SurfaceTriangles.h"

#include "vtkSmartPointer.h"

#include <vector>

class vtkDataSet;
class vtkUnstructuredGrid;

namespace interlume
{

class SurfaceLevels;

/**
 * @class   SurfaceCuts
 * @brief   extracts a flow volume in cells that a termination surface crosses
 *
 * The copies of these cells (CutGrid) are first extracted like uncut cells, so that they are
 * consistent with adjacent cells. They are then cut at the surface and joined to the extraction of
 * all other cells. Common points on input edges are merged.
 */
class SurfaceCuts
{
public:
  /// Finds the input cells that are cut, and returns their number.
  vtkIdType Prepare(vtkDataSet* input, const ImplicitFlowArrays& arrays,
    const InterpolableCells& cells, const InterpolableCells::Limits& limits);
  bool IsEmpty() const { return !this->Grid; }

  struct Request
  {
    const char* Scalars = nullptr;
    const SurfaceLevels* Levels = nullptr;
    int Precision = 0;
    bool GenerateTriangles = false;
  };
  /// Extracts the parts of the cut cells and joins them with \a mesh, which must have origin
  /// arrays.
  vtkSmartPointer<vtkUnstructuredGrid> Join(const Request& request, vtkUnstructuredGrid* mesh);
  /// Returns the triangles of the last Join(), with point ids of the returned mesh.
  const SurfaceTriangles& GetTriangles() const { return this->Triangles; }
  /// Removes the origin arrays from a mesh.
  static void RemoveOrigins(vtkUnstructuredGrid* mesh);
  vtkIdType GetNumberOfPointsOnSeams() const { return this->PointsOnSeams; }

private:
  struct Origins;
  /// Returns the tetrahedra of the cut cells, cut at the surfaces, or null if there are none. Also
  /// computes the origins of their points, and the triangles.
  vtkSmartPointer<vtkUnstructuredGrid> Extract(const Request& request, Origins& origins);

  /// Finds the id of each extracted point in the joined mesh. \a added receives the new points.
  static std::vector<vtkIdType> FindIds(
    vtkUnstructuredGrid* mesh, const Origins& origins, std::vector<vtkIdType>& added);

  interlume::CutGrid CutGrid;
  vtkSmartPointer<vtkUnstructuredGrid> Grid;
  ImplicitFlowArrays Arrays;
  InterpolableCells Cells;
  SurfaceTriangles Triangles;
  vtkIdType PointsOnSeams = 0;
};

}

#endif
