// SPDX-License-Identifier: BSD-3-Clause
// Compares the reference with closed forms: slabs, linear extinction, two slabs, cell order, every
// blend mode.
#include "Support/Arrays/ReferenceIndices.h"
#include "Support/Drawing/ImageCases.h"
#include "Support/Images/ReferenceIntegral.h"
#include "Support/Images/ReferenceVolumeImage.h"
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
constexpr Point3 Gray = { { 0.5, 0.5, 0.5 } };
constexpr Point3 Red = { { 1.0, 0.0, 0.0 } };
constexpr Point3 Green = { { 0.0, 1.0, 0.0 } };
constexpr Point3 Slanted = { { 0.3, -0.4, 1.0 } };

void ExpectPixel(Check& check, const RgbaImage& image, int i, int j, double alpha,
  const Point3& color, const std::string& what)
{
  for (int k = 0; k < 3; ++k)
  {
    check.Near(image.At(i, j)[k], color[k], Bound, what + ", color", 1.0);
  }
  check.Near(image.At(i, j)[3], alpha, Bound, what + ", alpha", 1.0);
}

/// In a box of constant extinction tau, a pixel has the alpha 1 - exp(-tau d), where d is the
/// length of its view ray in the box.
void TestSlab(Check& check)
{
  for (bool parallel : { true, false })
  {
    for (double extinction : { 1e-6, 1.0, 1e3, 1e9 })
    {
      auto grid = MakeCube(3);
      MovePoints(grid, { { 5.0, -2.0, 1.0 } }, 2.0, { { 1.0, 2.0, 0.5 } });
      auto camera = LookAt(grid, Slanted, parallel);
      CameraSettings settings;
      settings.Size = { { 23, 17 } };
      auto property = MakeProperty({ { 0.0, Gray, 2.0 * extinction } }, 2.0);
      const RgbaImage image = MakeReferenceImage(grid, property, camera, settings);
      int inside = 0;
      for (const auto& [j, i] : AllIndices(settings.Size[1], settings.Size[0]))
      {
        const double chord = GetChordLength(grid, PixelRays(camera, settings.Size).Get(i, j));
        const double alpha = -std::expm1(-extinction * chord);
        check.Near(image.At(i, j)[3], alpha, Bound, "alpha of a slab", 1e-6 * extinction);
        check.Near(image.At(i, j)[0], 0.5 * alpha, Bound, "red of a slab", 1e-6 * extinction);
        inside += chord > 0.0 ? 1 : 0;
      }
      check.That(inside > 100, "the slab is visible");
    }
  }
}

/// Compares integrals of extinction and color that vary linearly along a view ray with closed
/// forms.
void TestLinear(Check& check)
{
  const auto integral = [](double a, double b, double c0, double c1)
  {
    LinearPart part;
    part.Length = 1.0;
    part.Extinction = { { a, b } };
    part.Color = { { { { c0, 1.0, 0.0 } }, { { c1, 1.0, 0.0 } } } };
    return Integrate(part);
  };
  const double pi = std::acos(-1.0);
  for (double b : { 1e-3, 1.0, 50.0, 1e4, 1e9 })
  {
    // Extinction from 0 to b and color from 0 to 1: the integral of t * b t * exp(-b t^2 / 2).
    const Light light = integral(0.0, b, 0.0, 1.0);
    const double seen =
      std::sqrt(pi / (2.0 * b)) * std::erf(std::sqrt(0.5 * b)) - std::exp(-0.5 * b);
    check.Near(light.Seen[0], seen, Bound, "increasing extinction and color");
    check.Near(light.Seen[1], -std::expm1(-0.5 * b), Bound, "increasing extinction, one color");
    check.Near(light.Depth, 0.5 * b, 1e-14, "depth of increasing extinction");
    check.Near(light.Emitted[0], b / 3.0, 1e-13, "emission of increasing extinction and color");
    // Constant extinction and decreasing color.
    const Light constant = integral(b, b, 1.0, 0.0);
    const double alpha = -std::expm1(-b);
    check.Near(constant.Seen[0], 1.0 - alpha / b, Bound, "decreasing color", 1.0);
  }
  LinearPart weighted;
  weighted.Length = 3.0;
  weighted.Extinction = { { 1.0, 2.0 } };
  weighted.Weight = { { 0.5, 0.25 } };
  // 3 times the integral of (1 + t) (1/2 - t/4) from 0 to 1.
  check.Near(
    Integrate(weighted).Depth, 3.0 * (0.5 + 0.125 - 1.0 / 12.0), 1e-14, "depth with weights");
}

