// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceCriticalPoints_h
#define ReferenceCriticalPoints_h

#include "Support/AnalyticFlows/ReferenceFlowMaps.h" // for vectors and fields
#include "Support/Meshes/ReferenceMesh.h"            // for the kinds

#include "vtkFlowCriticalPoints.h"
#include "vtkNew.h"
#include "vtkPolyData.h" // for the output
#include "vtkSmartPointer.h"

#include <array>
#include <vector>

class vtkDataArray;
class vtkDataSet;

/**
 * Fields whose zeros are known, where they are, and what vtkFlowCriticalPoints finds.
 */
namespace reference
{

/// Those that zeros are looked for in.
extern const std::vector<MeshKind> ZeroMeshKinds;

/// A matrix without any symmetry.
constexpr FlowMatrix GenericMatrix = { { 0.9, -0.4, 0.3, 0.2, 1.1, -0.7, -0.5, 0.6, -0.8 } };

/// In the inside, on faces, edges and points of the cells of a mesh of 3 x 4 x 2 boxes and of what
/// they are split into, and on the outside.
extern const std::array<FlowVector, 14> ZeroPlaces;

double Distance(const double* a, const double* b);

/// Of a matrix of nine entries.
double Determinant(const double* m);

/// matrix (x - center).
FlowFunction LinearField(const FlowMatrix& matrix, const FlowVector& center);

/**
 * @class   CriticalPoints
 * @brief   the critical points of a field's active point vectors
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
