// SPDX-License-Identifier: BSD-3-Clause
// The mesh satisfies the quality bound and the maximum volume, and preserves the boundary if
// PreserveBoundary is on.
#include "Support/Checks/LargestError.h"
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceMessages.h"
#include "Support/Meshes/ReferenceMeshing.h"

#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"
#include "vtkTetrahedralMesher.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>
#include <iostream>
#include <random>

namespace
{

using namespace reference;

struct Bounds
{
  double Quality;
  double Volume;
};

void CheckBounds(vtkPolyData* surface, const Bounds& bounds, Check& check)
{
  vtkNew<vtkTetrahedralMesher> mesher;
  mesher->SetInputData(surface);
  mesher->SetQualityBound(bounds.Quality);
  mesher->SetMaximumVolume(bounds.Volume);
  mesher->Update();
  const TetrahedraReport report = Inspect(mesher->GetOutput());
  const long double enclosed = EnclosedVolume(surface);
  check.That(report.Tetrahedra > 0, "there are tetrahedra");
  check.Equal(report.NotPositive + report.FacesTooOften + report.FacesTurned, 0, "a valid mesh");
  check.Near(report.Volume, enclosed, 1e-12, "volume");
  check.Near(report.BoundaryVolume, enclosed, 1e-12, "volume within the outer faces");
  if (bounds.Quality > 0)
  {
    check.That(report.LargestRadiusEdgeRatio <= bounds.Quality * (1 + 1e-9),
      "the quality bound is satisfied: " + std::to_string(report.LargestRadiusEdgeRatio));
  }
  if (bounds.Volume > 0)
  {
    check.That(report.LargestVolume <= bounds.Volume * (1 + 1e-9),
      "the maximum volume is satisfied: " + std::to_string(report.LargestVolume));
  }
  vtkInterlumeReport* statistics = mesher->GetReport();
  check.Near(statistics->GetNumber("LargestRadiusEdgeRatio"), report.LargestRadiusEdgeRatio, 1e-6,
    "the reported ratio");
  check.Near(
    statistics->GetNumber("LargestVolume"), report.LargestVolume, 1e-12, "the reported volume");
  check.Equal(statistics->GetCount("TetrahedraAboveQualityBound") +
      statistics->GetCount("TetrahedraAboveMaximumVolume"),
    0, "tetrahedra above a bound");
  std::cout << "bound " << bounds.Quality << ", volume " << bounds.Volume << ": "
            << report.Tetrahedra << " tetrahedra, ratio " << report.LargestRadiusEdgeRatio
            << ", largest " << report.LargestVolume << ", " << statistics->GetNumber("AddedPoints")
            << " points added\n";
}

void CheckPreserved(vtkPolyData* surface, vtkIdType triangles, Check& check)
{
  for (double volume : { 0.0, 0.001 })
  {
    vtkNew<vtkTetrahedralMesher> mesher;
    mesher->SetInputData(surface);
    mesher->SetMaximumVolume(volume);
    mesher->PreserveBoundaryOn();
    const bool isWarned = !WarningsOf(mesher).empty();
    const TetrahedraReport report = Inspect(mesher->GetOutput());
    check.Equal(report.FacesOnce, triangles, "triangles of the boundary");
    check.Near(report.Volume, EnclosedVolume(surface), 1e-12, "volume");
    check.Equal(isWarned, report.LargestVolume > volume && volume > 0,
      "a warning if a bound is not satisfied");
  }
}

/// The quality bound of 1.4 cannot be satisfied next to angles of 15 degrees. The maximum volume
/// can still be satisfied, and tetrahedra do not shrink without limit.
void CheckNeedles(Check& check)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(24);
  sphere->SetPhiResolution(16);
  sphere->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  sphere->Update();
  vtkNew<vtkTetrahedralMesher> mesher;
  mesher->SetInputConnection(sphere->GetOutputPort());
  mesher->SetQualityBound(1.4);
  mesher->SetMaximumVolume(0.001);
  check.That(
    !WarningsOf(mesher).empty(), "a warning reports that the quality bound is not satisfied");
  vtkInterlumeReport* report = mesher->GetReport();
  std::cout << "sphere of needles: " << report->GetNumber("Tetrahedra") << " tetrahedra, "
            << report->GetNumber("TetrahedraAboveQualityBound")
            << " above the quality bound, smallest " << report->GetNumber("SmallestVolume")
            << ", largest " << report->GetNumber("LargestVolume") << "\n";
  check.Equal(report->GetCount("TetrahedraAboveMaximumVolume"), 0, "tetrahedra that are too large");
  check.That(report->GetNumber("SmallestVolume") > 1e-12, "no tetrahedron is tiny");
  check.Near(
    Inspect(mesher->GetOutput()).Volume, EnclosedVolume(sphere->GetOutput()), 1e-12, "volume");
}

