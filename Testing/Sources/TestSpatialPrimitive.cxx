// SPDX-License-Identifier: BSD-3-Clause
// Every shape compared with its definition, soft and hard, translated and rotated. Also tests
// equation 2.7 of C. Zhang's dissertation, volumes whose error is proportional to the spacing, tiny
// and huge sizes, and rejected sizes.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceMessages.h"
#include "Support/Checks/ReferenceProgress.h"
#include "Support/Meshes/ReferenceImageSource.h"

#include "vtkConstructiveVolume.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkMinimalStandardRandomSequence.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSpatialPrimitive.h"
#include "vtkTransform.h"

#include <array>
#include <cmath>
#include <limits>
#include <string>

namespace
{

using namespace reference;
using Vector = std::array<double, 3>;

const double Pi = std::acos(-1.0);
const double Scales[3] = { 1e-6, 1.0, 1e6 };

vtkSmartPointer<vtkSpatialPrimitive> MakePrimitive(int shape, double scale)
{
  auto primitive = vtkSmartPointer<vtkSpatialPrimitive>::New();
  primitive->SetShape(shape);
  primitive->SetCenter(0.05 * scale, -0.1 * scale, 0.15 * scale);
  primitive->SetRadius(0.6 * scale);
  primitive->SetInnerRadius(0.35 * scale);
  primitive->SetTubeRadius(0.2 * scale);
  primitive->SetHeight(0.9 * scale);
  primitive->SetLengths(0.7 * scale, 1.1 * scale, 0.9 * scale);
  return primitive;
}

// Returns the signed distance to the surface, negative inside, computed from the closest point.
double GetDistance(int shape, const Vector& p)
{
  const double rho = std::hypot(p[0], p[1]);
  switch (shape)
  {
    case vtkSpatialPrimitive::SPHERE:
      return std::hypot(rho, p[2]) - 0.6;
    case vtkSpatialPrimitive::TORUS:
      return std::hypot(rho - 0.6, p[2]) - 0.2;
    case vtkSpatialPrimitive::HALF_SPACE:
      return p[2];
    case vtkSpatialPrimitive::CYLINDER:
    {
      const double side = rho - 0.6;
      const double end = std::fabs(p[2]) - 0.45;
      return side > 0.0 && end > 0.0 ? std::hypot(side, end) : std::max(side, end);
    }
    default:
    {
      const double half[3] = { 0.35, 0.55, 0.45 };
      double outside = 0.0;
      double inside = 1.0;
      for (int i = 0; i < 3; ++i)
      {
        const double nearest = std::max(-half[i], std::min(p[i], half[i]));
        outside += (p[i] - nearest) * (p[i] - nearest);
        inside = std::min(inside, half[i] - std::fabs(p[i]));
      }
      return outside > 0.0 ? std::sqrt(outside) : -inside;
    }
  }
}

double GetDensity(int shape, const Vector& p, double width)
{
  if (shape == vtkSpatialPrimitive::FUZZY_SPHERE)
  {
    const double r2 = p[0] * p[0] + p[1] * p[1] + p[2] * p[2];
    if (r2 <= 0.35 * 0.35)
    {
      return 1.0;
    }
    return r2 >= 0.36 ? 0.0 : (0.36 - r2) / (0.36 - 0.35 * 0.35);
  }
  const double distance = GetDistance(shape, p);
  if (std::fabs(distance) >= 0.5 * width)
  {
    return distance <= 0.0 ? 1.0 : 0.0;
  }
  const double t = 2.0 * distance / width;
  // The smooth step, centered at the surface.
  return 0.5 - 0.75 * t + 0.25 * t * t * t;
}

void CheckShapes(Check& check)
{
  vtkNew<vtkMinimalStandardRandomSequence> random;
  for (int shape = 0; shape < vtkSpatialPrimitive::IMPLICIT_FUNCTION; ++shape)
  {
    for (double scale : Scales)
    {
      for (double width : { 0.0, 0.3 })
      {
        check.SetContext(std::string(vtkSpatialPrimitive::GetShapeName(shape)) + ", scale " +
          std::to_string(scale) + ", edge " + std::to_string(width));
        const auto primitive = MakePrimitive(shape, scale);
        primitive->SetEdgeWidth(width * scale);
        primitive->SetDensity(0.8);
        primitive->SetColor(0.1, 0.2, 0.3);
        vtkNew<vtkTransform> transform;
        transform->Translate(2.0 * scale, 3.0 * scale, -1.0 * scale);
        transform->RotateWXYZ(50.0, 3.0, -1.0, 2.0);
        primitive->SetTransform(transform);
        double bounds[6];
        primitive->GetBounds(bounds);
        int dense = 0;
        for (int i = 0; i < 2000; ++i)
        {
          Vector p;
          Vector x;
          for (int axis = 0; axis < 3; ++axis)
          {
            p[axis] = random->GetNextRangeValue(-1.0, 1.0);
          }
          x = { { scale * (p[0] + 0.05), scale * (p[1] - 0.1), scale * (p[2] + 0.15) } };
          transform->TransformPoint(x.data(), x.data());
          vtkSpatialObject::Sample sample;
          primitive->Evaluate(x.data(), sample);
          check.Near(sample.Density, 0.8 * GetDensity(shape, p, width), 1e-12, "density", 1.0);
          if (sample.Density > 0.0)
          {
            ++dense;
            check.Near(sample.Color[1], 0.2, 0.0, "green");
            check.That(x[0] >= bounds[0] && x[0] <= bounds[1] && x[1] >= bounds[2] &&
                x[1] <= bounds[3] && x[2] >= bounds[4] && x[2] <= bounds[5],
              "density is inside the bounds");
          }
        }
        check.That(dense > 50, "there is density");
      }
    }
  }
}

double GetVolume(vtkConstructiveVolume* source)
{
  source->Update();
  auto* values =
    vtkFloatArray::SafeDownCast(source->GetOutput()->GetPointData()->GetArray("Density"));
  double sum = 0.0;
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    sum += values->GetValue(i);
  }
  const double* spacing = source->GetOutput()->GetSpacing();
  return sum * spacing[0] * spacing[1] * spacing[2];
}

