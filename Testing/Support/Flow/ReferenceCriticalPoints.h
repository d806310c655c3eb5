// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceCriticalPoints_h
#define ReferenceCriticalPoints_h

#include "Support/AnalyticFlows/ReferenceFlowMaps.h" // for vectors and fields
#include "Support/Meshes/ReferenceMesh.h"            // for MeshKind

#include "vtkFlowCriticalPoints.h"
#include "vtkNew.h"
#include "vtkPolyData.h" // for the output
#include "vtkSmartPointer.h"

#include <array>
#include <vector>

class vtkDataArray;
class vtkDataSet;

/**
 * Vector fields with known critical points, and a wrapper for vtkFlowCriticalPoints.
 */
namespace reference
{

/// Kinds of meshes in which tests search for critical points.
extern const std::vector<MeshKind> ZeroMeshKinds;

/// A matrix without any symmetry.
constexpr FlowMatrix GenericMatrix = { { 0.9, -0.4, 0.3, 0.2, 1.1, -0.7, -0.5, 0.6, -0.8 } };

/// Positions of zeros in a mesh of 3 x 4 x 2 unit boxes: inside cells, on faces, edges and points
/// of cells and of their tetrahedra, and on the boundary of the mesh.
extern const std::array<FlowVector, 14> ZeroPositions;

double Distance(const double* a, const double* b);

/// Returns the determinant of a 3 x 3 matrix.
double Determinant(const double* m);

/// Returns the field v(x) = \a matrix * (x - \a center).
FlowFunction LinearField(const FlowMatrix& matrix, const FlowVector& center);

/**
 * @class   CriticalPoints
 * @brief   critical points that vtkFlowCriticalPoints finds in the active point vectors of a
 * dataset
 */
class CriticalPoints
{
public:
  explicit CriticalPoints(vtkDataSet* data);

  vtkIdType GetNumber() const { return this->Output->GetNumberOfPoints(); }
  FlowVector GetPosition(vtkIdType i) const;
  vtkDataArray* GetArray(const char* name) const;
  int GetType(vtkIdType i) const;
  vtkIdType GetCell(vtkIdType i) const;

  vtkNew<vtkFlowCriticalPoints> Filter;
  vtkSmartPointer<vtkPolyData> Output;
};

}

#endif
