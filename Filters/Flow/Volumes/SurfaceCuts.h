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
 * @brief   the part of a flow volume in cells that a termination surface passes through
 *
 * The parts of those cells (CutGrid) are extracted by the levels as whole cells, as those
 * beside them are, then cut at the surface, and joined to what the extraction of all others gave:
 * points of the same edges of the input become one.
 */
class SurfaceCuts
{
public:
  /// Finds the cells. Returns how many of the input's cells are cut.
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
  /// Extracts the parts of the cut cells, and returns \a mesh, made with its origins, joined with
  /// them.
  vtkSmartPointer<vtkUnstructuredGrid> Join(const Request& request, vtkUnstructuredGrid* mesh);
  /// Returns the triangles of the last Join, by the points of the mesh that it returned.
  const SurfaceTriangles& GetTriangles() const { return this->Triangles; }
  /// Removes from a mesh the arrays that tell where it comes from.
  static void RemoveOrigins(vtkUnstructuredGrid* mesh);
  vtkIdType GetPointsOnSeams() const { return this->PointsOnSeams; }

private:
  struct Origins;
  /// Extracts the tetrahedra up to the surfaces, the origins of their points, and the triangles.
  vtkSmartPointer<vtkUnstructuredGrid> Extract(const Request& request, Origins& origins);

  /// Finds for each extracted point its id in the joined mesh; \a added gets the new points.
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
