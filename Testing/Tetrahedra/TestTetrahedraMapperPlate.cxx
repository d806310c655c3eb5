// SPDX-License-Identifier: BSD-3-Clause
// A plate of constant hypercubes, projected along time: with its extent in time it is a slab of
// constant extinction, 1 - exp(-tau duration length) from everywhere (figure 3.19 of the source);
// without, the overlap of the tetrahedra shows (figure 3.14).
#include "Support/Arrays/ReferenceIndices.h"
#include "Support/Pictures/HypercubePlate.h"
#include "Support/Drawing/PictureCases.h"
#include "Support/Checks/ReferenceCheck.h"
#include "Tetrahedra/MapperPicture.h"

#include "vtkAlgorithm.h"
#include "vtkCamera.h"
#include "vtkNew.h"
#include "vtkTimeVaryingIntervalVolume.h"
#include "vtkTimeWeightedTetrahedraMapper.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>

namespace
{

using namespace reference;

constexpr int CELLS = 8;
constexpr Point3 Color = { { 0.2, 0.9, 0.5 } };
/// Optical depth of the plate where a line of sight crosses it at a right angle.
constexpr double DEPTH = 0.8;

vtkSmartPointer<vtkUnstructuredGrid> MakePlate(
  int steps, double duration, bool isMoving, Check& check)
{
  const vtkSmartPointer<vtkAlgorithm> source = MakeHypercubePlate(CELLS, steps, duration, isMoving);
  vtkNew<vtkTimeVaryingIntervalVolume> interval;
  interval->SetInputConnection(source->GetOutputPort());
  interval->SetNumberOfIntervals(1);
  interval->SetInterval(0, -1.0, 1.0);
  interval->Update();
  vtkInterlumeReport* report = interval->GetReport();
  check.Near(report->GetNumber("CellsWithOutput"), CELLS * CELLS * (steps - 1), 0.0, "hypercubes");
  check.That(
    report->GetNumber("Simplices") >= 22 * CELLS * CELLS * (steps - 1), "hypercubes are cut");
  return interval->GetOutput();
}

/// Opacity of the pixels that see the plate.
struct Opacity
{
  int Pixels = 0;
  double Mean = 0.0;
  double Deviation = 0.0;
  /// Largest distance from 1 - exp(-depth), of colour and opacity.
  double Error = 0.0;
  /// Pixels further away than OUTLIER; they are left out of the mean and the deviation.
  int Outliers = 0;
};

/// OpenGL rounds silhouettes to 1/256 of a pixel. A pixel whose centre is as near to the end of a
/// face seen edge-on can miss a tetrahedron.
constexpr double OUTLIER = 1e-3;

/// The mean and the deviation are of the pixels whose lines of sight are longest: seen in parallel,
/// all that pass both large faces of the plate. The error is of all pixels.
Opacity Measure(const PictureCase& what, const RgbaPicture& picture, double extinction)
{
  Opacity opacity;
  const PixelRays rays(what.Camera, what.Settings.Size);
  double squares = 0.0;
  double longest = 0.0;
  for (const auto& [pass, j, i] : AllIndices(2, picture.Height, picture.Width))
  {
    const double chord = BoxChord(what.Grid, rays.Get(i, j));
    const double* pixel = picture.At(i, j);
    const double expected = -std::expm1(-extinction * chord);
    const double error = std::abs(pixel[3] - expected);
    if (pass == 0)
    {
      longest = std::max(longest, chord);
      opacity.Error = std::max(opacity.Error, error);
      opacity.Outliers += error > OUTLIER ? 1 : 0;
      for (int k = 0; k < 3; ++k)
      {
        opacity.Error = std::max(opacity.Error, std::abs(pixel[k] - Color[k] * expected));
      }
    }
    else if (chord > (1.0 - 1e-9) * longest && error <= OUTLIER)
    {
      ++opacity.Pixels;
      const double last = opacity.Mean;
      opacity.Mean += (pixel[3] - last) / opacity.Pixels;
      squares += (pixel[3] - last) * (pixel[3] - opacity.Mean);
    }
  }
  opacity.Deviation = std::sqrt(squares / std::max(opacity.Pixels, 1));
  return opacity;
}

struct View
{
  const char* Name;
  Point3 Direction;
  bool IsParallel;
};

void TestPlate(Check& check, int path, int steps, double duration, bool isMoving)
{
  const View views[] = { { "front", { { 0.0, 0.0, 1.0 } }, true },
    { "oblique", { { 0.3, -0.4, 1.0 } }, true }, { "from behind", { { 0.7, 0.5, -1.0 } }, true },
    { "flat", { { -1.0, 0.4, 0.3 } }, true }, { "near the front", { { 0.0, 0.0, 1.0 } }, false },
    { "near, oblique", { { 0.3, -0.4, 1.0 } }, false } };
  const bool isExact = path == vtkTimeWeightedTetrahedraMapper::SOFTWARE_PATH;
  PictureCase what;
  what.Grid = MakePlate(steps, duration, isMoving, check);
  what.Property = MakeProperty({ { 0.0, Color, DEPTH / duration } });
  what.Settings.Size = { { 160, 160 } };
  what.Settings.How = Blend::OpticalDepth;
  for (const View& view : views)
  {
    const std::string name = GetPathName(path) + ", " + view.Name + ", " + std::to_string(steps) +
      " steps, " + (isMoving ? "moving" : "at rest");
    check.SetContext(name);
    what.Camera = LookAt(what.Grid, view.Direction, view.IsParallel);
    what.Settings.Arrays.DeltaT = "DeltaT";
    const Opacity with = Measure(what, DrawByPath(path, what), DEPTH);
    what.Settings.Arrays.DeltaT = "";
    const Opacity without = Measure(what, DrawByPath(path, what), DEPTH);
    std::cout << name << ": " << with.Pixels << " pixels, mean " << with.Mean << ", deviation "
              << with.Deviation << ", largest error " << with.Error << ", " << with.Outliers
              << " outliers; " << without.Outliers << " without Delta t\n";
    // A pixel may lack one of the tetrahedra on top of each other, but not all.
    check.Near(with.Error, 0.0, isExact ? 1e-5 : 0.2, "largest error", 1.0);
    check.That(
      with.Outliers <= (isExact ? 0 : what.Settings.Size[0] * what.Settings.Size[1] / 1000),
      "hardly a pixel is missed");
    if (view.IsParallel)
    {
      check.That(with.Pixels > 500, "the plate is seen");
      check.Near(with.Deviation, 0.0, 1e-5, "standard deviation of opacity", 1.0);
    }
    check.That(without.Outliers > 5000, "wrong without the extent in time");
  }
}

/// Without the extent in time the overlap shows, which is what makes the uniform plate a test.
void TestPattern(Check& check, int path)
{
  check.SetContext("pattern, " + GetPathName(path));
  PictureCase what;
  what.Grid = MakePlate(2, 1.0, true, check);
  what.Property = MakeProperty({ { 0.0, Color, 0.2 } });
  what.Settings.Size = { { 160, 160 } };
  what.Settings.How = Blend::OpticalDepth;
  what.Settings.Arrays.DeltaT = "";
  what.Camera = LookAt(what.Grid, { { 0.0, 0.0, 1.0 } }, true);
  const RgbaPicture picture = DrawByPath(path, what);
  double lowest = 1.0;
  double highest = 0.0;
  for (int i = 20; i < 140; ++i)
  {
    lowest = std::min(lowest, picture.At(i, 77)[3]);
    highest = std::max(highest, picture.At(i, 77)[3]);
  }
  std::cout << GetPathName(path) << ", without Delta t: opacity " << lowest << " to " << highest
            << '\n';
  check.That(highest - lowest > 0.1, "the overlap shows");
}

}

int TestTetrahedraMapperPlate(int, char*[])
{
  Check check;
  for (const int path : AllRenderPaths())
  {
    for (const bool isMoving : { false, true })
    {
      TestPlate(check, path, 2, 1.0, isMoving);
      TestPlate(check, path, 4, 7.5, isMoving);
    }
    TestPattern(check, path);
  }
  return check.Result();
}
