// SPDX-License-Identifier: BSD-3-Clause
// Zeros of random cells compared with Newton's method from many start points, two zeros in a cell,
// the sum of indices in random fields, and cells with very different sizes.
#include "Support/AnalyticFlows/ReferenceFlowMaps.h"
#include "Support/Arrays/ReferenceIndices.h"
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceRandom.h"
#include "Support/Flow/ReferenceCriticalPoints.h"
#include "Support/Flow/ReferenceFlowGrid.h"
#include "Support/Meshes/ReferenceLattice.h"
#include "Support/Meshes/ReferenceMesh.h"
#include "Support/Meshes/ReferenceMeshBuilder.h"
#include "Support/Meshes/ReferenceTransform.h"

#include "vtkCell.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace
{

using namespace reference;
using Type = vtkFlowCriticalPoints;

// Returns a cell of the given type, with points displaced by up to \a shake.
vtkSmartPointer<vtkUnstructuredGrid> MakeCell(int type, double shake, Random& random)
{
  const std::vector<FlowVector> box = { { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 1, 1, 0 } },
    { { 0, 1, 0 } }, { { 0, 0, 1 } }, { { 1, 0, 1 } }, { { 1, 1, 1 } }, { { 0, 1, 1 } } };
  std::vector<int> corners;
  switch (type)
  {
    case VTK_TETRA:
      corners = { 0, 1, 3, 4 };
      break;
    case VTK_PYRAMID:
      corners = { 0, 1, 2, 3, 5 };
      break;
    case VTK_WEDGE:
      corners = { 0, 1, 3, 4, 5, 7 };
      break;
    case VTK_VOXEL:
      corners = { 0, 1, 3, 2, 4, 5, 7, 6 };
      break;
    default:
      corners = { 0, 1, 2, 3, 4, 5, 6, 7 };
      break;
  }
  MeshBuilder builder;
  std::vector<vtkIdType> ids;
  for (const int corner : corners)
  {
    const auto moved = random.GetPoint(shake);
    ids.push_back(builder.AddPoint(
      box[corner][0] + moved[0], box[corner][1] + moved[1], box[corner][2] + moved[2]));
  }
  builder.AddCell(type, ids);
  return builder.GetMesh();
}

double GetExcess(int type, const double p[3])
{
  double excess = std::max({ -p[0], -p[1], -p[2], p[0] - 1.0, p[1] - 1.0, p[2] - 1.0 });
  excess = type == VTK_WEDGE ? std::max(excess, p[0] + p[1] - 1.0) : excess;
  return type == VTK_TETRA ? std::max(excess, p[0] + p[1] + p[2] - 1.0) : excess;
}

// Finds the zeros in a cell by Newton's method from a grid of start points, with VTK's shape
// functions. Sets \a isClear to false if a zero is ambiguous.
std::vector<FlowVector> SearchZeros(vtkCell* cell, vtkDataArray* vectors, bool& isClear)
{
  std::vector<FlowVector> zeros;
  const int number = static_cast<int>(cell->GetNumberOfPoints());
  const auto evaluate = [&](const double p[3], double value[3])
  {
    double weights[8];
    cell->InterpolateFunctions(p, weights);
    std::fill_n(value, 3, 0.0);
    for (const auto& [i, j] : AllIndices(number, 3))
    {
      value[j] += weights[i] * vectors->GetComponent(cell->GetPointId(i), j);
    }
  };
  constexpr int starts = 6 * 6 * 6;
  for (int start = 0; start < starts; ++start)
  {
    const int index[3] = { start % 6, start / 6 % 6, start / 36 };
    double p[3] = { (index[0] + 0.5) / 6, (index[1] + 0.5) / 6, (index[2] + 0.5) / 6 };
    double step = 1.0;
    for (int n = 0; n < 40 && step > 1e-14 && GetExcess(VTK_HEXAHEDRON, p) < 2.0; ++n)
    {
      double value[3];
      double jacobian[3][3];
      evaluate(p, value);
      for (int j = 0; j < 3; ++j)
      {
        // The field is linear in each parameter, so the central difference is the exact derivative.
        double ahead[3];
        double behind[3];
        double q[3] = { p[0], p[1], p[2] };
        q[j] = p[j] + 0.5;
        evaluate(q, ahead);
        q[j] = p[j] - 0.5;
        evaluate(q, behind);
        for (int i = 0; i < 3; ++i)
        {
          jacobian[i][j] = ahead[i] - behind[i];
        }
      }
      const double determinant = vtkMath::Determinant3x3(jacobian);
      if (std::abs(determinant) < 1e-14)
      {
        break;
      }
      double inverse[3][3];
      double way[3];
      vtkMath::Invert3x3(jacobian, inverse);
      vtkMath::Multiply3x3(inverse, value, way);
      vtkMath::Subtract(p, way, p);
      step = vtkMath::Norm(way);
    }
    if (step > 1e-12)
    {
      continue;
    }
    // A zero on the cell boundary is ambiguous.
    isClear = isClear && std::abs(GetExcess(cell->GetCellType(), p)) > 1e-7;
    const auto isSame = [&p](const FlowVector& other) { return Distance(other.data(), p) < 1e-6; };
    if (GetExcess(cell->GetCellType(), p) < 0.0 && std::none_of(zeros.begin(), zeros.end(), isSame))
    {
      zeros.push_back({ { p[0], p[1], p[2] } });
    }
  }
  return zeros;
}

