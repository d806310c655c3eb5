// SPDX-License-Identifier: BSD-3-Clause
// Tests that a slab of constant extinction has the opacity 1 - exp(-tau d), and that a finer mesh
// of the same field produces the same image.
#include "Support/Arrays/ReferenceIndices.h"
#include "Support/Drawing/ImageCases.h"
#include "Support/Checks/ReferenceCheck.h"
#include "Tetrahedra/MapperImage.h"

#include "vtkCamera.h"
#include "vtkTimeWeightedTetrahedraMapper.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>

namespace
{

using namespace reference;

constexpr Point3 Slanted = { { 0.3, -0.4, 1.0 } };
constexpr Point3 FaceOn = { { 0.0, 0.0, 1.0 } };

/// Tests that all pixels of the slab are equal in a face-on parallel view.
void TestUniform(Check& check, int path, vtkUnstructuredGrid* grid, double extinction, int pixels)
{
  const Point3 color = { { 0.9, 0.5, 0.2 } };
  ImageCase what = MakeCase(grid, MakeProperty({ { 0.0, color, extinction } }), FaceOn, true);
  what.Settings.Size = { { pixels, pixels } };
  const RgbaImage image = DrawByPath(path, what);
  const double expected = -std::expm1(-extinction);
  double lowest = 1.0;
  double highest = 0.0;
  int inside = 0;
  const PixelRays rays(what.Camera, what.Settings.Size);
  for (const auto& [j, i] : AllIndices(image.Height, image.Width))
  {
    const double* pixel = image.At(i, j);
    if (GetChordLength(grid, rays.Get(i, j)) > 0.5)
    {
      ++inside;
      lowest = std::min(lowest, pixel[3]);
      highest = std::max(highest, pixel[3]);
      for (int k = 0; k < 3; ++k)
      {
        check.Near(pixel[k], expected * color[k], 1e-5, "color of the slab", 1.0);
      }
    }
    else
    {
      check.Near(pixel[3], 0.0, 1e-5, "alpha outside the slab", 1.0);
    }
  }
  check.That(inside > 2000, "the slab is visible");
  check.Near(highest - lowest, 0.0, 1e-5, "range of alpha within the slab", 1.0);
  check.Near(lowest, expected, 1e-5, "lowest alpha of the slab", 1.0);
  check.Near(highest, expected, 1e-5, "highest alpha of the slab", 1.0);
}

/// Tests that the opacity of every pixel corresponds to its chord length in a slanted view. OpenGL
/// rounds vertex positions to 1/256 pixel and may miss tetrahedra that are thinner than that.
void TestChords(Check& check, int path, bool parallel)
{
  auto grid = MakeCube(5);
  const double extinction = 1.7;
  const double bound = path == vtkTimeWeightedTetrahedraMapper::OPENGL_PATH ? 2e-4 : 1e-5;
  const ImageCase what =
    MakeCase(grid, MakeProperty({ { 0.0, { { 1.0, 1.0, 1.0 } }, extinction } }), Slanted, parallel);
  const RgbaImage image = DrawByPath(path, what);
  const PixelRays rays(what.Camera, what.Settings.Size);
  for (const auto& [j, i] : AllIndices(image.Height, image.Width))
  {
    const double alpha = -std::expm1(-extinction * GetChordLength(grid, rays.Get(i, j)));
    check.Near(image.At(i, j)[3], alpha, bound, "alpha of a chord", 1.0);
    check.Near(image.At(i, j)[0], alpha, bound, "red of a chord", 1.0);
  }
}

void TestRefined(Check& check, int path, bool parallel, vtkVolumeProperty* property)
{
  auto coarse = MakeCube(4);
  auto fine = MakeCube(9);
  check.That(fine->GetNumberOfCells() > 10 * coarse->GetNumberOfCells(),
    "the fine mesh has ten times as many cells");
  const ImageCase first = MakeCase(coarse, property, Slanted, parallel);
  ImageCase second = first;
  second.Grid = fine;
  const RgbaImage seen = DrawByPath(path, first);
  check.That(LargestAlpha(seen) > 0.5, "the mesh is visible");
  check.Near(CompareImages(DrawByPath(path, second), seen).Max, 0.0, parallel ? 1e-3 : 2e-3,
    "difference from the finer mesh", 1.0);
}

/// Tests that a narrow peak of opacity is visible at any scalar value.
void TestNarrowPeak(Check& check, int path)
{
  const Point3 white = { { 1.0, 1.0, 1.0 } };
  const double half = 1e-4;
  for (const double value : { 0.2, 0.5, 0.8 })
  {
    const ImageCase what = MakeCase(MakeCube(4),
      MakeProperty({ { 0.0, white, 0.0 }, { value - half, white, 0.0 },
        { value, white, 2.0 / half }, { value + half, white, 0.0 }, { 1.0, white, 0.0 } }),
      Slanted, true);
    check.That(LargestAlpha(DrawByPath(path, what)) > 0.5,
      "a narrow peak at " + std::to_string(value) + " is visible");
  }
}

}

int TestTetrahedraMapperSlab(int, char*[])
{
  Check check;
  for (int path : AllRenderPaths())
  {
    for (double extinction : { 0.01, 1.0, 5.0 })
    {
      check.SetContext(GetPathName(path) + ", extinction " + std::to_string(extinction));
      TestUniform(check, path, MakeCube(5), extinction, 96);
      TestUniform(check, path, MakeBox({ { 3, 4, 7 } }), extinction, 96);
      // An image of odd size has a central pixel, at which faces meet.
      TestUniform(check, path, MakeCube(4), extinction, 95);
      TestUniform(check, path, MakeBox({ { 2, 4, 3 } }), extinction, 95);
    }
    check.SetContext(GetPathName(path));
    TestNarrowPeak(check, path);
    for (bool parallel : { true, false })
    {
      check.SetContext(GetPathName(path) + (parallel ? ", parallel" : ", perspective"));
      TestChords(check, path, parallel);
      TestRefined(check, path, parallel, MakeRamp(0.1, 1.0, 0.25));
      TestRefined(check, path, parallel,
        MakeProperty({ { 0.1, { { 1.0, 0.0, 0.0 } }, 1.0 }, { 0.4, { { 0.0, 1.0, 0.0 } }, 0.0 },
          { 0.45, { { 1.0, 1.0, 1.0 } }, 9.0 }, { 0.6, { { 0.2, 0.1, 1.0 } }, 0.1 },
          { 1.0, { { 0.0, 0.9, 0.7 } }, 4.0 } }));
    }
  }
  return check.Result();
}