/// Returns a geodesic sphere whose points are moved along the radius by a random distance of at
/// most \a noise.
vtkSmartPointer<vtkPolyData> MakeRoughSphere(double noise)
{
  auto surface = MakeGeodesicSphere(2);
  std::mt19937 random(2);
  for (vtkIdType p = 0; p < surface->GetNumberOfPoints(); ++p)
  {
    double x[3];
    surface->GetPoint(p, x);
    vtkMath::MultiplyScalar(x, 1.0 + noise * (2.0 * random() / 4294967295.0 - 1.0));
    surface->GetPoints()->SetPoint(p, x);
  }
  return surface;
}

vtkSmartPointer<vtkPolyData> MakeRandomPoints(int number)
{
  auto data = MakeEmptySurface();
  std::mt19937 random(2);
  for (int p = 0; p < number; ++p)
  {
    const double x = random() / 4294967296.0;
    const double y = random() / 4294967296.0;
    data->GetPoints()->InsertNextPoint(x, y, random() / 4294967296.0);
  }
  return data;
}

/// A single call of TetGen with the facets and all bounds would create tetrahedra above the maximum
/// volume. The angles of the rough sphere make it impossible to satisfy the quality bound.
void CheckRough(Check& check)
{
  const auto rough = MakeRoughSphere(0.4);
  const auto points = MakeRandomPoints(1000);
  for (vtkPolyData* input : { rough.Get(), points.Get() })
  {
    for (double quality : { 0.0, 1.4 })
    {
      for (double bound : { 4e-3, 2e-4 })
      {
        vtkNew<vtkTetrahedralMesher> mesher;
        mesher->SetInputData(input);
        mesher->SetQualityBound(quality);
        mesher->SetMaximumVolume(bound);
        const bool isWarned = !WarningsOf(mesher).empty();
        const TetrahedraReport report = Inspect(mesher->GetOutput());
        vtkInterlumeReport* statistics = mesher->GetReport();
        check.Equal(
          report.NotPositive + report.FacesTooOften + report.FacesTurned, 0, "the mesh is valid");
        check.That(report.LargestVolume <= bound * (1 + 1e-9),
          "the maximum volume is satisfied: " + std::to_string(report.LargestVolume / bound));
        check.That(report.Tetrahedra < 100000,
          "the number of tetrahedra is moderate: " + std::to_string(report.Tetrahedra));
        check.Near(report.Volume, report.BoundaryVolume, 1e-12, "volume");
        check.That(statistics->GetNumber("SmallestVolume") > 1e-15, "no tetrahedron is tiny");
        check.Equal(isWarned, statistics->GetNumber("TetrahedraAboveQualityBound") > 0,
          "a warning for the quality bound");
      }
    }
  }
}

