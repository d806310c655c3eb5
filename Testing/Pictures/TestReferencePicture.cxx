// SPDX-License-Identifier: BSD-3-Clause
// The reference against closed forms: slabs, linear extinction, two slabs, order, every blend mode.
#include "Support/Arrays/ReferenceIndices.h"
#include "Support/Drawing/PictureCases.h"
#include "Support/Pictures/ReferenceIntegral.h"
#include "Support/Pictures/ReferenceVolumePicture.h"
#include "Support/Checks/ReferenceCheck.h"

#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"
#include "vtkUnstructuredGridLinearRayIntegrator.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace
{

using namespace reference;

constexpr double Bound = 1e-9;
constexpr Point3 Grey = { { 0.5, 0.5, 0.5 } };
constexpr Point3 Red = { { 1.0, 0.0, 0.0 } };
constexpr Point3 Green = { { 0.0, 1.0, 0.0 } };
constexpr Point3 Slanted = { { 0.3, -0.4, 1.0 } };

void ExpectPixel(Check& check, const RgbaPicture& picture, int i, int j, double alpha,
  const Point3& color, const std::string& what)
{
  for (int k = 0; k < 3; ++k)
  {
    check.Near(picture.At(i, j)[k], color[k], Bound, what + ", colour", 1.0);
  }
  check.Near(picture.At(i, j)[3], alpha, Bound, what + ", alpha", 1.0);
}

/// 1 - exp(-tau d) for every pixel of a box of constant extinction.
void TestSlab(Check& check)
{
  for (bool parallel : { true, false })
  {
    for (double extinction : { 1e-6, 1.0, 1e3, 1e9 })
    {
      auto grid = MakeCube(3);
      MovePoints(grid, { { 5.0, -2.0, 1.0 } }, 2.0, { { 1.0, 2.0, 0.5 } });
      auto camera = LookAt(grid, Slanted, parallel);
      PictureSettings settings;
      settings.Size = { { 23, 17 } };
      auto property = MakeProperty({ { 0.0, Grey, 2.0 * extinction } }, 2.0);
      const RgbaPicture picture = MakeReferencePicture(grid, property, camera, settings);
      int inside = 0;
      for (const auto& [j, i] : AllIndices(settings.Size[1], settings.Size[0]))
      {
        const double chord = BoxChord(grid, PixelRays(camera, settings.Size).Get(i, j));
        const double alpha = -std::expm1(-extinction * chord);
        check.Near(picture.At(i, j)[3], alpha, Bound, "alpha of a slab", 1e-6 * extinction);
        check.Near(picture.At(i, j)[0], 0.5 * alpha, Bound, "red of a slab", 1e-6 * extinction);
        inside += chord > 0.0 ? 1 : 0;
      }
      check.That(inside > 100, "the slab is seen");
    }
  }
}

/// Extinction and colour that rise along the line of sight, from the closed form.
void TestLinear(Check& check)
{
  const auto integral = [](double a, double b, double c0, double c1)
  {
    StraightPart part;
    part.Length = 1.0;
    part.Extinction = { { a, b } };
    part.Color = { { { { c0, 1.0, 0.0 } }, { { c1, 1.0, 0.0 } } } };
    return Integrate(part);
  };
  const double pi = std::acos(-1.0);
  for (double b : { 1e-3, 1.0, 50.0, 1e4, 1e9 })
  {
    // From extinction 0 to b and colour 0 to 1: the integral of t b t exp(-b t^2 / 2).
    const Light light = integral(0.0, b, 0.0, 1.0);
    const double seen =
      std::sqrt(pi / (2.0 * b)) * std::erf(std::sqrt(0.5 * b)) - std::exp(-0.5 * b);
    check.Near(light.Seen[0], seen, Bound, "rising extinction and colour");
    check.Near(light.Seen[1], -std::expm1(-0.5 * b), Bound, "rising extinction, one colour");
    check.Near(light.Depth, 0.5 * b, 1e-14, "depth of rising extinction");
    check.Near(light.Emitted[0], b / 3.0, 1e-13, "emission of rising extinction and colour");
    // Constant extinction, falling colour.
    const Light constant = integral(b, b, 1.0, 0.0);
    const double alpha = -std::expm1(-b);
    check.Near(constant.Seen[0], 1.0 - alpha / b, Bound, "falling colour", 1.0);
  }
  StraightPart weighted;
  weighted.Length = 3.0;
  weighted.Extinction = { { 1.0, 2.0 } };
  weighted.Weight = { { 0.5, 0.25 } };
  // 3 times the integral of (1 + t) (1/2 - t/4)
  check.Near(
    Integrate(weighted).Depth, 3.0 * (0.5 + 0.125 - 1.0 / 12.0), 1e-14, "depth with an extent");
}

/// VTK's closed forms of the same integral, which use tables of single precision.
void TestAgainstRayIntegrator(Check& check)
{
  vtkNew<vtkVolume> volume;
  auto property = MakeRamp(0.0, 3.0);
  volume->SetProperty(property);
  vtkNew<vtkDoubleArray> scalars;
  scalars->InsertNextValue(0.0);
  scalars->InsertNextValue(1.0);
  vtkNew<vtkUnstructuredGridLinearRayIntegrator> integrator;
  integrator->Initialize(volume, scalars);
  std::mt19937 random(11);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  for (int run = 0; run < 200; ++run)
  {
    const double ends[2] = { uniform(random), uniform(random) };
    StraightPart part;
    part.Length = 3.0 * uniform(random);
    for (int side = 0; side < 2; ++side)
    {
      part.Extinction[side] = property->GetScalarOpacity()->GetValue(ends[side]);
      property->GetRGBTransferFunction()->GetColor(ends[side], part.Color[side].data());
    }
    vtkNew<vtkDoubleArray> lengths;
    vtkNew<vtkDoubleArray> nearEnds;
    vtkNew<vtkDoubleArray> farEnds;
    lengths->InsertNextValue(part.Length);
    nearEnds->InsertNextValue(ends[0]);
    farEnds->InsertNextValue(ends[1]);
    float found[4] = { 0.0F, 0.0F, 0.0F, 0.0F };
    integrator->Integrate(lengths, nearEnds, farEnds, found);
    const Light light = Integrate(part);
    for (int k = 0; k < 3; ++k)
    {
      check.Near(found[k], light.Seen[k], 5e-3, "colour of VTK's integrator", 1.0);
    }
    check.Near(found[3], light.GetAlpha(), 1e-5, "alpha of VTK's integrator", 1.0);
  }
}

/// Two slabs one behind the other in z, of cells 0 and 1, by the formulas of each blend mode.
void TestTwoSlabs(Check& check)
{
  auto grid = MakeBox({ { 2, 2, 2 } });
  AddSlabs(grid, "IntervalId", 2, 2);
  auto camera = LookAt(grid, { { 0.0, 0.0, 1.0 } }, true);
  PictureSettings settings;
  settings.Size = { { 8, 8 } };
  settings.Arrays.Scalars = "IntervalId";
  settings.Arrays.OfCells = true;
  auto property = MakeProperty({ { 0.0, Red, 1.5 }, { 1.0, Green, 0.8 } });
  const double depths[2] = { 0.75, 0.4 };
  const double alphas[2] = { -std::expm1(-0.75), -std::expm1(-0.4) };
  const double all = -std::expm1(-1.15);
  const auto draw = [&](Blend how)
  {
    settings.How = how;
    return MakeReferencePicture(grid, property, camera, settings);
  };
  ExpectPixel(check, draw(Blend::Composite), 4, 4, all,
    { { alphas[0], std::exp(-0.75) * alphas[1], 0.0 } }, "two slabs, composite");
  ExpectPixel(check, draw(Blend::OpticalDepth), 4, 4, all,
    { { all * depths[0] / 1.15, all * depths[1] / 1.15, 0.0 } }, "two slabs, optical depth");
  ExpectPixel(
    check, draw(Blend::MaximumIntensity), 4, 4, 0.8, { { 0.0, 0.8, 0.0 } }, "two slabs, maximum");
  ExpectPixel(check, draw(Blend::Priority), 4, 4, all,
    { { (1.0 - alphas[1]) * alphas[0], alphas[1], 0.0 } }, "two slabs, priority by number");
  settings.Priorities = { { 0, 7.0 } };
  ExpectPixel(check, draw(Blend::Priority), 4, 4, all,
    { { alphas[0], (1.0 - alphas[0]) * alphas[1], 0.0 } }, "two slabs, priority given");
  settings.Priorities = { { 0, 1.0 } };
  ExpectPixel(check, draw(Blend::Priority), 4, 4, all,
    { { (1.0 - alphas[1]) * alphas[0], alphas[1], 0.0 } }, "two slabs, equal priorities");

  // The line of sight through the middle of a pixel passes one tetrahedron or several in a slab.
  const RgbaPicture sum = draw(Blend::Additive);
  check.That(sum.At(4, 4)[0] >= alphas[0] - Bound && sum.At(4, 4)[0] < depths[0] &&
      sum.At(4, 4)[1] >= alphas[1] - Bound && sum.At(4, 4)[1] < depths[1],
    "two slabs, sum between one segment and infinitely many");

  // Something opaque in the middle of the first slab, and before both.
  settings.How = Blend::Composite;
  const double front = -static_cast<double>(PixelRays(camera, settings.Size).Get(4, 4).Origin[2]);
  settings.OpaqueDistance.assign(64, front + 0.25);
  const double half = -std::expm1(-0.375);
  ExpectPixel(check, draw(Blend::Composite), 4, 4, half, { { half, 0.0, 0.0 } }, "cut slab");
  settings.OpaqueDistance.assign(64, front);
  ExpectPixel(check, draw(Blend::Composite), 4, 4, 0.0, { { 0.0, 0.0, 0.0 } }, "hidden slabs");
  settings.OpaqueDistance.clear();
  // The near plane in the middle of the second slab.
  camera->SetClippingRange(front + 0.75, front + 10.0);
  const double rest = -std::expm1(-0.2);
  ExpectPixel(check, draw(Blend::Composite), 4, 4, rest, { { 0.0, rest, 0.0 } }, "near plane");
}

/// The mean of both ends of each segment: one tetrahedron with a known chord.
void TestAverage(Check& check)
{
  auto grid = MakeBox({ { 1, 1, 1 } });
  auto camera = LookAt(grid, { { 0.0, 0.0, 1.0 } }, true);
  PictureSettings settings;
  settings.Size = { { 9, 9 } };
  AddLinear(grid, "depth", 0.0, { { 0.0, 0.0, 1.0 } });
  settings.Arrays.Scalars = "depth";
  settings.Mode = Integration::AverageColor;
  // A straight opacity function: the mean of each segment is exact, whatever the tetrahedra.
  const RgbaPicture straight = MakeReferencePicture(
    grid, MakeProperty({ { 0.0, Red, 0.5 }, { 1.0, Red, 1.5 } }), camera, settings);
  ExpectPixel(check, straight, 4, 4, -std::expm1(-1.0), { { -std::expm1(-1.0), 0.0, 0.0 } },
    "mean of a straight function");
  // A tent between the ends is not seen by the mean where a segment goes from end to end.
  const auto tent = MakeProperty({ { 0.0, Red, 0.0 }, { 0.5, Red, 2.0 }, { 1.0, Red, 0.0 } });
  settings.Mode = Integration::Exact;
  const RgbaPicture exact = MakeReferencePicture(grid, tent, camera, settings);
  ExpectPixel(check, exact, 4, 4, -std::expm1(-1.0), { { -std::expm1(-1.0), 0.0, 0.0 } },
    "integral of a tent");
}

/// The same tetrahedra in another order give the same picture, bit for bit.
void TestOrder(Check& check)
{
  auto grid = MakeCube(3);
  vtkNew<vtkUnstructuredGrid> shuffled;
  shuffled->SetPoints(grid->GetPoints());
  shuffled->GetPointData()->ShallowCopy(grid->GetPointData());
  std::vector<vtkIdType> order(static_cast<std::size_t>(grid->GetNumberOfCells()));
  std::iota(order.begin(), order.end(), 0);
  std::shuffle(order.begin(), order.end(), std::mt19937(7));
  vtkNew<vtkIdList> ids;
  shuffled->Allocate(grid->GetNumberOfCells());
  for (vtkIdType cell : order)
  {
    grid->GetCellPoints(cell, ids);
    shuffled->InsertNextCell(VTK_TETRA, ids);
  }
  auto camera = LookAt(grid, Slanted, false);
  const PictureSettings settings;
  auto property = MakeRamp(0.5, 5.0);
  const RgbaPicture first = MakeReferencePicture(grid, property, camera, settings);
  const RgbaPicture second = MakeReferencePicture(shuffled, property, camera, settings);
  check.That(ComparePictures(first, second).Max == 0.0, "the same for any order of the cells");
  check.That(LargestAlpha(first) > 0.5, "something is seen");
}

/// A mesh ten times as fine of the same linear field has the same picture.
void TestRefined(Check& check)
{
  for (bool parallel : { true, false })
  {
    auto coarse = MakeCube(2);
    auto fine = MakeCube(7);
    auto camera = LookAt(coarse, Slanted, parallel);
    PictureSettings settings;
    auto property = MakeProperty({ { 0.1, Red, 1.0 }, { 0.4, Green, 0.0 }, { 0.45, Grey, 30.0 },
      { 0.6, Red, 0.1 }, { 1.0, Green, 8.0 } });
    for (Blend how : { Blend::Composite, Blend::OpticalDepth, Blend::MaximumIntensity })
    {
      settings.How = how;
      const PictureError error =
        ComparePictures(MakeReferencePicture(coarse, property, camera, settings),
          MakeReferencePicture(fine, property, camera, settings));
      check.Near(error.Max, 0.0, Bound, "difference of a finer mesh", 1.0);
    }
  }
}

/// A box of thin tetrahedra, far away, is the box.
void TestSlivers(Check& check)
{
  for (double thickness : { 1e-2, 1e-4, 1e-6 })
  {
    auto grid = MakeBox({ { 1, 1, 50 } });
    MovePoints(grid, { { 1e6, -1e6, 1e6 } }, 1.0, { { 1.0, 1.0, 50.0 * thickness } });
    auto camera = LookAt(grid, Slanted, true);
    PictureSettings settings;
    settings.Size = { { 16, 16 } };
    auto property = MakeProperty({ { 0.0, Grey, 1.0 } }, thickness);
    const RgbaPicture picture = MakeReferencePicture(grid, property, camera, settings);
    for (const auto& [j, i] : AllIndices(16, 16))
    {
      const double chord = BoxChord(grid, PixelRays(camera, settings.Size).Get(i, j));
      check.Near(
        picture.At(i, j)[3], -std::expm1(-chord / thickness), 1e-8, "thin tetrahedra", 1.0);
    }
  }
}

}

int TestReferencePicture(int, char*[])
{
  return RunChecks({ TestSlab, TestLinear, TestAgainstRayIntegrator, TestTwoSlabs, TestAverage,
    TestOrder, TestRefined, TestSlivers });
}