/// Compares Integrate() with VTK's integrator, which uses single-precision tables.
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
    LinearPart part;
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
      check.Near(found[k], light.Seen[k], 5e-3, "color of VTK's integrator", 1.0);
    }
    check.Near(found[3], light.GetAlpha(), 1e-5, "alpha of VTK's integrator", 1.0);
  }
}

/// Compares each blend mode with its formula for two slabs along z, with the cell values 0 and 1.
void TestTwoSlabs(Check& check)
{
  auto grid = MakeBox({ { 2, 2, 2 } });
  AddSlabIndices(grid, "IntervalId", 2, 2);
  auto camera = LookAt(grid, { { 0.0, 0.0, 1.0 } }, true);
  CameraSettings settings;
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
    return MakeReferenceImage(grid, property, camera, settings);
  };
  ExpectPixel(check, draw(Blend::Composite), 4, 4, all,
    { { alphas[0], std::exp(-0.75) * alphas[1], 0.0 } }, "two slabs, composite");
  ExpectPixel(check, draw(Blend::OpticalDepth), 4, 4, all,
    { { all * depths[0] / 1.15, all * depths[1] / 1.15, 0.0 } }, "two slabs, optical depth");
  ExpectPixel(
    check, draw(Blend::MaximumIntensity), 4, 4, 0.8, { { 0.0, 0.8, 0.0 } }, "two slabs, maximum");
  ExpectPixel(check, draw(Blend::Priority), 4, 4, all,
    { { (1.0 - alphas[1]) * alphas[0], alphas[1], 0.0 } }, "two slabs, default priorities");
  settings.Priorities = { { 0, 7.0 } };
  ExpectPixel(check, draw(Blend::Priority), 4, 4, all,
    { { alphas[0], (1.0 - alphas[0]) * alphas[1], 0.0 } }, "two slabs, given priorities");
  settings.Priorities = { { 0, 1.0 } };
  ExpectPixel(check, draw(Blend::Priority), 4, 4, all,
    { { (1.0 - alphas[1]) * alphas[0], alphas[1], 0.0 } }, "two slabs, equal priorities");

  // The view ray through a pixel's center intersects one or several tetrahedra of a slab.
  const RgbaImage sum = draw(Blend::Additive);
  check.That(sum.At(4, 4)[0] >= alphas[0] - Bound && sum.At(4, 4)[0] < depths[0] &&
      sum.At(4, 4)[1] >= alphas[1] - Bound && sum.At(4, 4)[1] < depths[1],
    "two slabs, sum between the limits of one and infinitely many segments");

  // An opaque surface in the middle of the first slab, then in front of both slabs.
  settings.How = Blend::Composite;
  const double front = -static_cast<double>(PixelRays(camera, settings.Size).Get(4, 4).Origin[2]);
  settings.OpaqueDistance.assign(64, front + 0.25);
  const double half = -std::expm1(-0.375);
  ExpectPixel(check, draw(Blend::Composite), 4, 4, half, { { half, 0.0, 0.0 } }, "cut slab");
  settings.OpaqueDistance.assign(64, front);
  ExpectPixel(check, draw(Blend::Composite), 4, 4, 0.0, { { 0.0, 0.0, 0.0 } }, "hidden slabs");
  settings.OpaqueDistance.clear();
  // The near plane is in the middle of the second slab.
  camera->SetClippingRange(front + 0.75, front + 10.0);
  const double rest = -std::expm1(-0.2);
  ExpectPixel(check, draw(Blend::Composite), 4, 4, rest, { { 0.0, rest, 0.0 } }, "near plane");
}

