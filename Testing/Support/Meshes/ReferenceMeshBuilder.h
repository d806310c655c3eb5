// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceMeshBuilder_h
#define ReferenceMeshBuilder_h

#include "vtkCellType.h"         // for cell types
#include "vtkNew.h"              // for the members
#include "vtkPoints.h"           // for the points
#include "vtkUnstructuredGrid.h" // for the mesh

#include <array>  // for keys
#include <map>    // for the search of points
#include <vector> // for ids

namespace reference
{

/**
 * @class   MeshBuilder
 * @brief   builds an unstructured grid with double-precision points
 */
class MeshBuilder
{
public:
  MeshBuilder();

  vtkIdType AddPoint(double x, double y, double z);
  /// Returns the id of the point with the given integer key. If there is none, adds one at \a scale
  /// times \a key.
  vtkIdType FindOrAddPoint(const std::array<int, 3>& key, const std::array<double, 3>& scale);
  void AddCell(int type, const std::vector<vtkIdType>& ids);
  /// Adds a VTK_POLYHEDRON. The normals of its faces must point outward.
  void AddPolyhedron(const std::vector<std::vector<vtkIdType>>& faces);
  vtkSmartPointer<vtkUnstructuredGrid> GetMesh();

private:
  vtkNew<vtkPoints> Points;
  vtkNew<vtkUnstructuredGrid> Mesh;
  std::map<std::array<int, 3>, vtkIdType> Keys;
};

}

#endif
