// SPDX-License-Identifier: BSD-3-Clause
// Measures the largest channel error of both render paths and of VTK's mapper against the
// reference, in a floating-point framebuffer. The cases are linear fields on regular and thin
// tetrahedra, on small, large and distant meshes, with low and high extinction.
#include "Support/Pages/StabilityCase.h"
#include "Support/Drawing/ImageCases.h"
#include "Support/Images/VolumeStage.h"
#include "Tetrahedra/MapperImage.h"

#include "vtkCamera.h"
#include "vtkTimeWeightedTetrahedraMapper.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <sstream>

namespace
{

using namespace reference;

constexpr double Bound = 1e-3;
constexpr Point3 Slanted = { { 0.3, -0.4, 1.0 } };
constexpr Point3 EdgeOn = { { 1.0, 0.03, 0.02 } };

/// OpenGL rounds vertex positions and may miss a pixel whose center is within 1/256 pixel of a
/// silhouette. The error is visible for tetrahedra thinner than 1/256 pixel, and at the edge of a
/// sheet, where the opacity is discontinuous.
constexpr double OpenGLEdgeOnBound = 1e-2;
constexpr double OpenGLSheetBound = 0.1;

/// Returns the largest difference, divided by the largest alpha if this is less than 1. If the
/// expected image is empty, returns NaN, so that the test fails.
double ErrorOf(const RgbaImage& found, const RgbaImage& expected)
{
  const double largest = LargestAlpha(expected);
  return largest > 0.0 ? CompareImages(found, expected).Max / std::min(1.0, largest) : std::nan("");
}

double GetOpenGLBound(const std::string& name)
{
  if (name.find("edge-on") != std::string::npos)
  {
    return OpenGLEdgeOnBound;
  }
  return name.compare(0, 6, "sheet-") == 0 ? OpenGLSheetBound : Bound;
}

class ErrorTable
{
public:
  ErrorTable(int argc, char* argv[])
    : Catalogue("TestTetrahedraMapperError", argc, argv)
  {
    this->Catalogue.SetClass("vtkTimeWeightedTetrahedraMapper");
  }

  void Measure(const std::string& name, const std::string& extreme, vtkUnstructuredGrid* grid,
    vtkVolumeProperty* property, const Point3& direction = Slanted,
    const std::array<int, 2>& size = { { 96, 64 } })
  {
    for (bool parallel : { true, false })
    {
      const std::string projection = parallel ? "parallel" : "perspective";
      const ImageCase what = MakeCase(grid, property, direction, parallel, size);
      const RgbaImage expected = DrawReference(what);
      std::ostringstream text;
      text.precision(3);
      text << "largest channel error, relative to the largest alpha; error of VTK's mapper: "
           << ErrorOf(DrawWithVtkMapper(what), expected);
      for (int path : AllRenderPaths())
      {
        const RgbaImage found = DrawByPath(path, what, this->Stage);
        std::string row = name;
        row.append("-").append(projection).append("-").append(GetPathName(path));
        const bool isSoftware = path == vtkTimeWeightedTetrahedraMapper::SOFTWARE_PATH;
        this->Catalogue.Measure(row, extreme, text.str(), ErrorOf(found, expected),
          isSoftware ? Bound : GetOpenGLBound(name));
        std::cout << "      " << CompareImages(found, expected) << '\n';
      }
    }
  }

