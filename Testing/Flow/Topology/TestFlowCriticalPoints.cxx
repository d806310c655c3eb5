// Known zeros of linear and trilinear fields on all kinds of grids, also on faces, edges and
// points, once each; random cells against Newton's method from many places; the sum of indices in
// random fields; types by constructed eigenvalues; scales; zeros that are not isolated; blanked
// cells and NaN; threads, progress, abort, errors.
#include "Flows/ReferenceFlowMaps.h"
#include "Reference/Checks/ReferenceCheck.h"
#include "Reference/Checks/ReferenceMessages.h"
#include "Reference/Checks/ReferenceProgress.h"
#include "Reference/Checks/ReferenceRandom.h"
#include "Reference/Checks/ReferenceThreads.h"
#include "Reference/Meshes/ReferenceLattice.h"
#include "Reference/Meshes/ReferenceMesh.h"
#include "Reference/Meshes/ReferenceMeshBuilder.h"
#include "Reference/Meshes/ReferenceTransform.h"

#include "vtkAnalyticFlowSource.h"
#include "vtkCell.h"
#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFlowCriticalPoints.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <string>
#include <vector>

namespace
{

using namespace reference;
using Type = vtkFlowCriticalPoints;

const std::vector<MeshKind> Kinds = { MeshKind::Hexahedra, MeshKind::Voxels, MeshKind::Wedges,
  MeshKind::Pyramids, MeshKind::Tetrahedra5, MeshKind::Tetrahedra6, MeshKind::Tetrahedra12 };

FlowVector Subtract(const FlowVector& a, const FlowVector& b)
{
  return { { a[0] - b[0], a[1] - b[1], a[2] - b[2] } };
}

double Distance(const double* a, const double* b)
{
  return std::sqrt(vtkMath::Distance2BetweenPoints(a, b));
}

double Determinant(const double* m)
{
  return vtkMath::Determinant3x3(m[0], m[1], m[2], m[3], m[4], m[5], m[6], m[7], m[8]);
}

struct Result
{
  vtkNew<vtkFlowCriticalPoints> Filter;
  vtkSmartPointer<vtkPolyData> Output;

  explicit Result(vtkDataSet* data)
  {
    ExpectWarnings(this->Filter);
    this->Filter->SetInputDataObject(data);
    this->Filter->Update();
    this->Output = this->Filter->GetOutput();
  }
  vtkIdType GetNumber() const { return this->Output->GetNumberOfPoints(); }
  FlowVector GetPosition(vtkIdType i) const
  {
    FlowVector x;
    this->Output->GetPoint(i, x.data());
    return x;
  }
  vtkDataArray* GetArray(const char* name) const
  {
    return this->Output->GetPointData()->GetArray(name);
  }
  int GetType(vtkIdType i) const
  {
    return static_cast<int>(this->GetArray("CriticalPointType")->GetTuple1(i));
  }
  vtkIdType GetCell(vtkIdType i) const
  {
    return static_cast<vtkIdType>(this->GetArray("CellId")->GetTuple1(i));
  }
};

FlowFunction Linear(const FlowMatrix& matrix, const FlowVector& center)
{
  return [matrix, center](const FlowVector& x) { return Multiply(matrix, Subtract(x, center)); };
}

// VTK does not find places in the voxels of turned images: no farther than the corners from the
// middle.
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
  const double middle[3] = { 0.5 * (corner[0] + opposite[0]), 0.5 * (corner[1] + opposite[1]),
    0.5 * (corner[2] + opposite[2]) };
  return Distance(middle, x) <= (0.5 + 1e-9) * Distance(corner, opposite);
}

// The one zero of a linear field.
void CheckLinear(
  vtkDataSet* data, const FlowMatrix& matrix, const FlowVector& center, double scale, Check& check)
{
  double size = 0.0;
  for (double entry : matrix)
  {
    size = std::max(size, std::abs(entry));
  }
  SetVelocity(data, Linear(matrix, center));
  const Result result(data);
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
      "it is in its cell");
    // VTK takes what is a little outside for inside, which no place is.
    for (vtkIdType lower = 0; lower < cell; ++lower)
    {
      const int isThere =
        data->GetCell(lower)->EvaluatePosition(point, closest, part, p, distance2, weights);
      check.That(isThere != 1 || data->GetCellType(lower) == VTK_VOXEL, "no cell before has it");
    }
  }
  check.Equal(result.Filter->GetNumberOfZeroCells() + result.Filter->GetNumberOfDegenerateCells() +
      result.Filter->GetNumberOfNonFiniteCells(),
    0, "cells that are not right");
}