// The sum of sampled densities converges to the volume with first order, for hard edges and for
// soft edges.
void CheckVolumes(Check& check)
{
  const double r0 = 0.6;
  const double r1 = 0.35;
  // 4 pi times the integral of r^2 (r0^2 - r^2) / (r0^2 - r1^2) from r1 to r0, plus the volume of
  // the core.
  const double fuzzy = 4.0 * Pi *
    (std::pow(r1, 3) / 3.0 +
      (r0 * r0 * (std::pow(r0, 3) - std::pow(r1, 3)) / 3.0 -
        (std::pow(r0, 5) - std::pow(r1, 5)) / 5.0) /
        (r0 * r0 - r1 * r1));
  const double volumes[vtkSpatialPrimitive::IMPLICIT_FUNCTION] = { 4.0 / 3.0 * Pi * 0.216,
    0.7 * 1.1 * 0.9, Pi * 0.36 * 0.9, 2.0 * Pi * Pi * 0.6 * 0.04, 4.0 * 1.15, fuzzy };
  for (int shape = 0; shape < vtkSpatialPrimitive::IMPLICIT_FUNCTION; ++shape)
  {
    for (double scale : Scales)
    {
      check.SetContext(std::string("volume, ") + vtkSpatialPrimitive::GetShapeName(shape) +
        ", scale " + std::to_string(scale));
      vtkNew<vtkConstructiveVolume> source;
      source->SetRoot(MakePrimitive(shape, scale));
      for (int points : { 40, 80, 160 })
      {
        // The points are the centers of cells that fill the region.
        const double half = scale * (1.0 - 1.0 / points);
        source->SetBounds(-half, half, -half, half, -half, half);
        source->SetDimensions(points, points, points);
        check.Near(GetVolume(source) / std::pow(scale, 3), volumes[shape], 2.5 / points,
          "volume with " + std::to_string(points) + " points", 1.0);
      }
    }
  }
}