void CheckRandomCells(Check& check)
{
  Random random(29);
  for (const int type : { VTK_HEXAHEDRON, VTK_VOXEL, VTK_WEDGE, VTK_PYRAMID, VTK_TETRA })
  {
    const std::string name = "random cells of type " + std::to_string(type);
    int several = 0;
    int total = 0;
    for (int n = 0; n < 1200; ++n)
    {
      auto mesh = MakeCell(type, type == VTK_VOXEL ? 0.0 : 0.1, random);
      // In many random fields, a component has a constant sign, so there is no zero.
      SetVelocity(mesh, [&random](const FlowVector&) { return random.GetPoint(1.0); });
      vtkCell* cell = mesh->GetCell(0);
      bool isClear = true;
      const auto zeros = SearchZeros(cell, mesh->GetPointData()->GetVectors(), isClear);
      if (!isClear)
      {
        continue;
      }
      check.SetContext(name + ", " + std::to_string(n));
      const CriticalPoints result(mesh);
      check.Equal(result.GetNumber(), static_cast<long long>(zeros.size()), "critical points");
      total += static_cast<int>(zeros.size());
      several += zeros.size() > 1 ? 1 : 0;
      for (const FlowVector& p : zeros)
      {
        double x[3];
        double weights[8];
        int part = 0;
        cell->EvaluateLocation(part, p.data(), x, weights);
        double nearest = 1.0;
        vtkIdType found = 0;
        for (vtkIdType i = 0; i < result.GetNumber(); ++i)
        {
          const double distance = Distance(result.GetPosition(i).data(), x);
          found = distance < nearest ? i : found;
          nearest = std::min(nearest, distance);
        }
        check.Near(nearest, 0.0, 1e-9, "position", 1.0);
        if (nearest > 1e-9)
        {
          continue;
        }
        std::vector<double> values;
        for (int i = 0; i < cell->GetNumberOfPoints(); ++i)
        {
          const double* v = mesh->GetPointData()->GetVectors()->GetTuple3(cell->GetPointId(i));
          values.insert(values.end(), v, v + 3);
        }
        double derivatives[9];
        cell->Derivatives(0, p.data(), values.data(), 3, derivatives);
        double size = 0.0;
        for (const double derivative : derivatives)
        {
          size = std::max(size, std::abs(derivative));
        }
        for (int i = 0; i < 9; ++i)
        {
          check.Near(result.GetArray("Jacobian")->GetComponent(found, i), derivatives[i], 1e-7,
            "Jacobian", size);
        }
      }
    }
    check.SetContext(name);
    check.That(total > 20, "there are zeros: " + std::to_string(total));
    check.That(
      several > 0 || type == VTK_TETRA, "cells with several zeros: " + std::to_string(several));
  }
}