constexpr FlowMatrix Generic = { { 0.9, -0.4, 0.3, 0.2, 1.1, -0.7, -0.5, 0.6, -0.8 } };

// In the inside, on faces, edges and points of boxes and of what they are split into, and on the
// outside.
const FlowVector Places[] = { { { 1.23, 2.41, 0.77 } }, { { 1.0, 2.41, 0.77 } },
  { { 1.23, 2.41, 1.0 } }, { { 1.0, 2.0, 0.77 } }, { { 1.0, 2.37, 1.0 } }, { { 1.0, 2.0, 1.0 } },
  { { 1.5, 2.5, 0.5 } }, { { 1.25, 2.25, 0.5 } }, { { 1.25, 2.25, 0.25 } }, { { 0.0, 2.41, 0.77 } },
  { { 3.0, 4.0, 0.3 } }, { { 0.0, 0.0, 0.0 } }, { { 3.0, 4.0, 2.0 } }, { { 1.5, 2.5, 1.0 } } };

void CheckPlaces(Check& check)
{
  const FlowMatrix skew = { { 0.8, 0.3, -0.2, -0.1, 1.2, 0.4, 0.25, -0.3, 0.7 } };
  for (const MeshKind kind : Kinds)
  {
    for (const FlowVector& place : Places)
    {
      check.SetContext(GetName(kind) + " at " + std::to_string(place[0]) + " " +
        std::to_string(place[1]) + " " + std::to_string(place[2]));
      auto mesh = MakeMesh(kind, { 3, 4, 2 });
      CheckLinear(mesh, Generic, place, 1.0, check);
      CheckLinear(TurnCells(mesh, 3), Generic, place, 1.0, check);
      CheckLinear(InvertCells(mesh), Generic, place, 1.0, check);
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
      CheckLinear(mesh, Generic, Multiply(skew, place), 1.0, check);
    }
  }
  auto image = MakeImage({ 5, 4, 3 });
  auto turned = MakeImage({ 5, 4, 3 });
  turned->SetDirectionMatrix(0.36, 0.48, -0.8, -0.8, 0.6, 0, 0.48, 0.64, 0.6);
  for (vtkImageData* lattice : { image.Get(), turned.Get() })
  {
    for (const LatticeForm& form : FormsOf(lattice))
    {
      check.SetContext(form.Name);
      for (const vtkIdType point : { 0, 37, 61, 119 })
      {
        FlowVector x;
        lattice->GetPoint(point, x.data());
        CheckLinear(form.Data, Generic, x, 1.0, check);
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
      CheckLinear(form.Data, Generic, x, 1.0, check);
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
        for (const FlowVector& place : { Places[0], Places[5] })
        {
          auto mesh = MakeMesh(kind, { 3, 4, 2 });
          for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
          {
            double x[3];
            mesh->GetPoint(i, x);
            vtkMath::MultiplyScalar(x, length);
            mesh->GetPoints()->SetPoint(i, x);
          }
          FlowMatrix matrix = Generic;
          for (double& entry : matrix)
          {
            entry *= speed / length;
          }
          CheckLinear(mesh, matrix, { { length * place[0], length * place[1], length * place[2] } },
            length, check);
        }
      }
    }
  }
  // A Jacobian that is nearly singular: the zero is known less well than faces are.
  for (const double least : { 1e-8, 1e-10 })
  {
    FlowMatrix flat = Generic;
    for (int j = 0; j < 3; ++j)
    {
      flat[6 + j] = flat[j] - 2.0 * flat[3 + j] + least * flat[6 + j];
    }
    for (const MeshKind kind : Kinds)
    {
      for (const FlowVector& place : Places)
      {
        check.SetContext("nearly singular, " + GetName(kind) + " at " + std::to_string(place[0]) +
          " " + std::to_string(place[1]) + " " + std::to_string(place[2]));
        auto mesh = MakeMesh(kind, { 3, 4, 2 });
        SetVelocity(mesh, Linear(flat, place));
        const Result result(mesh);
        check.Equal(result.GetNumber(), 1, "critical points");
        for (vtkIdType i = 0; i < result.GetNumber(); ++i)
        {
          check.Near(Distance(result.GetPosition(i).data(), place.data()), 0.0, 1e-14 / least,
            "position", 1.0);
        }
      }
    }
  }
  // Components of very different size.
  check.SetContext("components of different size");
  CheckLinear(MakeMesh(MeshKind::Hexahedra, { 3, 4, 2 }),
    { { 1e9, 2e9, 3e9, -1.0, 1.0, 0.5, 2e-9, -1e-9, 1e-9 } }, Places[0], 1.0, check);
}

