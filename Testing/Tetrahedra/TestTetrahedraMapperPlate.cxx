// SPDX-License-Identifier: BSD-3-Clause
// Tests a plate of constant hypercubes projected along time. With the extent in time, the opacity
// is 1 - exp(-tau * duration * length) for any view (figure 3.19 of C. Zhang's dissertation).
// Without it, overlapping tetrahedra are visible (figure 3.14).
#include "Support/Arrays/ReferenceIndices.h"
#include "Support/Images/HypercubePlate.h"
#include "Support/Drawing/ImageCases.h"
#include "Support/Checks/ReferenceCheck.h"
#include "Tetrahedra/MapperImage.h"

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
/// Optical depth of the plate along a perpendicular view ray.
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
  check.Equal(report->GetCount("CellsWithOutput"), CELLS * CELLS * (steps - 1), "hypercubes");
  check.That(
    report->GetNumber("Simplices") >= 22 * CELLS * CELLS * (steps - 1), "hypercubes are split");
  return interval->GetOutput();
}

/// Statistics of the opacity of the pixels that show the plate.
struct Opacity
{
  int Pixels = 0;
  double Mean = 0.0;
  double Deviation = 0.0;
  /// Largest difference from 1 - exp(-depth), for color and opacity.
  double Error = 0.0;
  /// Number of pixels with an opacity error above OUTLIER. Mean and Deviation exclude them.
  int Outliers = 0;
};

/// Opacity error above which a pixel is an outlier. OpenGL rounds vertex positions to 1/256 pixel
/// and may miss a tetrahedron at a pixel whose center is that close to a face seen edge-on.
constexpr double OUTLIER = 1e-3;

/// Computes mean and deviation for the pixels with the longest chord. In parallel projection, these
/// are all pixels whose view rays intersect both large faces of the plate. The error is computed
/// for all pixels.
Opacity Measure(const ImageCase& what, const RgbaImage& image, double extinction)
{
  Opacity opacity;
  const PixelRays rays(what.Camera, what.Settings.Size);
  double squares = 0.0;
  double longest = 0.0;
  for (const auto& [pass, j, i] : AllIndices(2, image.Height, image.Width))
  {
    const double chord = GetChordLength(what.Grid, rays.Get(i, j));
    const double* pixel = image.At(i, j);
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
  ImageCase what;
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
    // With OpenGL, a pixel may miss one of several overlapping tetrahedra.
    check.Near(with.Error, 0.0, isExact ? 1e-5 : 0.2, "largest error", 1.0);
    check.That(
      with.Outliers <= (isExact ? 0 : what.Settings.Size[0] * what.Settings.Size[1] / 1000),
      "few pixels are missed");
    if (view.IsParallel)
    {
      check.That(with.Pixels > 500, "the plate is visible");
      check.Near(with.Deviation, 0.0, 1e-5, "standard deviation of opacity", 1.0);
    }
    check.That(without.Outliers > 5000, "without the extent in time the opacity differs");
  }
}

/// Tests that the overlap of tetrahedra is visible without the extent in time. Otherwise TestPlate
/// would not test anything.
void TestPattern(Check& check, int path)
{
  check.SetContext("pattern, " + GetPathName(path));
  ImageCase what;
  what.Grid = MakePlate(2, 1.0, true, check);
  what.Property = MakeProperty({ { 0.0, Color, 0.2 } });
  what.Settings.Size = { { 160, 160 } };
  what.Settings.How = Blend::OpticalDepth;
  what.Settings.Arrays.DeltaT = "";
  what.Camera = LookAt(what.Grid, { { 0.0, 0.0, 1.0 } }, true);
  const RgbaImage image = DrawByPath(path, what);
  double lowest = 1.0;
  double highest = 0.0;
  for (int i = 20; i < 140; ++i)
  {
    lowest = std::min(lowest, image.At(i, 77)[3]);
    highest = std::max(highest, image.At(i, 77)[3]);
  }
  std::cout << GetPathName(path) << ", without Delta t: opacity " << lowest << " to " << highest
            << '\n';
  check.That(highest - lowest > 0.1, "the overlap is visible");
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