// (r - a)(s - b), (s - c)(t - d), (t - e)(r - f) are all 0 only at (a, c, e) and (f, b, d).
void CheckKnownPairs(Check& check)
{
  check.SetContext("two zeros in a cell");
  Random random(31);
  const auto pick = [&random]() { return random.Get(0.02, 0.98); };
  for (int n = 0; n < 100; ++n)
  {
    const double a = pick();
    const double b = pick();
    const double c = pick();
    const double d = pick();
    const double e = pick();
    const double f = pick();
    auto image = MakeImage({ 1, 1, 1 });
    image->SetOrigin(0.0, 0.0, 0.0);
    image->SetSpacing(1.0, 1.0, 1.0);
    SetVelocity(image,
      [&](const FlowVector& x)
      {
        return FlowVector{ { (x[0] - a) * (x[1] - b), (x[1] - c) * (x[2] - d),
          (x[2] - e) * (x[0] - f) } };
      });
    const CriticalPoints result(image);
    check.Equal(result.GetNumber(), 2, "critical points");
    const FlowVector expected[2] = { { { a, c, e } }, { { f, b, d } } };
    for (const FlowVector& position : expected)
    {
      double nearest = 1.0;
      for (vtkIdType i = 0; i < result.GetNumber(); ++i)
      {
        nearest = std::min(nearest, Distance(result.GetPosition(i).data(), position.data()));
      }
      check.Near(nearest, 0.0, 1e-10, "position", 1.0);
    }
  }
  // One zero lies on a face between the parts into which the cell is subdivided.
  for (int n = 0; n < 300; ++n)
  {
    const double half = n % 3 == 0 ? 0.5 : 0.25 * (1 + n % 3);
    const double b = 0.5 + random.Get(0.1, 0.4);
    const double d = 0.5 - random.Get(0.1, 0.4);
    const double f = random.Get(0.8, 0.98);
    check.SetContext(
      "two zeros in a cell, one at " + std::to_string(half) + ", " + std::to_string(n));
    auto image = MakeImage({ 1, 1, 1 });
    image->SetOrigin(0.0, 0.0, 0.0);
    image->SetSpacing(1.0, 1.0, 1.0);
    SetVelocity(image,
      [&](const FlowVector& x)
      {
        return Multiply(GenericMatrix,
          { { (x[0] - half) * (x[1] - b), (x[1] - 0.5) * (x[2] - d),
            (x[2] - half) * (x[0] - f) } });
      });
    check.Equal(CriticalPoints(image).GetNumber(), 2, "critical points");
  }
  check.SetContext("a double zero");
  auto image = MakeImage({ 1, 1, 1 });
  image->SetOrigin(0.0, 0.0, 0.0);
  image->SetSpacing(1.0, 1.0, 1.0);
  for (const double a : { 0.5, 0.3, 0.7123 })
  {
    SetVelocity(image,
      [&](const FlowVector& x) {
        return FlowVector{ { x[0] - x[1], x[0] - x[2], (x[0] - a) * (x[1] - a) } };
      });
    const CriticalPoints result(image);
    check.Equal(result.GetNumber(), 1, "critical points");
    for (vtkIdType i = 0; i < result.GetNumber(); ++i)
    {
      const FlowVector position = { { a, a, a } };
      check.Near(
        Distance(result.GetPosition(i).data(), position.data()), 0.0, 1e-6, "position", 1.0);
      check.Equal(result.GetType(i), Type::DEGENERATE, "type");
    }
  }
}