using Eigenvalues = std::vector<std::complex<double>>;

// A matrix with these, in skew axes.
FlowMatrix MakeMatrix(const Eigenvalues& values)
{
  const double axes[3][3] = { { 0.8, 0.3, -0.2 }, { -0.4, 1.1, 0.3 }, { 0.25, -0.3, 0.9 } };
  double inverse[3][3];
  vtkMath::Invert3x3(axes, inverse);
  double block[3][3] = {};
  for (int i = 0; i < 3; ++i)
  {
    block[i][i] = values[i].real();
  }
  for (int i = 0; i < 2; ++i)
  {
    if (values[i].imag() > 0.0)
    {
      block[i][i + 1] = values[i].imag();
      block[i + 1][i] = -values[i].imag();
    }
  }
  double left[3][3];
  double full[3][3];
  vtkMath::Multiply3x3(axes, block, left);
  vtkMath::Multiply3x3(left, inverse, full);
  FlowMatrix matrix;
  std::copy_n(&full[0][0], 9, matrix.begin());
  return matrix;
}

void CheckType(const Eigenvalues& values, int type, double tolerance, Check& check)
{
  check.SetContext(std::string("type ") + vtkFlowCriticalPoints::GetTypeName(type));
  const FlowMatrix matrix = MakeMatrix(values);
  double largest = 0.0;
  for (const auto& value : values)
  {
    largest = std::max(largest, std::abs(value));
  }
  for (const MeshKind kind : { MeshKind::Hexahedra, MeshKind::Tetrahedra6, MeshKind::Wedges })
  {
    for (const double scale : { 1e-12, 1.0, 1e12 })
    {
      FlowMatrix scaled = matrix;
      for (double& entry : scaled)
      {
        entry *= scale;
      }
      auto mesh = MakeMesh(kind, { 3, 4, 2 });
      SetVelocity(mesh, Linear(scaled, Places[0]));
      const Result result(mesh);
      check.Equal(result.GetNumber(), 1, "critical points");
      for (vtkIdType i = 0; i < result.GetNumber(); ++i)
      {
        check.Equal(result.GetType(i), type, "type");
        for (int k = 0; k < 3; ++k)
        {
          vtkDataArray* found = result.GetArray("Eigenvalues");
          check.Near(found->GetComponent(i, 2 * k), scale * values[k].real(), tolerance,
            "real part " + std::to_string(k), scale * largest);
          check.Near(found->GetComponent(i, 2 * k + 1), scale * values[k].imag(), tolerance,
            "imaginary part " + std::to_string(k), scale * largest);
        }
      }
    }
  }
}

