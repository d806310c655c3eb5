// SPDX-License-Identifier: BSD-3-Clause
// Types of critical points with given eigenvalues, and the critical points of analytic sources.
#include "Support/AnalyticFlows/ReferenceFlowMaps.h"
#include "Support/Checks/LargestError.h"
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceRandom.h"
#include "Support/Flow/ReferenceCriticalPoints.h"
#include "Support/Meshes/ReferenceMesh.h"
#include "Support/Meshes/ReferenceMeshBuilder.h"

#include "vtkAnalyticFlowSource.h"
#include "vtkFlowCriticalPoints.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
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

using Eigenvalues = std::vector<std::complex<double>>;

// Returns a matrix with the given eigenvalues and non-orthogonal eigenvectors.
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
    reference::KeepLargest(largest, std::abs(value));
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
      SetVelocity(mesh, LinearField(scaled, ZeroPositions[0]));
      const CriticalPoints result(mesh);
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
    check.That(vtkFlowCriticalPoints::GetTypeName(type) != nullptr, "the type has a name");
  }
  check.That(!vtkFlowCriticalPoints::GetTypeName(-1) && !vtkFlowCriticalPoints::GetTypeName(10),
    "invalid types have no name");

  // A permutation matrix, for which the QR algorithm needs exceptional shifts to converge.
  check.SetContext("permutation");
  auto cube = MakeMesh(MeshKind::Hexahedra, { 3, 4, 2 });
  SetVelocity(cube, LinearField({ { 0, 0, 1, 1, 0, 0, 0, 1, 0 } }, ZeroPositions[0]));
  const CriticalPoints permutation(cube);
  if (check.Equal(permutation.GetNumber(), 1, "critical points"))
  {
    const double roots[6] = { 1.0, 0.0, -0.5, std::sqrt(0.75), -0.5, -std::sqrt(0.75) };
    for (int k = 0; k < 6; ++k)
    {
      check.Near(permutation.GetArray("Eigenvalues")->GetComponent(0, k), roots[k], 1e-12,
        "part " + std::to_string(k), 1.0);
    }
  }

  // The axes have units of very different scales.
  check.SetContext("units");
  const double units[3] = { 1e6, 1.0, 1e-6 };
  const FlowMatrix spiral = MakeMatrix({ 0.2, { -1.0, 5.0 }, { -1.0, -5.0 } });
  const FlowVector center = { { 1.23e6, 2.41, 0.77e-6 } };
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
        { { (x[0] - center[0]) / units[0], (x[1] - center[1]) / units[1],
          (x[2] - center[2]) / units[2] } });
      return FlowVector{ { units[0] * v[0], units[1] * v[1], units[2] * v[2] } };
    });
  const CriticalPoints scaled(cube);
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

  // Random matrices: the eigenvalues match the coefficients of the characteristic polynomial.
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
    SetVelocity(tetrahedron, LinearField(a, { { 0.2, 0.3, 0.25 } }));
    const CriticalPoints result(tetrahedron);
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

void CheckSources(Check& check)
{
  vtkNew<vtkAnalyticFlowSource> source;
  source->SetDimensions(40, 38, 36);
  source->SetField(vtkAnalyticFlowSource::COUPLED_CHARGE);
  source->SetSeparation(0.6, 0.3, -0.2);
  source->Update();
  check.SetContext("coupled charges");
  const CriticalPoints charges(source->GetOutput());
  if (check.Equal(charges.GetNumber(), 2, "critical points"))
  {
    const bool isSourceFirst = charges.GetType(0) == Type::SOURCE;
    check.Equal(charges.GetType(isSourceFirst ? 0 : 1), Type::SOURCE, "the source");
    check.Equal(charges.GetType(isSourceFirst ? 1 : 0), Type::SINK, "the sink");
    const FlowVector position = { { -0.3, -0.15, 0.1 } };
    check.Near(Distance(charges.GetPosition(isSourceFirst ? 0 : 1).data(), position.data()), 0.0,
      0.01, "near the charge", 1.0);
    check.Near(charges.GetArray("CellLength")->GetTuple1(0), std::cbrt(8.0 / (39.0 * 37.0 * 35.0)),
      1e-12, "length of the cell");
  }

  check.SetContext("rotation");
  source->SetField(vtkAnalyticFlowSource::ROTATION);
  for (const double position : { 0.0, 0.0123 })
  {
    source->SetCenter(position, 0.02, 0.0);
    source->Update();
    const CriticalPoints rotation(source->GetOutput());
    check.Equal(rotation.GetNumber(), 0, "critical points");
    check.Equal(
      rotation.Filter->GetReport()->GetCount("DegenerateCells"), 35, "cells on a line of zeros");
  }
  source->SetCenter(0.0, 0.0, 0.0);
  source->SetAxis(0.3, 0.2, 1.0);
  source->Update();
  const CriticalPoints oblique(source->GetOutput());
  check.Equal(oblique.GetNumber(), 0, "critical points of an oblique axis");
  check.That(
    oblique.Filter->GetReport()->GetNumber("DegenerateCells") >= 35, "cells on the oblique axis");

  check.SetContext("shear");
  source->SetAxis(0.0, 0.0, 1.0);
  source->SetField(vtkAnalyticFlowSource::SHEAR);
  source->SetCenter(0.0, 0.0, 0.01);
  source->Update();
  const CriticalPoints shear(source->GetOutput());
  check.Equal(shear.GetNumber(), 0, "critical points");
  check.Equal(
    shear.Filter->GetReport()->GetCount("DegenerateCells"), 39 * 37, "cells on a surface of zeros");

  check.SetContext("sphere");
  source->SetCenter(0.0, 0.0, 0.0);
  source->SetField(vtkAnalyticFlowSource::SPHERE);
  source->SetRadius(0.5);
  source->Update();
  const CriticalPoints sphere(source->GetOutput());
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
  check.Equal(sphere.Filter->GetReport()->GetCount("ZeroCells"), zero, "number of zero cells");
}

}

int TestFlowCriticalPointTypes(int, char*[])
{
  return RunChecks({ CheckTypes, CheckSources });
}