/// The mesh does not depend on the size of the model. It is bit-identical if the scale is a power
/// of two.
void CheckScales(Check& check)
{
  const auto surface = MakeRoughSphere(0.2);
  // With some versions of TetGen, the quality bound cannot be satisfied because of the angles of
  // the surface.
  vtkNew<vtkTetrahedralMesher> mesher;
  AllowWarnings(mesher);
  const auto mesh = [&](double scale)
  {
    vtkNew<vtkPoints> points;
    points->SetDataType(VTK_DOUBLE);
    for (vtkIdType p = 0; p < surface->GetNumberOfPoints(); ++p)
    {
      double x[3];
      surface->GetPoint(p, x);
      vtkMath::MultiplyScalar(x, scale);
      points->InsertNextPoint(x);
    }
    vtkNew<vtkPolyData> scaled;
    scaled->SetPoints(points);
    scaled->SetPolys(surface->GetPolys());
    mesher->SetInputData(scaled);
    mesher->SetQualityBound(1.4);
    mesher->SetMaximumVolume(4e-3 * scale * scale * scale);
    mesher->Update();
    auto output = vtkSmartPointer<vtkUnstructuredGrid>::New();
    output->ShallowCopy(mesher->GetOutput());
    return output;
  };
  const auto one = mesh(1.0);
  check.That(one->GetNumberOfCells() >= EnclosedVolume(surface) / 4e-3, "a mesh of size 1");
  for (double scale : { std::ldexp(1.0, -300), std::ldexp(1.0, 300), 1e-6, 1e6 })
  {
    check.SetContext("scale " + std::to_string(std::log10(scale)));
    const auto other = mesh(scale);
    const double cube = scale * scale * scale;
    check.Near(mesher->GetReport()->GetNumber("LargestVolume") / cube, Inspect(one).LargestVolume,
      0.1, "the reported volume");
    check.That(mesher->GetReport()->GetNumber("LargestVolume") <= 4e-3 * cube * (1 + 1e-9),
      "the bound is satisfied");
    // Rounding errors of the input change some decisions of TetGen.
    const bool isExact = scale < 1e-30 || scale > 1e30;
    check.Near(static_cast<double>(other->GetNumberOfCells()),
      static_cast<double>(one->GetNumberOfCells()), isExact ? 0.0 : 0.02, "tetrahedra");
    double largest = 0.0;
    for (vtkIdType p = 0;
         isExact && p < std::min(one->GetNumberOfPoints(), other->GetNumberOfPoints()); ++p)
    {
      double x[3];
      double y[3];
      one->GetPoint(p, x);
      other->GetPoint(p, y);
      vtkMath::MultiplyScalar(y, 1.0 / scale);
      reference::KeepLargest(largest, std::sqrt(vtkMath::Distance2BetweenPoints(x, y)));
    }
    check.Near(largest, 0.0, 0.0, "points");
  }
}

void CheckLimits(vtkPolyData* surface, Check& check)
{
  vtkNew<vtkTetrahedralMesher> mesher;
  mesher->SetInputData(surface);
  mesher->SetMaximumVolume(1e-5);
  mesher->SetMaximumNumberOfAddedPoints(500);
  const bool isWarned = !WarningsOf(mesher).empty();
  check.That(
    mesher->GetReport()->GetNumber("AddedPoints") <= 600, "the number of new points is bounded");
  check.That(isWarned && mesher->GetReport()->GetNumber("TetrahedraAboveMaximumVolume") > 0,
    "a warning reports that the volume bound is not satisfied");
  check.Near(Inspect(mesher->GetOutput()).Volume, EnclosedVolume(surface), 1e-12, "volume");
}

void CheckValues(Check& check)
{
  vtkNew<vtkTetrahedralMesher> mesher;
  mesher->SetQualityBound(0.3);
  check.Near(mesher->GetQualityBound(), 1.0, 0.0, "a bound below 1");
  mesher->SetQualityBound(-5);
  check.Near(mesher->GetQualityBound(), 0.0, 0.0, "a negative bound");
  mesher->SetQualityBound(1e9);
  check.Near(mesher->GetQualityBound(), 1000.0, 0.0, "a large bound");
  mesher->SetMaximumVolume(-1);
  check.Near(mesher->GetMaximumVolume(), 0.0, 0.0, "a negative volume");
  mesher->SetMinimumDihedralAngle(90);
  check.Near(mesher->GetMinimumDihedralAngle(), 30.0, 0.0, "a large angle");
}

}

int TestTetrahedralMesherBounds(int, char*[])
{
  Check check;
  auto box = MakeEmptySurface();
  AppendBox(box, { 0, 0, 0 }, { 1, 2, 3 });
  auto sphere = MakeGeodesicSphere(3);
  auto torus = MakeTorus(30, 16);
  const std::pair<const char*, vtkPolyData*> surfaces[] = { { "box", box }, { "sphere", sphere },
    { "torus", torus } };
  for (const auto& surface : surfaces)
  {
    check.SetContext(surface.first);
    std::cout << surface.first << "\n";
    for (const Bounds& bounds : std::initializer_list<Bounds>{
           { 2.0, 0.0 }, { 1.4, 0.0 }, { 1.2, 0.0 }, { 0.0, 0.01 }, { 1.4, 0.001 } })
    {
      CheckBounds(surface.second, bounds, check);
    }
  }
  check.SetContext("preserved boundary");
  CheckPreserved(box, 12, check);
  CheckPreserved(torus, torus->GetNumberOfCells(), check);
  check.SetContext("needles at the poles");
  CheckNeedles(check);
  check.SetContext("rough surface and points");
  CheckRough(check);
  CheckScales(check);
  check.SetContext("limit of new points");
  CheckLimits(box, check);
  check.SetContext("values");
  CheckValues(check);
  return check.Result();
}
