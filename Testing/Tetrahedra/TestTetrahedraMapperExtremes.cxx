// SPDX-License-Identifier: BSD-3-Clause
// Tests the far plane, transfer functions with many nodes, and extremely thin tetrahedra. The
// software path must be accurate, and OpenGL within the limits documented in
// vtkTimeWeightedTetrahedraMapper.h.
#include "Support/Arrays/ReferenceIndices.h"
#include "Support/Checks/LargestError.h"
#include "Support/Pages/StabilityCase.h"
#include "Support/Drawing/ImageCases.h"
#include "Tetrahedra/MapperImage.h"

#include "vtkCamera.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkTimeWeightedTetrahedraMapper.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <sstream>
#include <string>

namespace
{

using namespace reference;

constexpr Point3 Slanted = { { 0.3, -0.4, -1.0 } };

/// Number of pixels with an error above 1e-3, and the largest error.
struct Misses
{
  int Pixels = 0;
  double Largest = 0.0;
};

Misses Compare(const RgbaImage& found, const RgbaImage& expected)
{
  Misses misses;
  for (const auto& [j, i] : AllIndices(expected.Height, expected.Width))
  {
    double error = 0.0;
    for (int k = 0; k < 4; ++k)
    {
      const double difference = std::abs(found.At(i, j)[k] - expected.At(i, j)[k]);
      reference::KeepLargest(error, difference);
    }
    misses.Pixels += error > 1e-3 ? 1 : 0;
    misses.Largest = std::max(misses.Largest, error);
  }
  return misses;
}

/// Compares both render paths with the reference. \a software and \a opengl limit their errors.
void Expect(StabilityCatalogue& catalogue, const std::string& name, const ImageCase& what,
  const Misses& software, const Misses& opengl)
{
  const RgbaImage expected = DrawReference(what);
  const bool isSeen = LargestAlpha(expected) > 0.05;
  for (const int path : AllRenderPaths())
  {
    const Misses found = Compare(DrawByPath(path, what), expected);
    const std::string row = name + "-" + GetPathName(path);
    const Misses& bound =
      path == vtkTimeWeightedTetrahedraMapper::SOFTWARE_PATH ? software : opengl;
    catalogue.Measure(row + "-pixels", name, "pixels with an error above 1e-3",
      isSeen ? found.Pixels : std::nan(""), bound.Pixels);
    catalogue.Measure(row, name, "largest error of a channel",
      isSeen ? found.Largest : std::nan(""), bound.Largest);
  }
}

/// Tests that view rays end at the far plane.
void TestFarPlane(StabilityCatalogue& catalogue)
{
  for (bool parallel : { true, false })
  {
    ImageCase what = MakeCase(MakeCube(4), MakeRamp(0.5, 3.0), Slanted, parallel);
    double range[2];
    what.Camera->GetClippingRange(range);
    const double far = 0.6 * range[0] + 0.4 * range[1];
    what.Camera->SetClippingRange(range[0], far);
    const PixelRays rays(what.Camera, what.Settings.Size);
    for (const auto& [j, i] : AllIndices(what.Settings.Size[1], what.Settings.Size[0]))
    {
      what.Settings.OpaqueDistance.push_back(
        far * static_cast<double>(rays.Get(i, j).DistancePerDepth));
    }
    Expect(catalogue, std::string("far plane, ") + (parallel ? "parallel" : "perspective"), what,
      { 0, 1e-3 }, { 2, 0.1 });
  }
}

void TestNodes(StabilityCatalogue& catalogue)
{
  std::mt19937 random(5);
  const auto uniform = [&]() { return random() / static_cast<double>(random.max()); };
  for (int nodes : { 500, 2000 })
  {
    std::vector<FunctionNode> points;
    for (int i = 0; i < nodes; ++i)
    {
      points.push_back({ 0.1 + 0.9 * i / (nodes - 1.0), { { uniform(), uniform(), uniform() } },
        8.0 * uniform() });
    }
    for (bool parallel : { true, false })
    {
      Expect(catalogue,
        std::to_string(nodes) + (parallel ? " nodes, parallel" : " nodes, perspective"),
        MakeCase(MakeCube(4), MakeProperty(points), Slanted, parallel), { 0, 1e-3 }, { 2, 0.1 });
    }
  }
}

/// Tests a flattened cube, seen obliquely, and from the side with pixel centers in its central
/// plane.
void TestSquashed(StabilityCatalogue& catalogue)
{
  for (const double height : { 1e-5, 1e-7, 1e-8, 1e-9 })
  {
    std::ostringstream name;
    name << "squashed to " << height;
    auto grid = MakeCube(4);
    MovePoints(grid, { { 0.0, 0.0, 0.0 } }, 1.0, { { 1.0, 1.0, height } });
    Expect(catalogue, name.str(), MakeCase(grid, MakeRamp(0.5, 3.0, height), Slanted, true),
      { 0, 1e-3 }, { 1, 0.8 });
    ImageCase side = MakeCase(grid, MakeRamp(0.5, 3.0), Slanted, true);
    side.Camera = LookAt(grid, { { 0.0, 1.0, 0.0 } }, true);
    side.Settings.Size = { { 97, 97 } };
    // View rays are 4e-9 pixels off the pixel centers, which matters for the thinnest plate. OpenGL
    // rounds coordinates to 1/256 pixel and may miss any plate.
    const int row = 97;
    const Misses software = height < 5e-9 ? Misses{ row, 6e-3 } : Misses{ 0, 1e-3 };
    Expect(catalogue, name.str() + ", from the side", side, software, { row, 1.0 });
  }
}

/// Tests needle-shaped tetrahedra around an axis, seen along this axis.
void TestNeedles(StabilityCatalogue& catalogue)
{
  for (const int needles : { 200, 2000 })
  {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    points->InsertNextPoint(0.0, 0.0, 0.0);
    points->InsertNextPoint(0.0, 0.0, 1.0);
    for (int i = 0; i < needles; ++i)
    {
      const double angle = 2.0 * vtkMath::Pi() * i / needles;
      points->InsertNextPoint(0.5 * std::cos(angle), 0.5 * std::sin(angle), 0.5);
    }
    vtkNew<vtkUnstructuredGrid> grid;
    grid->SetPoints(points);
    for (vtkIdType i = 0; i < needles; ++i)
    {
      const vtkIdType ids[4] = { 0, 1, 2 + i, 2 + (i + 1) % needles };
      grid->InsertNextCell(VTK_TETRA, 4, ids);
    }
    AddLinearArray(grid, "f", 0.2, { { 0.3, 0.2, 0.5 } });
    grid->GetPointData()->SetActiveScalars("f");
    for (bool parallel : { true, false })
    {
      ImageCase what = MakeCase(grid, MakeRamp(0.5, 3.0), Slanted, parallel);
      what.Camera = LookAt(grid, { { 0.0, 0.0, -1.0 } }, parallel);
      Expect(catalogue,
        std::to_string(needles) + (parallel ? " needles, parallel" : " needles, perspective"), what,
        { 0, 1e-3 }, needles > 1000 ? Misses{ 250, 0.5 } : Misses{ 0, 1e-3 });
    }
  }
}

}

int TestTetrahedraMapperExtremes(int argc, char* argv[])
{
  StabilityCatalogue catalogue("TestTetrahedraMapperExtremes", argc, argv);
  catalogue.SetClass("vtkTimeWeightedTetrahedraMapper");
  TestFarPlane(catalogue);
  TestNodes(catalogue);
  TestSquashed(catalogue);
  TestNeedles(catalogue);
  return catalogue.GetExitCode();
}
