// SPDX-License-Identifier: BSD-3-Clause
// vtkImplicitFlowVolumeMapper at borders between surfaces, at seams, at surfaces where streamlines
// return, and with small features: values do not mix, and letters are legible.
#include "FlowDrawing.h"

#include "Support/Arrays/ReferenceIndices.h"
#include "Support/Checks/ReferenceCheck.h"

#include "vtkCamera.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkImplicitFlowVolumeMapper.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkSignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>

namespace
{

using namespace reference;

constexpr double PI = 3.14159265358979324;

vtkSmartPointer<vtkImageData> MakePlain(const Color4& color)
{
  return MakePaint(2, 2, [&](double, double) { return color; });
}

FlowScene MakeScene(const FlowFormula& flow, const Position3& direction)
{
  FlowScene scene;
  scene.Flow = flow;
  scene.Size = { { 64, 64 } };
  scene.UnitDistance = 0.01;
  scene.Camera = LookAlong(direction, true);
  return scene;
}

/// Clips everything except a slab between two planes perpendicular to z.
void KeepSlab(vtkImplicitFlowVolumeMapper* mapper, double lower, double upper)
{
  for (const bool isLower : { true, false })
  {
    vtkNew<vtkPlane> plane;
    plane->SetOrigin(0.0, 0.0, isLower ? lower : upper);
    plane->SetNormal(0.0, 0.0, isLower ? 1.0 : -1.0);
    mapper->AddClippingPlane(plane);
  }
}

/// Tests two surfaces with very different texture coordinates. Their textures are blue at
/// coordinates that occur only if the coordinates of both surfaces are interpolated.
void TestSurfaces(Check& check)
{
  const auto flow = [](const Position3& x)
  {
    const double side = x[0] + 0.3 * x[1];
    const bool isReached = x[1] < 0.31 + 0.1 * x[0];
    return side < 0.03 ? FlowEnd{ isReached, 3, 0.1, 0.1, 0.0 }
                       : FlowEnd{ isReached, 70, 0.9, 0.9, 0.0 };
  };
  FlowScene scene = MakeScene(flow, { { 0.0, 0.0, -1.0 } });
  vtkNew<vtkImplicitFlowVolumeMapper> mapper;
  mapper->SetInflowTexture(3,
    MakePaint(64, 64,
      [](double u, double) {
        return u < 0.3 ? Color4{ { 1, 0, 0, 1 } } : Color4{ { 0, 0, 1, 1 } };
      }));
  mapper->SetInflowTexture(70,
    MakePaint(64, 64,
      [](double u, double) {
        return u > 0.7 ? Color4{ { 0, 1, 0, 1 } } : Color4{ { 0, 0, 1, 1 } };
      }));
  const int n = 24;
  const RgbaImage found = DrawFlow(mapper, MakeFlowVoxels(n, flow), scene);
  scene.Paint = [](const FlowEnd& end) {
    return end.Id == 3 ? Color4{ { 1, 0, 0, 1 } } : Color4{ { 0, 1, 0, 1 } };
  };
  const RgbaImage expected = MakeFlowReferenceImage(scene, 100);
  double blue = 0.0;
  double mixed = 0.0;
  int shifted = 0;
  for (const auto& [j, i] : AllIndices(scene.Size[1], scene.Size[0]))
  {
    const double* pixel = found.At(i, j);
    blue = std::max(blue, pixel[2]);
    mixed = std::max(mixed, std::min(pixel[0], pixel[1]));
    shifted += std::abs(pixel[0] - expected.At(i, j)[0]) > 0.5 ||
        std::abs(pixel[3] - expected.At(i, j)[3]) > 0.5
      ? 1
      : 0;
  }
  std::cout << "two surfaces: blue " << blue << ", mixed " << mixed << ", shifted border pixels "
            << shifted << "\n";
  check.That(blue < 1e-6, "texture coordinates of two surfaces are not mixed");
  check.That(mixed < 1e-6, "colors of two surfaces are not mixed");
  // Borders are shifted by at most half a cell. Each border is 53 pixels long, and half a cell is
  // 36 / 23 / 2 pixels wide.
  check.That(shifted < 2 * 53 * 36 / 23 / 2, "borders are within half a cell");
  check.That(mapper->GetReport()->GetNumber("SplitCells") > 0 &&
      mapper->GetReport()->GetNumber("Surfaces") == 2,
    "cells between surfaces are counted");
}

/// At a seam, u jumps after a full turn around the axis. If u is periodic, the texture between the
/// two values of u must not be visible.
void TestSeam(Check& check, bool isPeriodic)
{
  const auto flow = [](const Position3& x)
  {
    const double turns = std::atan2(x[1], x[0]) / (2.0 * PI);
    return FlowEnd{ std::hypot(x[0], x[1]) > 0.2, 5, turns < 0.0 ? turns + 1.0 : turns, x[2] + 0.5,
      0.0 };
  };
  FlowScene scene = MakeScene(flow, { { 0.0, 0.0, -1.0 } });
  vtkNew<vtkImplicitFlowVolumeMapper> mapper;
  mapper->SetInflowTexture(5,
    MakePaint(128, 4,
      [](double u, double) {
        return u > 0.3 && u < 0.7 ? Color4{ { 1, 0, 0, 1 } } : Color4{ { 0, 1, 0, 1 } };
      }));
  std::vector<std::array<int, 3>> periods;
  if (isPeriodic)
  {
    periods.push_back({ { 5, 1, 0 } });
  }
  const RgbaImage found = DrawFlow(mapper, MakeFlowVoxels(24, flow, periods), scene);
  // The seam is to the right of the axis.
  double red = 0.0;
  double green = 0.0;
  for (int j = 20; j < 44; ++j)
  {
    for (int i = 44; i < 50; ++i)
    {
      red = std::max(red, found.At(i, j)[0]);
      green = std::max(green, found.At(i, j)[1]);
    }
  }
  std::cout << "seam, periodic " << isPeriodic << ": red " << red << ", green " << green << "\n";
  check.That(green > 0.9, "the seam is visible");
  check.That(isPeriodic ? red < 1e-6 : red > 0.2, "the texture at the seam");
}

/// Returns the number of cells with a jump of u in a grid of n^3 voxels.
vtkIdType CountJumps(vtkImageData* voxels, int n)
{
  vtkDataArray* coordinates = voxels->GetPointData()->GetArray("TerminationUV");
  vtkIdType count = 0;
  for (int cell = 0; cell < (n - 1) * (n - 1) * (n - 1); ++cell)
  {
    const int at[3] = { cell % (n - 1), cell / (n - 1) % (n - 1), cell / (n - 1) / (n - 1) };
    double lower = 1.0;
    double upper = 0.0;
    for (int corner = 0; corner < 8; ++corner)
    {
      const int i = at[0] + (corner & 1);
      const int j = at[1] + (corner >> 1 & 1);
      const int k = at[2] + (corner >> 2);
      const double u = coordinates->GetComponent(i + n * (j + n * k), 0);
      lower = std::min(lower, u);
      upper = std::max(upper, u);
    }
    count += upper - lower > 0.5 ? 1 : 0;
  }
  return count;
}

/// Tests a spiral seam. The mapper must resolve all of it except one half-plane, and the image must
/// equal that of the formula.
void TestWoundSeam(Check& check)
{
  const auto flow = [](const Position3& x)
  {
    const double turns = std::atan2(x[1], x[0]) / (2.0 * PI) + 5.0 * std::hypot(x[0], x[1]);
    return FlowEnd{ true, 5, turns - std::floor(turns), x[2] + 0.5, 0.0 };
  };
  const auto paint = [](double u, double v)
  {
    return Color4{ { 0.5 + 0.5 * std::sin(2.0 * PI * u), 0.5 + 0.5 * std::cos(2.0 * PI * u), v,
      0.01 } };
  };
  FlowScene scene = MakeScene(flow, { { -0.3, 0.4, -0.8 } });
  scene.Paint = [&](const FlowEnd& end) { return paint(end.U, end.V); };
  const RgbaImage expected = MakeFlowReferenceImage(scene, 400);
  const int n = 41;
  vtkSmartPointer<vtkImageData> voxels = MakeFlowVoxels(n, flow, { { { 5, 1, 0 } } });
  vtkNew<vtkImplicitFlowVolumeMapper> mapper;
  mapper->SetInflowTexture(5, MakePaint(257, 33, paint));
  const ImageError error = CompareImages(DrawFlow(mapper, voxels, scene), expected);
  const vtkIdType jumps = CountJumps(voxels, n);
  const vtkIdType remaining = mapper->GetReport()->GetNumber("SplitCells");
  std::cout << "a wound seam: " << error << "; " << jumps << " cells with jumps, " << remaining
            << " remaining\n";
  check.That(error.Mean < 1e-3, "a wound seam: mean error " + std::to_string(error.Mean));
  check.That(jumps > 5000, "the seam is wound up");
  check.That(remaining < jumps / 4, "remaining cells: " + std::to_string(remaining));
}

/// Tests streamlines that return to the half-plane where they started. The advection times on its
/// two sides must not be mixed.
void TestSides(Check& check)
{
  const auto flow = [](const Position3& x)
  {
    const double angle = std::atan2(x[1], x[0]);
    return FlowEnd{ std::hypot(x[0], x[1]) > 0.1, 2, 0.5, 0.5,
      angle < 0.0 ? angle + 2.0 * PI : angle };
  };
  const int n = 25;
  vtkSmartPointer<vtkImageData> voxels = MakeFlowVoxels(n, flow);
  // Streamlines move toward the plane on one side, and away from it on the other side. n is odd, so
  // that some voxels are on the plane.
  vtkNew<vtkSignedCharArray> sides;
  sides->SetName("TerminationSide");
  for (vtkIdType i = 0; i < voxels->GetNumberOfPoints(); ++i)
  {
    const double* x = voxels->GetPoint(i);
    const bool isNearPlane =
      x[0] > -0.02 && std::abs(x[1]) < 1.5 / (n - 1) && std::abs(x[1]) > 1e-9;
    sides->InsertNextValue(static_cast<signed char>(isNearPlane ? (x[1] > 0.0 ? 1 : -2) : 0));
  }
  FlowScene scene = MakeScene(flow, { { 0.0, 0.0, -1.0 } });
  scene.Size = { { 256, 256 } };
  // The time gate shows only dye that entered about half a turn ago, which is far from the plane.
  vtkNew<vtkPiecewiseFunction> gate;
  gate->AddPoint(-2.0 * PI, 0.0);
  gate->AddPoint(-PI - 1.0, 0.0);
  gate->AddPoint(-PI - 0.9, 1.0);
  gate->AddPoint(-PI + 0.9, 1.0);
  gate->AddPoint(-PI + 1.0, 0.0);
  gate->AddPoint(0.0, 0.0);
  for (const bool hasSides : { false, true })
  {
    if (hasSides)
    {
      voxels->GetPointData()->AddArray(sides);
    }
    vtkNew<vtkImplicitFlowVolumeMapper> mapper;
    mapper->SetInflowTexture(2, MakePlain({ { 1, 1, 1, 1 } }));
    mapper->SetTimeGate(gate);
    mapper->TimeGateRepeatOff();
    const RgbaImage found = DrawFlow(mapper, voxels, scene);
    double nearPlane = 0.0;
    for (int j = 104; j < 152; ++j)
    {
      for (int i = 170; i < 200; ++i)
      {
        nearPlane = std::max(nearPlane, found.At(i, j)[3]);
      }
    }
    std::cout << "times with sides " << hasSides << ": " << nearPlane << " near the plane\n";
    check.That(hasSides ? nearPlane < 1e-6 : nearPlane > 0.5, "times on both sides of a surface");
    check.That(LargestAlpha(found) > 0.9, "dye from half a turn ago is visible");
  }
}

/// Returns true inside the letter E with strokes of width 0.1. Coordinates are in [0, 1].
bool IsInLetter(double u, double v)
{
  const bool isStem = u > 0.3 && u < 0.4;
  const bool isBar =
    u > 0.3 && u < 0.7 && ((v > 0.2 && v < 0.3) || (v > 0.45 && v < 0.55) || (v > 0.7 && v < 0.8));
  return v > 0.2 && v < 0.8 && (isStem || isBar);
}

/// Tests a letter six cells high, ten cells downstream in a flow that rotates and strains it.
void TestLetter(Check& check)
{
  const int n = 21;
  const auto flow = [](const Position3& x)
  {
    const double time = x[2] + 0.5;
    const double angle = 0.8 * time;
    const double a = (x[0] * std::cos(angle) + x[1] * std::sin(angle)) * std::exp(0.2 * time);
    const double b = (x[1] * std::cos(angle) - x[0] * std::sin(angle)) * std::exp(-0.2 * time);
    return FlowEnd{ true, 0, 0.5 + 2.0 * a, 0.5 + 2.0 * b, time };
  };
  FlowScene scene = MakeScene(flow, { { 0.0, 0.0, -1.0 } });
  scene.Size = { { 160, 160 } };
  scene.UnitDistance = 0.002;
  vtkNew<vtkImplicitFlowVolumeMapper> mapper;
  const auto letter = [](double u, double v) {
    return Color4{ { 1.0, 1.0, 1.0, IsInLetter(u, v) ? 1.0 : 0.0 } };
  };
  mapper->SetInflowTexture(0, MakePaint(512, 512, letter));
  KeepSlab(mapper, -0.01, 0.01);
  const RgbaImage found = DrawFlow(mapper, MakeFlowVoxels(n, flow), scene);
  scene.Paint = [&](const FlowEnd& end) { return letter(end.U, end.V); };
  scene.IsRetained = [](const Position3& x) { return std::abs(x[2]) < 0.01; };
  const RgbaImage expected = MakeFlowReferenceImage(scene, 400);
  int inside = 0;
  int different = 0;
  for (const auto& [j, i] : AllIndices(scene.Size[1], scene.Size[0]))
  {
    const bool isExpected = expected.At(i, j)[3] > 0.5;
    inside += isExpected ? 1 : 0;
    different += isExpected != (found.At(i, j)[3] > 0.5) ? 1 : 0;
  }
  const ImageError error = CompareImages(found, expected);
  std::cout << "a letter: " << different << " different pixels of " << inside << "; " << error
            << "\n";
  // Strokes are 1/20 wide, that is, one cell or about 5 pixels.
  check.That(inside > 300 && different < 0.1 * inside, "a letter ten cells downstream");
}

/// With filtering, stripes finer than a pixel become gray, without moire patterns.
void TestFilter(Check& check)
{
  const auto flow = [](const Position3& x) {
    return FlowEnd{ true, 0, x[0] + 0.5, x[1] + 0.5, 0.0 };
  };
  FlowScene scene = MakeScene(flow, { { 0.0, 0.0, -1.0 } });
  // The stripes cover half of the area on average.
  vtkSmartPointer<vtkImageData> stripes = MakePaint(2048, 2,
    [](double u, double)
    {
      const double at = 2047.0 * u / 10.7;
      return Color4{ { at - std::floor(at) < 0.5 ? 1.0 : 0.0, 0.0, 0.0, 1.0 } };
    });
  double spread[2] = { 0.0, 0.0 };
  for (const bool isFiltered : { false, true })
  {
    vtkNew<vtkImplicitFlowVolumeMapper> mapper;
    mapper->SetInflowTexture(0, stripes);
    mapper->SetTextureFilter(isFiltered);
    const RgbaImage found = DrawFlow(mapper, MakeFlowVoxels(9, flow), scene);
    for (int i = 20; i < 44; ++i)
    {
      spread[isFiltered ? 1 : 0] =
        std::max(spread[isFiltered ? 1 : 0], std::abs(found.At(i, 32)[0] - 0.5));
    }
  }
  std::cout << "stripes off from gray: " << spread[0] << ", filtered " << spread[1] << "\n";
  check.That(spread[0] > 0.3 && spread[1] < 0.2, "stripes finer than pixels are gray");
}
}

int TestFlowVolumeBorders(int, char*[])
{
  Check check;
  TestSurfaces(check);
  TestSeam(check, true);
  TestSeam(check, false);
  TestWoundSeam(check);
  TestSides(check);
  TestLetter(check);
  TestFilter(check);
  return check.Result();
}