void CheckTypes(Check& check)
{
  const double fine = 1e-12;
  CheckType({ 3.0, 2.0, 0.5 }, Type::SOURCE, fine, check);
  CheckType({ { 1.0, 4.0 }, { 1.0, -4.0 }, 0.5 }, Type::SPIRAL_SOURCE, fine, check);
  CheckType({ 3.0, { 1.0, 0.01 }, { 1.0, -0.01 } }, Type::SPIRAL_SOURCE, fine, check);
  CheckType({ 2.0, 1.0, -3.0 }, Type::SADDLE_1_IN, fine, check);
  CheckType({ { 1.0, 2.0 }, { 1.0, -2.0 }, -1.5 }, Type::SPIRAL_SADDLE_1_IN, fine, check);
  CheckType({ 2.0, -0.1, -3.0 }, Type::SADDLE_2_IN, fine, check);
  CheckType({ 0.2, { -1.0, 5.0 }, { -1.0, -5.0 } }, Type::SPIRAL_SADDLE_2_IN, fine, check);
  CheckType({ -1e-6, -1.0, -2.0 }, Type::SINK, fine, check);
  CheckType({ -0.1, { -1.0, 5.0 }, { -1.0, -5.0 } }, Type::SPIRAL_SINK, fine, check);
  CheckType({ { 0.0, 2.0 }, { 0.0, -2.0 }, -1.0 }, Type::CENTER, fine, check);
  CheckType({ 1.0, { 0.0, 2.0 }, { 0.0, -2.0 } }, Type::CENTER, fine, check);
  CheckType({ 1.0, 3e-10, -1.0 }, Type::DEGENERATE, fine, check);
  CheckType({ 1.0, 3e-9, -1.0 }, Type::SADDLE_1_IN, fine, check);
  CheckType({ 2.0, 2.0, 2.0 }, Type::SOURCE, fine, check);
  for (int type = 0; type < Type::NUMBER_OF_TYPES; ++type)
  {
    check.That(vtkFlowCriticalPoints::GetTypeName(type) != nullptr, "a name");
  }
  check.That(!vtkFlowCriticalPoints::GetTypeName(-1) && !vtkFlowCriticalPoints::GetTypeName(10),
    "names that are none");

  // A permutation, at which the QR method stands still without other shifts.
  check.SetContext("permutation");
  auto cube = MakeMesh(MeshKind::Hexahedra, { 3, 4, 2 });
  SetVelocity(cube, Linear({ { 0, 0, 1, 1, 0, 0, 0, 1, 0 } }, Places[0]));
  const Result permutation(cube);
  if (check.Equal(permutation.GetNumber(), 1, "critical points"))
  {
    const double roots[6] = { 1.0, 0.0, -0.5, std::sqrt(0.75), -0.5, -std::sqrt(0.75) };
    for (int k = 0; k < 6; ++k)
    {
      check.Near(permutation.GetArray("Eigenvalues")->GetComponent(0, k), roots[k], 1e-12,
        "part " + std::to_string(k), 1.0);
    }
  }

  // Axes in units of very different size.
  check.SetContext("units");
  const double units[3] = { 1e6, 1.0, 1e-6 };
  const FlowMatrix spiral = MakeMatrix({ 0.2, { -1.0, 5.0 }, { -1.0, -5.0 } });
  const FlowVector middle = { { 1.23e6, 2.41, 0.77e-6 } };
  for (vtkIdType i = 0; i < cube->GetNumberOfPoints(); ++i)
  {
    double x[3];
    cube->GetPoint(i, x);
    cube->GetPoints()->SetPoint(i, units[0] * x[0], units[1] * x[1], units[2] * x[2]);
  }
  SetVelocity(cube,
    [&](const FlowVector& x)
    {
      const FlowVector v = Multiply(spiral,
        { { (x[0] - middle[0]) / units[0], (x[1] - middle[1]) / units[1],
          (x[2] - middle[2]) / units[2] } });
      return FlowVector{ { units[0] * v[0], units[1] * v[1], units[2] * v[2] } };
    });
  const Result scaled(cube);
  if (check.Equal(scaled.GetNumber(), 1, "critical points"))
  {
    const double parts[6] = { 0.2, 0.0, -1.0, 5.0, -1.0, -5.0 };
    for (int k = 0; k < 6; ++k)
    {
      check.Near(scaled.GetArray("Eigenvalues")->GetComponent(0, k), parts[k], 1e-12,
        "part " + std::to_string(k), 1.0);
    }
    check.Equal(scaled.GetType(0), Type::SPIRAL_SADDLE_2_IN, "type");
  }

  // Any matrix: the sums that the coefficients of the characteristic polynomial are.
  check.SetContext("eigenvalues");
  Random random(17);
  MeshBuilder builder;
  for (const FlowVector& x :
    { FlowVector{ { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } }, { { 0, 0, 1 } } })
  {
    builder.AddPoint(x[0], x[1], x[2]);
  }
  builder.AddCell(VTK_TETRA, { 0, 1, 2, 3 });
  auto tetrahedron = builder.GetMesh();
  for (int n = 0; n < 2000; ++n)
  {
    FlowMatrix a;
    for (double& entry : a)
    {
      entry = random.Get(-1.0, 1.0);
    }
    if (std::abs(Determinant(a.data())) < 1e-6)
    {
      continue;
    }
    SetVelocity(tetrahedron, Linear(a, { { 0.2, 0.3, 0.25 } }));
    const Result result(tetrahedron);
    if (!check.Equal(result.GetNumber(), 1, "critical points"))
    {
      continue;
    }
    double v[6];
    result.GetArray("Eigenvalues")->GetTuple(0, v);
    const std::complex<double> e[3] = { { v[0], v[1] }, { v[2], v[3] }, { v[4], v[5] } };
    check.That(v[0] >= v[2] && v[2] >= v[4], "descending real parts");
    const std::complex<double> sum = e[0] + e[1] + e[2];
    const std::complex<double> pairs = e[0] * e[1] + e[1] * e[2] + e[2] * e[0];
    const std::complex<double> product = e[0] * e[1] * e[2];
    const double minors =
      a[0] * a[4] - a[1] * a[3] + a[0] * a[8] - a[2] * a[6] + a[4] * a[8] - a[5] * a[7];
    check.Near(std::abs(sum - (a[0] + a[4] + a[8])), 0.0, 1e-13, "trace", 1.0);
    check.Near(std::abs(pairs - minors), 0.0, 1e-13, "sum of minors", 1.0);
    check.Near(std::abs(product - Determinant(a.data())), 0.0, 1e-13, "determinant", 1.0);
  }
}