void CheckRejections(Check& check)
{
  check.SetContext("refusals");
  vtkNew<vtkSpatialPrimitive> primitive;
  const double infinity = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (double bad : { 0.0, -1.0, infinity, nan })
  {
    check.That(!CaptureErrors(primitive, [&] { primitive->SetRadius(bad); }).empty(), "a radius");
    check.That(!CaptureErrors(primitive, [&] { primitive->SetTubeRadius(bad); }).empty(), "a tube");
    check.That(!CaptureErrors(primitive, [&] { primitive->SetHeight(bad); }).empty(), "a height");
    check.That(
      !CaptureErrors(primitive, [&] { primitive->SetLengths(1.0, bad, 1.0); }).empty(), "a length");
    check.Equal(!CaptureErrors(primitive, [&] { primitive->SetInnerRadius(bad); }).empty(),
      bad != 0.0, "an inner radius");
    check.Equal(!CaptureErrors(primitive, [&] { primitive->SetEdgeWidth(bad); }).empty(),
      bad != 0.0, "an edge");
    check.Equal(!CaptureErrors(primitive, [&] { primitive->SetCenter(0.0, 0.0, bad); }).empty(),
      !std::isfinite(bad), "a center");
  }
  check.That(primitive->GetRadius() == 0.5 && primitive->GetTubeRadius() == 0.1 &&
      primitive->GetHeight() == 1.0 && primitive->GetLengths()[1] == 1.0 &&
      primitive->GetInnerRadius() == 0.0 && primitive->GetCenter()[2] == -1.0,
    "invalid sizes are ignored");
  primitive->SetDensity(nan);
  primitive->SetColor(2.0, -1.0, nan);
  check.That(primitive->GetDensity() == 1.0 && primitive->GetColor()[0] == 1.0 &&
      primitive->GetColor()[1] == 0.0 && primitive->GetColor()[2] == 1.0,
    "density and color are clamped");
  primitive->SetShapeToFuzzySphere();
  primitive->SetInnerRadius(0.5);
  vtkSpatialObject::Sample sample;
  const double x[3] = { 0.0, 0.0, 0.0 };
  check.Contains(CaptureErrors(primitive, [&] { primitive->Evaluate(x, sample); }), "inner radius");
  check.Near(sample.Density, 0.0, 0.0, "density of an invalid primitive is 0");
  primitive->SetShapeToBox();
  vtkNew<vtkTransform> flat;
  flat->Scale(1.0, 0.0, 1.0);
  primitive->SetTransform(flat);
  check.Contains(CaptureErrors(primitive, [&] { primitive->Evaluate(x, sample); }), "no inverse");
  vtkNew<vtkTransform> sheared;
  const double elements[16] = { 1.0, 2.0, 3.0, 0.0, 4.0, 5.0, 9.0, 0.0, 7.0, 8.0,
    15.000000000000002, 0.0, 0.0, 0.0, 0.0, 1.0 };
  sheared->SetMatrix(elements);
  primitive->SetTransform(sheared);
  check.Contains(CaptureErrors(primitive, [&] { primitive->Evaluate(x, sample); }), "no inverse");
  vtkNew<vtkTransform> far;
  far->Translate(infinity, 0.0, 0.0);
  primitive->SetTransform(far);
  check.Contains(CaptureErrors(primitive, [&] { primitive->Evaluate(x, sample); }), "not finite");
  CheckPrinted(Print(primitive),
    { "Shape: box", "Radius: 0.5", "InnerRadius: 0.5", "Height: 1", "TubeRadius: 0.1",
      "Lengths: 1 1 1", "EdgeWidth: 0", "Center: 0", "Density: 1", "Color: 1 0 1", "Transform:" },
    check);
  check.That(vtkSpatialPrimitive::GetShapeName(-1) == nullptr, "an invalid index has no name");
}

}

int TestSpatialPrimitive(int, char*[])
{
  return RunChecks({ CheckShapes, CheckVolumes, CheckRejections });
}
