// SPDX-License-Identifier: BSD-3-Clause
// A slab of constant extinction is 1 - exp(-tau d), uniform where d is; a finer mesh of the same
// field gives the same picture.
#include "Support/Arrays/ReferenceIndices.h"
#include "Support/Drawing/PictureCases.h"
#include "Support/Checks/ReferenceCheck.h"
#include "Tetrahedra/MapperPicture.h"

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

/// Seen face-on in parallel, every pixel of the slab is the same.
void TestUniform(Check& check, int path, vtkUnstructuredGrid* grid, double extinction, int pixels)
{
  const Point3 color = { { 0.9, 0.5, 0.2 } };
  PictureCase what = MakeCase(grid, MakeProperty({ { 0.0, color, extinction } }), FaceOn, true);
  what.Settings.Size = { { pixels, pixels } };
  const RgbaPicture picture = DrawByPath(path, what);
  const double expected = -std::expm1(-extinction);
  double lowest = 1.0;
  double highest = 0.0;
  int inside = 0;
  const PixelRays rays(what.Camera, what.Settings.Size);
  for (const auto& [j, i] : AllIndices(picture.Height, picture.Width))
  {
    const double* pixel = picture.At(i, j);
    if (BoxChord(grid, rays.Get(i, j)) > 0.5)
    {
      ++inside;
      lowest = std::min(lowest, pixel[3]);
      highest = std::max(highest, pixel[3]);
      for (int k = 0; k < 3; ++k)
      {
        check.Near(pixel[k], expected * color[k], 1e-5, "colour of the slab", 1.0);
      }
    }
    else
    {
      check.Near(pixel[3], 0.0, 1e-5, "alpha beside the slab", 1.0);
    }
  }
  check.That(inside > 2000, "the slab is seen");
  check.Near(highest - lowest, 0.0, 1e-5, "range of alpha within the slab", 1.0);
  check.Near(lowest, expected, 1e-5, "lowest alpha of the slab", 1.0);
  check.Near(highest, expected, 1e-5, "highest alpha of the slab", 1.0);
}

/// Seen at a slant and in perspective, every pixel has its own length. OpenGL rounds the silhouette
/// of a tetrahedron to 1/256 of a pixel, and may miss what is thinner.
void TestChords(Check& check, int path, bool parallel)
{
  auto grid = MakeCube(5);
  const double extinction = 1.7;
  const double bound = path == vtkTimeWeightedTetrahedraMapper::OPENGL_PATH ? 2e-4 : 1e-5;
  const PictureCase what =
    MakeCase(grid, MakeProperty({ { 0.0, { { 1.0, 1.0, 1.0 } }, extinction } }), Slanted, parallel);
  const RgbaPicture picture = DrawByPath(path, what);
  const PixelRays rays(what.Camera, what.Settings.Size);
  for (const auto& [j, i] : AllIndices(picture.Height, picture.Width))
  {
    const double alpha = -std::expm1(-extinction * BoxChord(grid, rays.Get(i, j)));
    check.Near(picture.At(i, j)[3], alpha, bound, "alpha of a chord", 1.0);
    check.Near(picture.At(i, j)[0], alpha, bound, "red of a chord", 1.0);
  }
}

void TestRefined(Check& check, int path, bool parallel, vtkVolumeProperty* property)
{
  auto coarse = MakeCube(4);
  auto fine = MakeCube(9);
  check.That(fine->GetNumberOfCells() > 10 * coarse->GetNumberOfCells(), "ten times as fine");
  const PictureCase first = MakeCase(coarse, property, Slanted, parallel);
  PictureCase second = first;
  second.Grid = fine;
  const RgbaPicture seen = DrawByPath(path, first);
  check.That(LargestAlpha(seen) > 0.5, "the mesh is seen");
  check.Near(ComparePictures(DrawByPath(path, second), seen).Max, 0.0, parallel ? 1e-3 : 2e-3,
    "difference of the picture of a finer mesh", 1.0);
}

/// A peak of opacity is seen wherever it is, however narrow.
void TestNarrowPeak(Check& check, int path)
{
  const Point3 white = { { 1.0, 1.0, 1.0 } };
  const double half = 1e-4;
  for (const double place : { 0.2, 0.5, 0.8 })
  {
    const PictureCase what = MakeCase(MakeCube(4),
      MakeProperty({ { 0.0, white, 0.0 }, { place - half, white, 0.0 },
        { place, white, 2.0 / half }, { place + half, white, 0.0 }, { 1.0, white, 0.0 } }),
      Slanted, true);
    check.That(LargestAlpha(DrawByPath(path, what)) > 0.5,
      "a narrow peak at " + std::to_string(place) + " is seen");
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
      // With a pixel in the middle, where faces are.
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