// One cell of a type, its points moved by up to \a shake.
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

// Newton's method with VTK's shape functions from a lattice of places.
std::vector<FlowVector> SearchZeros(vtkCell* cell, vtkDataArray* vectors, bool& isClear)
{
  std::vector<FlowVector> zeros;
  const int number = static_cast<int>(cell->GetNumberOfPoints());
  const auto evaluate = [&](const double p[3], double value[3])
  {
    double weights[8];
    cell->InterpolateFunctions(p, weights);
    std::fill_n(value, 3, 0.0);
    for (int i = 0; i < number; ++i)
    {
      for (int j = 0; j < 3; ++j)
      {
        value[j] += weights[i] * vectors->GetComponent(cell->GetPointId(i), j);
      }
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
        // Linear in each parameter: the difference is the derivative.
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
    // What is on the outside or double is not to be decided.
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
      // A part of a random field of one sign has no zeros at all.
      SetVelocity(mesh, [&random](const FlowVector&) { return random.GetPoint(1.0); });
      vtkCell* cell = mesh->GetCell(0);
      bool isClear = true;
      const auto zeros = SearchZeros(cell, mesh->GetPointData()->GetVectors(), isClear);
      if (!isClear)
      {
        continue;
      }
      check.SetContext(name + ", " + std::to_string(n));
      const Result result(mesh);
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
    check.That(several > 0 || type == VTK_TETRA, "several in a cell: " + std::to_string(several));
  }
}

// (r - a)(s - b), (s - c)(t - d), (t - e)(r - f) vanish at (a, c, e) and (f, b, d) alone.
void CheckKnownPairs(Check& check)
{
  check.SetContext("two in a cell");
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
    const Result result(image);
    check.Equal(result.GetNumber(), 2, "critical points");
    const FlowVector expected[2] = { { { a, c, e } }, { { f, b, d } } };
    for (const FlowVector& place : expected)
    {
      double nearest = 1.0;
      for (vtkIdType i = 0; i < result.GetNumber(); ++i)
      {
        nearest = std::min(nearest, Distance(result.GetPosition(i).data(), place.data()));
      }
      check.Near(nearest, 0.0, 1e-10, "position", 1.0);
    }
  }
  // One on the faces of the parts that the cell is split into.
  for (int n = 0; n < 300; ++n)
  {
    const double half = n % 3 == 0 ? 0.5 : 0.25 * (1 + n % 3);
    const double b = 0.5 + random.Get(0.1, 0.4);
    const double d = 0.5 - random.Get(0.1, 0.4);
    const double f = random.Get(0.8, 0.98);
    check.SetContext("two in a cell, one at " + std::to_string(half) + ", " + std::to_string(n));
    auto image = MakeImage({ 1, 1, 1 });
    image->SetOrigin(0.0, 0.0, 0.0);
    image->SetSpacing(1.0, 1.0, 1.0);
    SetVelocity(image,
      [&](const FlowVector& x)
      {
        return Multiply(Generic,
          { { (x[0] - half) * (x[1] - b), (x[1] - 0.5) * (x[2] - d),
            (x[2] - half) * (x[0] - f) } });
      });
    check.Equal(Result(image).GetNumber(), 2, "critical points");
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
    const Result result(image);
    check.Equal(result.GetNumber(), 1, "critical points");
    for (vtkIdType i = 0; i < result.GetNumber(); ++i)
    {
      const FlowVector place = { { a, a, a } };
      check.Near(Distance(result.GetPosition(i).data(), place.data()), 0.0, 1e-6, "position", 1.0);
      check.Equal(result.GetType(i), Type::DEGENERATE, "type");
    }
  }
}

// Outward on the outside, at random inside: the signs of det J sum up to 1, whatever is in between
// (Poincare and Hopf). One that is missing or counted twice is seen.
void CheckIndices(Check& check)
{
  Random random(41);
  for (const MeshKind kind : Kinds)
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
      const Result generic(mesh);
      total += generic.GetNumber();
      long long sum = 0;
      for (vtkIdType i = 0; i < generic.GetNumber(); ++i)
      {
        double jacobian[9];
        generic.GetArray("Jacobian")->GetTuple(i, jacobian);
        sum += Determinant(jacobian) > 0.0 ? 1 : -1;
      }
      check.Equal(sum, 1, "sum of indices");
      check.Equal(generic.Filter->GetNumberOfDegenerateCells(), 0, "degenerate cells");
      // Zeros at points of the mesh, of which no two have a cell in common.
      const FlowVector places[3] = { { { 1, 1, 1 } }, { { 3, 2, 1 } }, { { 2, 3, 3 } } };
      for (FlowVector place : places)
      {
        mesh->GetPointData()->GetVectors()->SetTuple3(mesh->FindPoint(place.data()), 0.0, 0.0, 0.0);
      }
      mesh->Modified();
      const Result atPoints(mesh);
      for (const FlowVector& place : places)
      {
        int found = 0;
        for (vtkIdType i = 0; i < atPoints.GetNumber(); ++i)
        {
          found += Distance(atPoints.GetPosition(i).data(), place.data()) < 1e-9 ? 1 : 0;
        }
        check.Equal(found, 1, "zeros at a point of the mesh");
      }
    }
    check.That(total > 20, "there are zeros: " + std::to_string(total));
  }
}