  int GetExitCode() { return this->Catalogue.GetExitCode(); }

private:
  StabilityCatalogue Catalogue;
  VolumeStage Stage{ { { 96, 64 } } };
};

std::string Power(int exponent)
{
  return (exponent < 0 ? "1e-" : "1e+") + std::to_string(std::abs(exponent));
}

/// Tests view rays that lie in faces. The images have a central pixel, and faces that contain the
/// center of the mesh project to rows, columns and diagonals of pixels.
void TestAlignedFaces(ErrorTable& table)
{
  const std::array<int, 2> odd = { { 95, 63 } };
  const std::string extreme = "view rays within faces, ";
  for (int axis = 0; axis < 3; ++axis)
  {
    Point3 direction = { { 0.0, 0.0, 0.0 } };
    direction[axis] = 1.0;
    std::string name = "aligned-";
    name.append(1, "xyz"[axis]);
    table.Measure(name + "-5", extreme + "five tetrahedra per cube", MakeCube(4),
      MakeRamp(0.1, 1.0, 0.25), direction, odd);
    table.Measure(name + "-6", extreme + "six tetrahedra per cube", MakeBox({ { 4, 4, 4 } }),
      MakeRamp(0.1, 1.0, 0.25), direction, odd);
  }
  table.Measure("aligned-xy", extreme + "along a diagonal", MakeCube(2), MakeRamp(0.1, 1.0, 0.25),
    { { 1.0, 1.0, 0.0 } }, odd);
}

void TestThinTetrahedra(ErrorTable& table)
{
  for (int exponent : { -2, -4, -6 })
  {
    const double thickness = std::pow(10.0, exponent);
    const std::string aspect = Power(-exponent);
    // Boundaries of ten thin layers, and of ten layers that are alternately thick and thin.
    std::vector<double> thin;
    std::vector<double> alternating;
    double top = 0.0;
    for (int layer = 0; layer <= 10; ++layer)
    {
      thin.push_back(layer * thickness / 4.0);
      alternating.push_back(top);
      top += layer % 2 == 0 ? 0.1 : thickness / 4.0;
    }
    auto sheet = MakeLayers(4, thin);
    table.Measure("sheet-" + aspect, "a sheet of tetrahedra of aspect " + aspect, sheet,
      MakeRamp(0.1, 1.0, thickness));
    auto layered = MakeLayers(4, alternating);
    table.Measure("layers-" + aspect, "every other layer of aspect " + aspect, layered,
      MakeRamp(0.1, 1.0, 0.25));
    table.Measure("layers-edge-on-" + aspect, "layers of aspect " + aspect + ", seen edge-on",
      layered, MakeRamp(0.1, 1.0, 0.25), EdgeOn);
  }
}

void TestScales(ErrorTable& table)
{
  for (int exponent : { -6, 6 })
  {
    const double scale = std::pow(10.0, exponent);
    auto grid = MakeCube(4);
    MovePoints(grid, { { 0.0, 0.0, 0.0 } }, scale);
    table.Measure("scale-" + Power(exponent), "a mesh of size " + Power(exponent), grid,
      MakeRamp(0.1, 1.0, 0.25 * scale));
  }
  for (int exponent : { 3, 6, 9 })
  {
    const double offset = std::pow(10.0, exponent);
    auto grid = MakeCube(4);
    MovePoints(grid, { { offset, -offset, 0.7 * offset } }, 1.0);
    table.Measure("far-" + Power(exponent), "a mesh of size 1, " + Power(exponent) + " away", grid,
      MakeRamp(0.1, 1.0, 0.25));
  }
}

void TestExtinctions(ErrorTable& table)
{
  auto grid = MakeCube(4);
  for (int exponent : { -6, -3, 0, 3, 6 })
  {
    const double extinction = std::pow(10.0, exponent);
    table.Measure("extinction-" + Power(exponent),
      "extinction up to " + Power(exponent) + " per unit", grid,
      MakeRamp(0.1 * extinction, extinction));
    table.Measure("unit-distance-" + Power(-exponent),
      "opacity up to 1 with a unit distance of " + Power(-exponent), grid,
      MakeRamp(0.1, 1.0, 1.0 / extinction));
  }
}

}

int TestTetrahedraMapperError(int argc, char* argv[])
{
  ErrorTable table(argc, argv);
  table.Measure("regular", "none, for comparison", MakeCube(4), MakeRamp(0.1, 1.0, 0.25));
  table.Measure("regular-face-on", "faces along the view rays", MakeCube(4),
    MakeRamp(0.1, 1.0, 0.25), { { 0.0, 0.0, 1.0 } });
  table.Measure("regular-diagonal", "edges along the view rays", MakeBox({ { 3, 3, 3 } }),
    MakeRamp(0.1, 1.0, 0.25), { { 1.0, 1.0, 1.0 } });
  TestAlignedFaces(table);
  TestThinTetrahedra(table);
  TestScales(table);
  TestExtinctions(table);
  return table.GetExitCode();
}
