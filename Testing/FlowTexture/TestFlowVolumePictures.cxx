// SPDX-License-Identifier: BSD-3-Clause
// Compares vtkImplicitFlowVolumeMapper with images for which a formula gives the flow at each
// sample of a view ray: uniform flow, a rotation, and a strained flow with increasing resolution.
#include "FlowDrawing.h"

#include "Support/Arrays/ReferenceIndices.h"
#include "Support/Checks/LargestError.h"
#include "Support/Checks/ReferenceCheck.h"

#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkPlane.h"

#include <algorithm>
#include <cmath>
#include <iostream>

namespace
{

using namespace reference;

constexpr double PI = 3.14159265358979324;
constexpr double TOLERANCE = 1.0 / 255.0;

/// Colored blocks with sharp edges and opacity 0 or 1.
Color4 Blocks(double u, double v)
{
  const int i = static_cast<int>(6.0 * u);
  const int j = static_cast<int>(6.0 * v);
  return { { 0.2 * (i % 5), 0.25 * (j % 4), 0.5 * ((i + j) % 3),
    (i + 2 * j) % 5 == 0 ? 0.0 : 1.0 } };
}

/// Uniform flow shows the inflow texture unchanged in every cross-section.
void TestImage(Check& check)
{
  vtkSmartPointer<vtkImageData> paint = MakePaint(65, 65, &Blocks);
  FlowScene scene;
  scene.Size = { { 160, 160 } };
  scene.UnitDistance = 0.02;
  scene.Camera = LookAlong({ { -1.0, 0.0, 0.0 } }, true);
  scene.Camera->SetViewUp(0.0, 0.0, 1.0);
  vtkSmartPointer<vtkImageData> voxels = MakeFlowVoxels(17, &Uniform);
  for (const double at : { -0.41, 0.0, 0.37 })
  {
    vtkNew<vtkPlane> near;
    near->SetOrigin(at + 0.06, 0.0, 0.0);
    near->SetNormal(-1.0, 0.0, 0.0);
    vtkNew<vtkPlane> far;
    far->SetOrigin(at - 0.06, 0.0, 0.0);
    far->SetNormal(1.0, 0.0, 0.0);
    vtkNew<vtkImplicitFlowVolumeMapper> mapper;
    mapper->SetInflowTexture(0, paint);
    mapper->AddClippingPlane(near);
    mapper->AddClippingPlane(far);
    const RgbaImage found = DrawFlow(mapper, voxels, scene);
    scene.Flow = &Uniform;
    scene.Paint = [&](const FlowEnd& end) { return LookUpPaint(paint, end.U, end.V); };
    scene.IsRetained = [at](const Position3& x) { return std::abs(x[0] - at) < 0.06; };
    const RgbaImage expected = MakeFlowReferenceImage(scene, 100);
    // The reference image includes the interpolation between texels at the edges of blocks. The
    // direct comparison with the texture excludes edges.
    double sum = 0.0;
    double largest = 0.0;
    int count = 0;
    // u increases from left to right in the image.
    const double pixel = 2.0 * scene.Camera->GetParallelScale() / scene.Size[1];
    for (const auto& [j, i] : AllIndices(scene.Size[1], scene.Size[0]))
    {
      const double y = (i + 0.5 - 0.5 * scene.Size[0]) * pixel;
      const double z = (j + 0.5 - 0.5 * scene.Size[1]) * pixel;
      if (std::max(std::abs(y), std::abs(z)) > 0.5)
      {
        continue;
      }
      bool isEdge = false;
      const Color4 here = Blocks(y + 0.5, z + 0.5);
      for (int corner = 0; corner < 4; ++corner)
      {
        const double reach = 1.0 / 64.0;
        isEdge = isEdge ||
          Blocks(y + 0.5 + (corner % 2 == 0 ? reach : -reach),
            z + 0.5 + (corner / 2 == 0 ? reach : -reach)) != here;
      }
      for (int c = 0; c < 4; ++c)
      {
        const double painted = here[3] * (c < 3 ? here[c] : 1.0);
        const double error = std::abs(found.At(i, j)[c] - painted);
        reference::KeepLargest(largest, isEdge ? 0.0 : error);
        sum += isEdge ? 0.0 : error;
        count += isEdge ? 0 : 1;
      }
    }
    const ImageError error = CompareImages(found, expected);
    std::cout << "cross-section at " << at << ": mean " << sum / count << ", largest " << largest
              << " excluding edges, in " << count
              << " values; difference from the formula: " << error << "\n";
    check.That(count > 4 * 5000 && sum / count <= TOLERANCE, "the mean error of the image");
    check.That(largest <= 2.0 * TOLERANCE, "the largest error of the image away from edges");
    check.That(error.Mean <= TOLERANCE, "the mean error against the formula");
  }
}

/// A smooth texture of two colored spots.
Color4 Spots(const FlowEnd& end)
{
  const double u = std::min(std::max(end.U, 0.0), 1.0);
  const double v = std::min(std::max(end.V, 0.0), 1.0);
  const double a = std::hypot(u - 0.35, v - 0.4) / 0.2;
  const double b = std::hypot(u - 0.6, v - 0.65) / 0.25;
  const double one = std::exp(-a * a);
  const double two = std::exp(-b * b);
  return { { 0.9 * one, 0.2 + 0.5 * two, 0.8 * two, std::min(0.9 * one + 0.4 * two, 0.95) } };
}

vtkSmartPointer<vtkImageData> MakeSpotTexture()
{
  return MakePaint(257, 257, [](double u, double v) { return Spots({ true, 0, u, v, 0.0 }); });
}

/// A rotation about the z-axis that starts at the half-plane y = 0, x > 0 and has a period of 2 pi.
FlowEnd Rotation(const Position3& x)
{
  const double radius = std::hypot(x[0], x[1]);
  const double angle = std::atan2(x[1], x[0]);
  return { true, 4, radius / 0.75, x[2] + 0.5, angle < 0.0 ? angle + 2.0 * PI : angle };
}

/// A strained, swirling flow that starts at the plane x = -0.5.
FlowEnd Strain(const Position3& x)
{
  const double time = x[0] + 0.5;
  const double angle = 1.2 * time;
  const double y = (x[1] * std::cos(angle) + x[2] * std::sin(angle)) * std::exp(0.4 * time);
  const double z = (x[2] * std::cos(angle) - x[1] * std::sin(angle)) * std::exp(-0.3 * time);
  return { true, 0, 0.5 + 0.6 * y, 0.5 + 0.6 * z, time };
}

/// Checks the order of convergence as the voxel size and the sample distance are repeatedly halved.
void TestOrder(Check& check, const std::string& name, const FlowFormula& flow,
  const Position3& direction, double order, double bound)
{
  FlowScene scene;
  scene.Flow = flow;
  scene.Paint = &Spots;
  scene.UnitDistance = 0.4;
  scene.Camera = LookAlong(direction);
  const RgbaImage expected = MakeFlowReferenceImage(scene);
  vtkSmartPointer<vtkImageData> paint = MakeSpotTexture();
  double before = 0.0;
  for (const int n : { 9, 17, 33, 65 })
  {
    vtkNew<vtkImplicitFlowVolumeMapper> mapper;
    mapper->SetInflowTexture(vtkImplicitFlowVolumeMapper::ALL, paint);
    // The reference evaluates the formula at points, without filtering over pixels.
    mapper->TextureFilterOff();
    const ImageError error =
      CompareImages(DrawFlow(mapper, MakeFlowVoxels(n, flow), scene), expected);
    std::cout << name << ", " << n << " voxels: " << error << ", order "
              << std::log2(before / error.Mean) << "\n";
    // With the finest voxels, most of the error is due to ray termination at an opacity of 0.9999.
    check.That(before == 0.0 || n == 65 || std::log2(before / error.Mean) >= order,
      name + ": the order of the error with " + std::to_string(n) + " voxels");
    check.That(n < 65 || error.Mean <= bound, name + ": the mean error");
    before = error.Mean;
  }
}

/// In a rotation, colors just before a full turn must equal those at the start of the turn.
void TestTurn(Check& check)
{
  const auto section = [](double angle)
  {
    // Shows a wedge of 0.2 radians from outside, always at the same position in the image.
    FlowScene scene;
    scene.Size = { { 64, 64 } };
    scene.UnitDistance = 0.05;
    scene.Camera = LookAlong({ { std::sin(angle), -std::cos(angle), 0.0 } }, true);
    scene.Camera->SetViewUp(0.0, 0.0, 1.0);
    vtkNew<vtkPlane> planes[3];
    const double angles[2] = { angle - 0.1, angle + 0.1 };
    for (int i = 0; i < 2; ++i)
    {
      const double sign = i == 0 ? 1.0 : -1.0;
      planes[i]->SetNormal(-sign * std::sin(angles[i]), sign * std::cos(angles[i]), 0.0);
    }
    planes[2]->SetNormal(std::cos(angle), std::sin(angle), 0.0);
    vtkNew<vtkImplicitFlowVolumeMapper> mapper;
    for (const auto& plane : planes)
    {
      mapper->AddClippingPlane(plane);
    }
    mapper->SetInflowTexture(4, MakeSpotTexture());
    return DrawFlow(mapper, MakeFlowVoxels(49, &Rotation), scene);
  };
  const RgbaImage first = section(0.11);
  const ImageError error = CompareImages(section(2.0 * PI - 0.11), first);
  std::cout << "a full turn: " << error << "\n";
  check.That(LargestAlpha(first) > 0.5, "the section is visible");
  check.That(error.Mean <= TOLERANCE && error.Max <= 0.05,
    "the image after a full turn equals the first image");
}
}

int TestFlowVolumePictures(int, char*[])
{
  Check check;
  TestImage(check);
  TestTurn(check);
  TestOrder(check, "rotation", &Rotation, { { -0.5, 0.7, -0.8 } }, 1.8, 4e-5);
  TestOrder(check, "strain", &Strain, { { -0.8, -0.5, -0.3 } }, 1.8, 4e-5);
  return check.Result();
}
