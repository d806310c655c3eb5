// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Flow/ReferenceCriticalPoints.h"

#include "Support/Checks/ReferenceMessages.h"
#include "Support/Flow/ReferenceFlowGrid.h"

#include "vtkMath.h"
#include "vtkPointData.h"

#include <cmath>

namespace reference
{

const std::vector<MeshKind> ZeroMeshKinds = { MeshKind::Hexahedra, MeshKind::Voxels,
  MeshKind::Wedges, MeshKind::Pyramids, MeshKind::Tetrahedra5, MeshKind::Tetrahedra6,
  MeshKind::Tetrahedra12 };

const std::array<FlowVector, 14> ZeroPositions = { { { { 1.23, 2.41, 0.77 } },
  { { 1.0, 2.41, 0.77 } }, { { 1.23, 2.41, 1.0 } }, { { 1.0, 2.0, 0.77 } }, { { 1.0, 2.37, 1.0 } },
  { { 1.0, 2.0, 1.0 } }, { { 1.5, 2.5, 0.5 } }, { { 1.25, 2.25, 0.5 } }, { { 1.25, 2.25, 0.25 } },
  { { 0.0, 2.41, 0.77 } }, { { 3.0, 4.0, 0.3 } }, { { 0.0, 0.0, 0.0 } }, { { 3.0, 4.0, 2.0 } },
  { { 1.5, 2.5, 1.0 } } } };

double Distance(const double* a, const double* b)
{
  // Unlike a sum of squares, hypot neither underflows nor overflows.
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

double Determinant(const double* m)
{
  return vtkMath::Determinant3x3(m[0], m[1], m[2], m[3], m[4], m[5], m[6], m[7], m[8]);
}

FlowFunction LinearField(const FlowMatrix& matrix, const FlowVector& center)
{
  return [matrix, center](const FlowVector& x) { return Multiply(matrix, x - center); };
}

CriticalPoints::CriticalPoints(vtkDataSet* data)
{
  AllowWarnings(this->Filter);
  this->Filter->SetInputDataObject(data);
  this->Filter->Update();
  this->Output = this->Filter->GetOutput();
}

FlowVector CriticalPoints::GetPosition(vtkIdType i) const
{
  FlowVector x;
  this->Output->GetPoint(i, x.data());
  return x;
}

vtkDataArray* CriticalPoints::GetArray(const char* name) const
{
  return this->Output->GetPointData()->GetArray(name);
}

int CriticalPoints::GetType(vtkIdType i) const
{
  return static_cast<int>(this->GetArray("CriticalPointType")->GetTuple1(i));
}

vtkIdType CriticalPoints::GetCell(vtkIdType i) const
{
  return static_cast<vtkIdType>(this->GetArray("CellId")->GetTuple1(i));
}

}
