// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceMeshBuilder_h
#define ReferenceMeshBuilder_h

#include "vtkCellType.h"         // for the types a caller names
#include "vtkNew.h"              // for the parts
#include "vtkPoints.h"           // for the points
#include "vtkUnstructuredGrid.h" // for the mesh

#include <array>  // for keys
#include <map>    // for points found by key
#include <vector> // for ids

namespace reference
{

/**
 * @class   MeshBuilder
 * @brief   puts an unstructured grid together, points in double
 */
class MeshBuilder
{
public:
  MeshBuilder();

  vtkIdType AddPoint(double x, double y, double z);
  /// The point of an integer key, added at \a scale times the key when new.
  vtkIdType FindOrAddPoint(const std::array<int, 3>& key, const std::array<double, 3>& scale);
  void AddCell(int type, const std::vector<vtkIdType>& ids);
  /// A VTK_POLYHEDRON; the normals of its faces point outward.
  void AddPolyhedron(const std::vector<std::vector<vtkIdType>>& faces);
  vtkSmartPointer<vtkUnstructuredGrid> GetMesh();

private:
  vtkNew<vtkPoints> Points;
  vtkNew<vtkUnstructuredGrid> Mesh;
  std::map<std::array<int, 3>, vtkIdType> Keys;
};

}

#endif
