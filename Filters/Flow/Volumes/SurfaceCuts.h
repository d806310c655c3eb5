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
 * @brief   what a flow volume has in cells that a termination surface passes through
 *
 * The parts of those cells (CutGrid) are extracted by the levels as whole cells, as those
 * beside them are, then cut at the surface, and joined to what the extraction of all others gave:
 * points of the same edges of the input become one.
 */
class SurfaceCuts
{
public:
  /// Finds the cells. Returns how many of the input's are cut.
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
  /// Extracts, and returns \a mesh, made with its origins, and what the cut cells have.
  vtkSmartPointer<vtkUnstructuredGrid> Join(const Request& request, vtkUnstructuredGrid* mesh);
  /// Of the last Join, by the points of what it returned.
  const SurfaceTriangles& GetTriangles() const { return this->Triangles; }
  /// Takes from a mesh what says what it was made of.
  static void RemoveOrigins(vtkUnstructuredGrid* mesh);
  vtkIdType GetPointsOnSeams() const { return this->PointsOnSeams; }

private:
  struct Origins;
  /// The tetrahedra up to the surfaces, what their points were made of, and the triangles.
  vtkSmartPointer<vtkUnstructuredGrid> Extract(const Request& request, Origins& origins);

  /// By point of what was extracted its id in the joined mesh; \a added: those that are new.
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
