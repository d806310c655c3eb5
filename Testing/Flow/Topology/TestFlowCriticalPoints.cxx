// SPDX-License-Identifier: BSD-3-Clause
// Known zeros of linear and trilinear fields are found without duplicates, on all kinds of grids
// and at various scales, including zeros on faces, edges and points.
#include "Support/AnalyticFlows/ReferenceFlowMaps.h"
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Flow/ReferenceCriticalPoints.h"
#include "Support/Meshes/ReferenceLattice.h"
#include "Support/Meshes/ReferenceMesh.h"
#include "Support/Meshes/ReferenceTransform.h"

#include "vtkCell.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace
{

using namespace reference;

// Returns whether a voxel contains a position. VTK's own function fails for voxels of rotated
// images.
bool IsInVoxel(vtkCell* cell, const double x[3])
{
  if (cell->GetCellType() != VTK_VOXEL)
  {
    return false;
  }
  double corner[3];
  double opposite[3];
  cell->GetPoints()->GetPoint(0, corner);
  cell->GetPoints()->GetPoint(7, opposite);
  const double midpoint[3] = { 0.5 * (corner[0] + opposite[0]), 0.5 * (corner[1] + opposite[1]),
    0.5 * (corner[2] + opposite[2]) };
  return Distance(midpoint, x) <= (0.5 + 1e-9) * Distance(corner, opposite);
}

// Checks the single zero of a linear field.
void CheckLinear(
  vtkDataSet* data, const FlowMatrix& matrix, const FlowVector& center, double scale, Check& check)
{
  double size = 0.0;
  for (double entry : matrix)
  {
    size = std::max(size, std::abs(entry));
  }
  SetVelocity(data, LinearField(matrix, center));
  const CriticalPoints result(data);
  check.Equal(result.GetNumber(), 1, "critical points");
  check.Equal(result.Output->GetNumberOfVerts(), result.GetNumber(), "vertices");
  for (vtkIdType i = 0; i < result.GetNumber(); ++i)
  {
    check.Near(
      Distance(result.GetPosition(i).data(), center.data()), 0.0, 1e-11, "position", scale);
    for (int j = 0; j < 9; ++j)
    {
      check.Near(
        result.GetArray("Jacobian")->GetComponent(i, j), matrix[j], 1e-11, "Jacobian", size);
    }
    const vtkIdType cell = result.GetCell(i);
    double p[3];
    double weights[8];
    double closest[3];
    double distance2 = 0.0;
    int part = 0;
    double point[3];
    std::copy_n(center.data(), 3, point);
    const int isInside =
      data->GetCell(cell)->EvaluatePosition(point, closest, part, p, distance2, weights);
    check.That(
      isInside == 1 || distance2 < 1e-16 * scale * scale || IsInVoxel(data->GetCell(cell), point),
      "the zero lies in its cell");
    // No cell with a lower id contains the zero. Voxels are not checked, because VTK's function
    // fails for rotated voxels.
    for (vtkIdType lower = 0; lower < cell; ++lower)
    {
      const int isThere =
        data->GetCell(lower)->EvaluatePosition(point, closest, part, p, distance2, weights);
      check.That(isThere != 1 || data->GetCellType(lower) == VTK_VOXEL,
        "the first cell that contains the zero is reported");
    }
  }
  check.Equal(result.Filter->GetReport()->GetCount("ZeroCells") +
      result.Filter->GetReport()->GetCount("DegenerateCells") +
      result.Filter->GetReport()->GetCount("NonFiniteCells"),
    0, "invalid cell ids");
}

void CheckLocations(Check& check)
{
  const FlowMatrix skew = { { 0.8, 0.3, -0.2, -0.1, 1.2, 0.4, 0.25, -0.3, 0.7 } };
  for (const MeshKind kind : ZeroMeshKinds)
  {
    for (const FlowVector& position : ZeroPositions)
    {
      check.SetContext(GetName(kind) + " at " + std::to_string(position[0]) + " " +
        std::to_string(position[1]) + " " + std::to_string(position[2]));
      auto mesh = MakeMesh(kind, { 3, 4, 2 });
      CheckLinear(mesh, GenericMatrix, position, 1.0, check);
      CheckLinear(RotateCellPointOrder(mesh, 3), GenericMatrix, position, 1.0, check);
      CheckLinear(InvertCells(mesh), GenericMatrix, position, 1.0, check);
      if (kind == MeshKind::Voxels)
      {
        continue;
      }
      for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
      {
        FlowVector x;
        mesh->GetPoint(i, x.data());
        mesh->GetPoints()->SetPoint(i, Multiply(skew, x).data());
      }
      CheckLinear(mesh, GenericMatrix, Multiply(skew, position), 1.0, check);
    }
  }
  auto image = MakeImage({ 5, 4, 3 });
  auto turned = MakeImage({ 5, 4, 3 });
  turned->SetDirectionMatrix(0.36, 0.48, -0.8, -0.8, 0.6, 0, 0.48, 0.64, 0.6);
  for (vtkImageData* lattice : { image.Get(), turned.Get() })
  {
    for (const DataSetVariant& form : FormsOf(lattice))
    {
      check.SetContext(form.Name);
      for (const vtkIdType point : { 0, 37, 61, 119 })
      {
        FlowVector x;
        lattice->GetPoint(point, x.data());
        CheckLinear(form.Data, GenericMatrix, x, 1.0, check);
      }
      double inside[3] = { 0.3, 1.0, 0.6 };
      FlowVector x;
      double origin[3];
      double next[3];
      lattice->GetPoint(0, origin);
      std::copy_n(origin, 3, x.data());
      const vtkIdType steps[3] = { 1, 6, 30 };
      for (int j = 0; j < 3; ++j)
      {
        lattice->GetPoint(steps[j], next);
        for (int i = 0; i < 3; ++i)
        {
          x[i] += inside[j] * (next[i] - origin[i]);
        }
      }
      CheckLinear(form.Data, GenericMatrix, x, 1.0, check);
    }
  }
}

void CheckScales(Check& check)
{
  for (const MeshKind kind : { MeshKind::Hexahedra, MeshKind::Pyramids, MeshKind::Tetrahedra6 })
  {
    for (const double length : { 1e-12, 1.0, 1e12 })
    {
      for (const double speed : { 1e-12, 1.0, 1e12, 1e-200, 1e200 })
      {
        check.SetContext(GetName(kind) + ", length " + std::to_string(std::log10(length)) +
          ", speed " + std::to_string(std::log10(speed)));
        for (const FlowVector& position : { ZeroPositions[0], ZeroPositions[5] })
        {
          auto mesh = MakeMesh(kind, { 3, 4, 2 });
          for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
          {
            double x[3];
            mesh->GetPoint(i, x);
            vtkMath::MultiplyScalar(x, length);
            mesh->GetPoints()->SetPoint(i, x);
          }
          FlowMatrix matrix = GenericMatrix;
          for (double& entry : matrix)
          {
            entry *= speed / length;
          }
          CheckLinear(mesh, matrix,
            { { length * position[0], length * position[1], length * position[2] } }, length,
            check);
        }
      }
    }
  }
  // Components with very different scales.
  check.SetContext("components with different scales");
  CheckLinear(MakeMesh(MeshKind::Hexahedra, { 3, 4, 2 }),
    { { 1e9, 2e9, 3e9, -1.0, 1.0, 0.5, 2e-9, -1e-9, 1e-9 } }, ZeroPositions[0], 1.0, check);
}

}

int TestFlowCriticalPoints(int, char*[])
{
  return RunChecks({ CheckLocations, CheckScales });
}