/// Tests the integration mode that averages the values at both ends of each segment.
void TestAverage(Check& check)
{
  auto grid = MakeBox({ { 1, 1, 1 } });
  auto camera = LookAt(grid, { { 0.0, 0.0, 1.0 } }, true);
  CameraSettings settings;
  settings.Size = { { 9, 9 } };
  AddLinearArray(grid, "depth", 0.0, { { 0.0, 0.0, 1.0 } });
  settings.Arrays.Scalars = "depth";
  settings.Mode = Integration::AverageColor;
  // With a linear opacity function, the mean is exact for segments of any length.
  const RgbaImage straight = MakeReferenceImage(
    grid, MakeProperty({ { 0.0, Red, 0.5 }, { 1.0, Red, 1.5 } }), camera, settings);
  ExpectPixel(check, straight, 4, 4, -std::expm1(-1.0), { { -std::expm1(-1.0), 0.0, 0.0 } },
    "mean of a linear function");
  // The exact integral includes a peak between the ends of a segment, which the mean misses.
  const auto tent = MakeProperty({ { 0.0, Red, 0.0 }, { 0.5, Red, 2.0 }, { 1.0, Red, 0.0 } });
  settings.Mode = Integration::Exact;
  const RgbaImage exact = MakeReferenceImage(grid, tent, camera, settings);
  ExpectPixel(check, exact, 4, 4, -std::expm1(-1.0), { { -std::expm1(-1.0), 0.0, 0.0 } },
    "integral of a peak");
}

/// The image is bit-identical for any order of the tetrahedra.
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
  const CameraSettings settings;
  auto property = MakeRamp(0.5, 5.0);
  const RgbaImage first = MakeReferenceImage(grid, property, camera, settings);
  const RgbaImage second = MakeReferenceImage(shuffled, property, camera, settings);
  check.That(
    CompareImages(first, second).Max == 0.0, "the image does not depend on the order of the cells");
  check.That(LargestAlpha(first) > 0.5, "the image is not empty");
}

/// The image of a linear field does not change when the mesh is refined.
void TestRefined(Check& check)
{
  for (bool parallel : { true, false })
  {
    auto coarse = MakeCube(2);
    auto fine = MakeCube(7);
    auto camera = LookAt(coarse, Slanted, parallel);
    CameraSettings settings;
    auto property = MakeProperty({ { 0.1, Red, 1.0 }, { 0.4, Green, 0.0 }, { 0.45, Gray, 30.0 },
      { 0.6, Red, 0.1 }, { 1.0, Green, 8.0 } });
    for (Blend how : { Blend::Composite, Blend::OpticalDepth, Blend::MaximumIntensity })
    {
      settings.How = how;
      const ImageError error = CompareImages(MakeReferenceImage(coarse, property, camera, settings),
        MakeReferenceImage(fine, property, camera, settings));
      check.Near(error.Max, 0.0, Bound, "difference from a finer mesh", 1.0);
    }
  }
}

/// The opacity of a distant box of thin tetrahedra follows from the length of each view ray in the
/// box.
void TestSlivers(Check& check)
{
  for (double thickness : { 1e-2, 1e-4, 1e-6 })
  {
    auto grid = MakeBox({ { 1, 1, 50 } });
    MovePoints(grid, { { 1e6, -1e6, 1e6 } }, 1.0, { { 1.0, 1.0, 50.0 * thickness } });
    auto camera = LookAt(grid, Slanted, true);
    CameraSettings settings;
    settings.Size = { { 16, 16 } };
    auto property = MakeProperty({ { 0.0, Gray, 1.0 } }, thickness);
    const RgbaImage image = MakeReferenceImage(grid, property, camera, settings);
    for (const auto& [j, i] : AllIndices(16, 16))
    {
      const double chord = GetChordLength(grid, PixelRays(camera, settings.Size).Get(i, j));
      check.Near(image.At(i, j)[3], -std::expm1(-chord / thickness), 1e-8, "thin tetrahedra", 1.0);
    }
  }
}

}

int TestReferencePicture(int, char*[])
{
  return RunChecks({ TestSlab, TestLinear, TestAgainstRayIntegrator, TestTwoSlabs, TestAverage,
    TestOrder, TestRefined, TestSlivers });
}