// The field points outward on the boundary and is random inside. By the Poincare-Hopf theorem, the
// signs of det J add up to 1 for any inner values. The sum detects missing and duplicate zeros.
void CheckIndices(Check& check)
{
  Random random(41);
  for (const MeshKind kind : ZeroMeshKinds)
  {
    check.SetContext("indices, " + GetName(kind));
    vtkIdType total = 0;
    for (int n = 0; n < 6; ++n)
    {
      auto mesh = MakeMesh(kind, { 5, 4, 4 });
      SetVelocity(mesh,
        [&random](const FlowVector& x)
        {
          const bool isOutside =
            x[0] == 0.0 || x[0] == 5.0 || x[1] == 0.0 || x[1] == 4.0 || x[2] == 0.0 || x[2] == 4.0;
          return isOutside ? FlowVector{ { x[0] - 2.5, x[1] - 2.0, x[2] - 2.0 } }
                           : FlowVector(random.GetPoint(1.0));
        });
      const CriticalPoints generic(mesh);
      total += generic.GetNumber();
      long long sum = 0;
      for (vtkIdType i = 0; i < generic.GetNumber(); ++i)
      {
        double jacobian[9];
        generic.GetArray("Jacobian")->GetTuple(i, jacobian);
        sum += Determinant(jacobian) > 0.0 ? 1 : -1;
      }
      check.Equal(sum, 1, "sum of indices");
      check.Equal(generic.Filter->GetReport()->GetCount("DegenerateCells"), 0, "degenerate cells");
      // Zeros at mesh points that share no cell.
      const FlowVector positions[3] = { { { 1, 1, 1 } }, { { 3, 2, 1 } }, { { 2, 3, 3 } } };
      for (FlowVector position : positions)
      {
        mesh->GetPointData()->GetVectors()->SetTuple3(
          mesh->FindPoint(position.data()), 0.0, 0.0, 0.0);
      }
      mesh->Modified();
      const CriticalPoints atPoints(mesh);
      for (const FlowVector& position : positions)
      {
        int found = 0;
        for (vtkIdType i = 0; i < atPoints.GetNumber(); ++i)
        {
          found += Distance(atPoints.GetPosition(i).data(), position.data()) < 1e-9 ? 1 : 0;
        }
        check.Equal(found, 1, "zeros at a point of the mesh");
      }
    }
    check.That(total > 20, "there are zeros: " + std::to_string(total));
  }
}

// CellLength is the cube root of the cell volume, for cells that divide unit boxes, inverted cells,
// and frusta.
void CheckLengths(Check& check)
{
  const std::pair<MeshKind, double> volumes[] = { { MeshKind::Hexahedra, 1.0 },
    { MeshKind::Voxels, 1.0 }, { MeshKind::Wedges, 0.5 }, { MeshKind::Pyramids, 1.0 / 6.0 },
    { MeshKind::Tetrahedra6, 1.0 / 6.0 }, { MeshKind::Tetrahedra12, 1.0 / 12.0 } };
  const auto expect = [&check](vtkDataSet* data, const FlowVector& position, double volume)
  {
    SetVelocity(data, LinearField(GenericMatrix, position));
    const CriticalPoints result(data);
    if (check.Equal(result.GetNumber(), 1, "critical points"))
    {
      const double length = result.GetArray("CellLength")->GetTuple1(0);
      check.Near(length * length * length, volume, 1e-13, "volume");
    }
  };
  for (const auto& one : volumes)
  {
    check.SetContext("volume, " + GetName(one.first));
    auto mesh = MakeMesh(one.first, { 3, 4, 2 });
    expect(mesh, ZeroPositions[0], one.second);
    expect(InvertCells(mesh), ZeroPositions[0], one.second);
  }
  for (const int type : { VTK_HEXAHEDRON, VTK_WEDGE, VTK_PYRAMID })
  {
    check.SetContext("volume of a frustum, " + std::to_string(type));
    Random random(1);
    auto cell = MakeCell(type, 0.0, random);
    for (vtkIdType i = 0; i < cell->GetNumberOfPoints(); ++i)
    {
      double x[3];
      cell->GetPoint(i, x);
      const double scale = 1.0 - 0.5 * x[2];
      cell->GetPoints()->SetPoint(i, scale * x[0], scale * x[1], x[2]);
    }
    const double frustum = (1.0 + 0.5 + 0.25) / 3.0;
    expect(cell, { { 0.35, 0.3, 0.25 } },
      type == VTK_HEXAHEDRON ? frustum : (type == VTK_WEDGE ? 0.5 * frustum : 1.0 / 3.0));
  }
}

}

int TestFlowCriticalPointCells(int, char*[])
{
  return RunChecks({ CheckRandomCells, CheckKnownPairs, CheckIndices, CheckLengths });
}