// The cube root of the volume: of parts of a unit box, of those in other axes, and of frusta.
void CheckLengths(Check& check)
{
  const std::pair<MeshKind, double> volumes[] = { { MeshKind::Hexahedra, 1.0 },
    { MeshKind::Voxels, 1.0 }, { MeshKind::Wedges, 0.5 }, { MeshKind::Pyramids, 1.0 / 6.0 },
    { MeshKind::Tetrahedra6, 1.0 / 6.0 }, { MeshKind::Tetrahedra12, 1.0 / 12.0 } };
  const auto expect = [&check](vtkDataSet* data, const FlowVector& place, double volume)
  {
    SetVelocity(data, Linear(Generic, place));
    const Result result(data);
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
    expect(mesh, Places[0], one.second);
    expect(InvertCells(mesh), Places[0], one.second);
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

void CheckSources(Check& check)
{
  vtkNew<vtkAnalyticFlowSource> source;
  source->SetDimensions(40, 38, 36);
  source->SetField(vtkAnalyticFlowSource::COUPLED_CHARGE);
  source->SetSeparation(0.6, 0.3, -0.2);
  source->Update();
  check.SetContext("coupled charges");
  const Result charges(source->GetOutput());
  if (check.Equal(charges.GetNumber(), 2, "critical points"))
  {
    const bool isSourceFirst = charges.GetType(0) == Type::SOURCE;
    check.Equal(charges.GetType(isSourceFirst ? 0 : 1), Type::SOURCE, "the source");
    check.Equal(charges.GetType(isSourceFirst ? 1 : 0), Type::SINK, "the sink");
    const FlowVector place = { { -0.3, -0.15, 0.1 } };
    check.Near(Distance(charges.GetPosition(isSourceFirst ? 0 : 1).data(), place.data()), 0.0, 0.01,
      "near the charge", 1.0);
    check.Near(charges.GetArray("CellLength")->GetTuple1(0), std::cbrt(8.0 / (39.0 * 37.0 * 35.0)),
      1e-12, "length of the cell");
  }

  check.SetContext("rotation");
  source->SetField(vtkAnalyticFlowSource::ROTATION);
  for (const double place : { 0.0, 0.0123 })
  {
    source->SetCenter(place, 0.02, 0.0);
    source->Update();
    const Result rotation(source->GetOutput());
    check.Equal(rotation.GetNumber(), 0, "critical points");
    check.Equal(rotation.Filter->GetNumberOfDegenerateCells(), 35, "cells with a line of zeros");
  }
  source->SetCenter(0.0, 0.0, 0.0);
  source->SetAxis(0.3, 0.2, 1.0);
  source->Update();
  const Result oblique(source->GetOutput());
  check.Equal(oblique.GetNumber(), 0, "critical points of an oblique axis");
  check.That(oblique.Filter->GetNumberOfDegenerateCells() >= 35, "cells with its zeros");

  check.SetContext("shear");
  source->SetAxis(0.0, 0.0, 1.0);
  source->SetField(vtkAnalyticFlowSource::SHEAR);
  source->SetCenter(0.0, 0.0, 0.01);
  source->Update();
  const Result shear(source->GetOutput());
  check.Equal(shear.GetNumber(), 0, "critical points");
  check.Equal(shear.Filter->GetNumberOfDegenerateCells(), 39 * 37, "cells with a surface of zeros");

  check.SetContext("sphere");
  source->SetCenter(0.0, 0.0, 0.0);
  source->SetField(vtkAnalyticFlowSource::SPHERE);
  source->SetRadius(0.5);
  source->Update();
  const Result sphere(source->GetOutput());
  check.Equal(sphere.GetNumber(), 0, "critical points");
  vtkImageData* image = source->GetOutput();
  vtkIdType zero = 0;
  for (vtkIdType cell = 0; cell < image->GetNumberOfCells(); ++cell)
  {
    bool isZero = true;
    for (int i = 0; i < 8; ++i)
    {
      isZero = isZero &&
        vtkMath::Norm(image->GetPointData()->GetVectors()->GetTuple3(
          image->GetCell(cell)->GetPointId(i))) == 0.0;
    }
    zero += isZero ? 1 : 0;
  }
  check.That(zero > 1000, "there are cells inside");
  check.Equal(sphere.Filter->GetNumberOfZeroCells(), zero, "cells that are 0 throughout");
}

void CheckLeftOut(Check& check)
{
  check.SetContext("left out");
  const auto make = []()
  {
    auto mesh = MakeMesh(MeshKind::Hexahedra, { 3, 4, 2 });
    SetVelocity(mesh, Linear(Generic, Places[0]));
    return mesh;
  };
  const Result whole(make());
  const vtkIdType cell = whole.GetCell(0);
  for (const unsigned char mark : { vtkDataSetAttributes::HIDDENCELL,
         vtkDataSetAttributes::DUPLICATECELL, vtkDataSetAttributes::REFINEDCELL })
  {
    auto mesh = make();
    mesh->AllocateCellGhostArray()->SetValue(cell, mark);
    check.Equal(Result(mesh).GetNumber(), 0, "in a cell that is left out");
    mesh->GetCellGhostArray()->SetValue(cell, 0);
    mesh->GetCellGhostArray()->SetValue(cell + 1, mark);
    mesh->Modified();
    check.Equal(Result(mesh).GetNumber(), 1, "beside one");
  }
  auto mesh = make();
  vtkIdType corner = mesh->GetCell(cell)->GetPointId(3);
  mesh->AllocatePointGhostArray()->SetValue(corner, vtkDataSetAttributes::HIDDENPOINT);
  check.Equal(Result(mesh).GetNumber(), 0, "in a cell with a hidden point");
  auto image = MakeImage({ 3, 3, 3 });
  FlowVector inside;
  image->GetCell(13)->GetPoints()->GetPoint(0, inside.data());
  inside = { { inside[0] + 0.03, inside[1] + 0.1, inside[2] + 0.2 } };
  SetVelocity(image, Linear(Generic, inside));
  check.Equal(Result(image).GetNumber(), 1, "in an image");
  image->AllocateCellGhostArray()->SetValue(13, vtkDataSetAttributes::HIDDENCELL);
  check.Equal(Result(image).GetNumber(), 0, "in a blanked cell of an image");

  for (const LatticeForm& form : FormsOf(MakeImage({ 3, 3, 3 })))
  {
    check.SetContext("hidden points, " + form.Name);
    SetVelocity(form.Data, Linear(Generic, inside));
    check.Equal(Result(form.Data).GetNumber(), 1, "critical points");
    form.Data->AllocatePointGhostArray()->SetValue(
      form.Data->GetCell(13)->GetPointId(2), vtkDataSetAttributes::HIDDENPOINT);
    form.Data->Modified();
    vtkNew<vtkFlowCriticalPoints> filter;
    ExpectWarnings(filter);
    filter->SetInputDataObject(form.Data);
    check.That(MessagesOf(filter).empty(), "no error");
    check.Equal(filter->GetOutput()->GetNumberOfPoints(), 0, "in a cell with a hidden point");
  }
  check.SetContext("left out");
  for (const double value : { std::nan(""), HUGE_VAL })
  {
    mesh = make();
    corner = mesh->GetCell(cell)->GetPointId(0);
    mesh->GetPointData()->GetVectors()->SetComponent(corner, 2, value);
    vtkNew<vtkIdList> cells;
    mesh->GetPointCells(corner, cells);
    const Result result(mesh);
    check.Equal(result.GetNumber(), 0, "in a cell that is not finite");
    check.Equal(
      result.Filter->GetNumberOfNonFiniteCells(), cells->GetNumberOfIds(), "cells with such");
  }
  check.SetContext("an empty cell");
  mesh = make();
  // In the last cell, whose points a reader might still hold.
  SetVelocity(mesh, Linear(Generic, { { 2.3, 3.4, 1.6 } }));
  mesh->InsertNextCell(VTK_EMPTY_CELL, 0, &corner);
  check.Equal(Result(mesh).GetNumber(), 1, "critical points");
  check.SetContext("left out");
  mesh = make();
  SetVelocity(mesh, [](const FlowVector&) { return FlowVector{}; });
  const Result zero(mesh);
  check.Equal(zero.GetNumber(), 0, "in a field that is 0");
  check.Equal(zero.Filter->GetNumberOfZeroCells(), 24, "cells that are 0");
  CheckPrinted(Print(const_cast<vtkFlowCriticalPoints*>(zero.Filter.GetPointer())),
    { "NumberOfZeroCells: 24", "NumberOfDegenerateCells: 0", "NumberOfNonFiniteCells: 0" }, check);
}

vtkSmartPointer<vtkImageData> MakeRandomImage()
{
  Random random(53);
  auto image = MakeImage({ 12, 11, 10 });
  SetVelocity(image, [&random](const FlowVector&) { return random.GetPoint(1.0); });
  return image;
}

void CheckExecution(Check& check)
{
  check.SetContext("execution");
  auto image = MakeRandomImage();
  std::string expected;
  for (const char* backend : GetBackends())
  {
    if (!vtkSMPTools::SetBackend(backend))
    {
      continue;
    }
    for (const int threads : { 1, 2, 8 })
    {
      vtkSMPTools::Initialize(threads);
      const Result result(image);
      check.That(result.GetNumber() > 20, "there are critical points");
      const std::string bytes = GetBytes(result.Output);
      expected = expected.empty() ? bytes : expected;
      check.That(bytes == expected, "the same bytes for any number of threads");
    }
  }
  vtkNew<vtkFlowCriticalPoints> filter;
  ExpectWarnings(filter);
  filter->SetInputData(image);
  ProgressWatch watch;
  Observe(filter, watch);
  filter->Update();
  CheckGrowth(watch, 5, check);
  for (const double at : { 0.0, 0.5 })
  {
    watch.AbortAt = at;
    filter->Modified();
    filter->Update();
    check.Equal(filter->GetOutput()->GetNumberOfPoints(), 0, "points after an abort");
    watch.AbortAt = 2;
    filter->SetAbortExecute(0);
    filter->Modified();
    filter->Update();
    check.That(GetBytes(filter->GetOutput()) == expected, "the same once it is taken back");
  }
}

void CheckErrors(Check& check)
{
  check.SetContext("errors");
  const auto expect = [&check](vtkFlowCriticalPoints* filter, const std::string& message)
  {
    const std::string found = MessagesOf(filter);
    check.That(found.find(message) != std::string::npos, message + " in: " + found);
    check.Equal(filter->GetOutput()->GetNumberOfPoints(), 0, "points with an error");
  };
  auto image = MakeImage({ 2, 2, 2 });
  vtkNew<vtkFlowCriticalPoints> filter;
  ExpectWarnings(filter);
  filter->SetInputData(image);
  expect(filter, "The field has no active point vectors");
  SetVelocity(image, Linear(Generic, { { 0.0, 0.0, 0.0 } }));
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Wind");
  expect(filter, "The field has no array of numbers \"Wind\"");
  vtkNew<vtkFloatArray> wind;
  wind->SetName("Wind");
  wind->SetNumberOfComponents(2);
  wind->SetNumberOfTuples(27);
  image->GetPointData()->AddArray(wind);
  filter->Modified();
  expect(filter, "Array \"Wind\" has 2 components; three are needed");
  vtkNew<vtkFloatArray> inCells;
  inCells->SetName("Wind");
  inCells->SetNumberOfComponents(3);
  inCells->SetNumberOfTuples(8);
  image->GetCellData()->AddArray(inCells);
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "Wind");
  expect(filter, "Array \"Wind\" is not a point array");
  auto plane = MakeImage({ 2, 2, 0 });
  SetVelocity(plane, Linear(Generic, { { 0.0, 0.0, 0.0 } }));
  vtkNew<vtkFlowCriticalPoints> other;
  ExpectWarnings(other);
  other->SetInputData(plane);
  expect(other, "The field has no three-dimensional cells. Flow in a plane needs two layers");
  auto mesh = MakeMesh(MeshKind::Boxes, { 1, 1, 1 });
  SetVelocity(mesh, Linear(Generic, { { 0.0, 0.0, 0.0 } }));
  other->SetInputData(mesh);
  expect(other, "Cell 0 is a vtkPolyhedron");
  vtkNew<vtkUnstructuredGrid> empty;
  other->SetInputData(empty);
  check.That(MessagesOf(other).empty(), "nothing in an empty grid is no error");
}

}

int TestFlowCriticalPoints(int, char*[])
{
  Check check;
  CheckPlaces(check);
  CheckScales(check);
  CheckTypes(check);
  CheckRandomCells(check);
  CheckKnownPairs(check);
  CheckIndices(check);
  CheckLengths(check);
  CheckSources(check);
  CheckLeftOut(check);
  CheckExecution(check);
  CheckErrors(check);
  return check.Result();
}
