// SPDX-License-Identifier: BSD-3-Clause
// vtkImplicitFlowVolumeMapper against pictures that trace each sample of a line of sight by
// formula: an image through uniform flow, a rotation, a strained flow on finer and finer voxels.
#include "FlowDrawing.h"

#include "Support/Arrays/ReferenceIndices.h"
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

/// Blocks of colours and of opacity 0 and 1, with sharp edges.
Color4 Blocks(double u, double v)
{
  const int i = static_cast<int>(6.0 * u);
  const int j = static_cast<int>(6.0 * v);
  return { { 0.2 * (i % 5), 0.25 * (j % 4), 0.5 * ((i + j) % 3),
    (i + 2 * j) % 5 == 0 ? 0.0 : 1.0 } };
}

/// A painted image comes through uniform flow unchanged, in any cross-section.
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
    const RgbaPicture found = DrawFlow(mapper, voxels, scene);
    scene.Flow = &Uniform;
    scene.Paint = [&](const FlowEnd& answer) { return LookUpPaint(paint, answer.U, answer.V); };
    scene.IsKept = [at](const Place3& x) { return std::abs(x[0] - at) < 0.06; };
    const RgbaPicture expected = MakeFlowPicture(scene, 100);
    // Everywhere, edges too, within what is between a texel's neighbours; the mean away from them.
    double sum = 0.0;
    double largest = 0.0;
    int count = 0;
    // The camera sees u from left to right.
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
        largest = std::max(largest, isEdge ? 0.0 : error);
        sum += isEdge ? 0.0 : error;
        count += isEdge ? 0 : 1;
      }
    }
    const PictureError error = ComparePictures(found, expected);
    std::cout << "cross-section at " << at << ": mean " << sum / count << ", largest " << largest
              << " away from edges of " << count << "; against the formula " << error << "\n";
    check.That(count > 4 * 5000 && sum / count <= TOLERANCE, "the image's mean error");
    check.That(largest <= 2.0 * TOLERANCE, "the image within edges of a texel");
    check.That(error.Mean <= TOLERANCE, "the picture by formula");
  }
}

/// Smooth paint: discs of colour.
Color4 Discs(const FlowEnd& answer)
{
  const double u = std::min(std::max(answer.U, 0.0), 1.0);
  const double v = std::min(std::max(answer.V, 0.0), 1.0);
  const double a = std::hypot(u - 0.35, v - 0.4) / 0.2;
  const double b = std::hypot(u - 0.6, v - 0.65) / 0.25;
  const double one = std::exp(-a * a);
  const double two = std::exp(-b * b);
  return { { 0.9 * one, 0.2 + 0.5 * two, 0.8 * two, std::min(0.9 * one + 0.4 * two, 0.95) } };
}

vtkSmartPointer<vtkImageData> PaintDiscs()
{
  return MakePaint(257, 257, [](double u, double v) { return Discs({ true, 0, u, v, 0.0 }); });
}

/// Turns around the z axis, from the half plane of y = 0, x > 0, in 2 pi.
FlowEnd Rotation(const Place3& x)
{
  const double radius = std::hypot(x[0], x[1]);
  const double angle = std::atan2(x[1], x[0]);
  return { true, 4, radius / 0.75, x[2] + 0.5, angle < 0.0 ? angle + 2.0 * PI : angle };
}

/// Strained and swirling flow from the plane x = -0.5.
FlowEnd Strain(const Place3& x)
{
  const double time = x[0] + 0.5;
  const double turn = 1.2 * time;
  const double y = (x[1] * std::cos(turn) + x[2] * std::sin(turn)) * std::exp(0.4 * time);
  const double z = (x[2] * std::cos(turn) - x[1] * std::sin(turn)) * std::exp(-0.3 * time);
  return { true, 0, 0.5 + 0.6 * y, 0.5 + 0.6 * z, time };
}

/// Errors on voxels of half the size, again and again, with pieces of half the length.
void TestOrder(Check& check, const std::string& name, const FlowFormula& flow,
  const Place3& direction, double order, double bound)
{
  FlowScene scene;
  scene.Flow = flow;
  scene.Paint = &Discs;
  scene.UnitDistance = 0.4;
  scene.Camera = LookAlong(direction);
  const RgbaPicture expected = MakeFlowPicture(scene);
  vtkSmartPointer<vtkImageData> paint = PaintDiscs();
  double before = 0.0;
  for (const int n : { 9, 17, 33, 65 })
  {
    vtkNew<vtkImplicitFlowVolumeMapper> mapper;
    mapper->SetInflowTexture(vtkImplicitFlowVolumeMapper::ALL, paint);
    // The formula is asked at points, not over pixels.
    mapper->PaintFilterOff();
    const PictureError error =
      ComparePictures(DrawFlow(mapper, MakeFlowVoxels(n, flow), scene), expected);
    std::cout << name << ", " << n << " voxels: " << error << ", order "
              << std::log2(before / error.Mean) << "\n";
    // On the finest voxels what is left is the end of a line of sight at an opacity of 0.9999.
    check.That(before == 0.0 || n == 65 || std::log2(before / error.Mean) >= order,
      name + ": the order with " + std::to_string(n) + " voxels");
    check.That(n < 65 || error.Mean <= bound, name + ": the error");
    before = error.Mean;
  }
}

/// A rotation comes round to itself: just after a turn there is what was put in.
void TestTurn(Check& check)
{
  const auto section = [](double angle)
  {
    // A wedge of 0.1, seen from outside, always in the same place of the picture.
    FlowScene scene;
    scene.Size = { { 64, 64 } };
    scene.UnitDistance = 0.05;
    scene.Camera = LookAlong({ { std::sin(angle), -std::cos(angle), 0.0 } }, true);
    scene.Camera->SetViewUp(0.0, 0.0, 1.0);
    vtkNew<vtkPlane> planes[3];
    const double ways[2] = { angle - 0.1, angle + 0.1 };
    for (int i = 0; i < 2; ++i)
    {
      const double sign = i == 0 ? 1.0 : -1.0;
      planes[i]->SetNormal(-sign * std::sin(ways[i]), sign * std::cos(ways[i]), 0.0);
    }
    planes[2]->SetNormal(std::cos(angle), std::sin(angle), 0.0);
    vtkNew<vtkImplicitFlowVolumeMapper> mapper;
    for (const auto& plane : planes)
    {
      mapper->AddClippingPlane(plane);
    }
    mapper->SetInflowTexture(4, PaintDiscs());
    return DrawFlow(mapper, MakeFlowVoxels(49, &Rotation), scene);
  };
  const RgbaPicture first = section(0.11);
  const PictureError error = ComparePictures(section(2.0 * PI - 0.11), first);
  std::cout << "a whole turn: " << error << "\n";
  check.That(LargestAlpha(first) > 0.5, "the section is seen");
  check.That(error.Mean <= TOLERANCE && error.Max <= 0.05, "a turn returns onto itself");
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
