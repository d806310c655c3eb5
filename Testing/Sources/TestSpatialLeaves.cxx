// SPDX-License-Identifier: BSD-3-Clause
// Leaves of a spatial tree. Implicit functions: which points are inside, the edge width in units of
// length, and limits. Images: trilinear interpolation of a linear field for any direction and
// extent, scalar range, NaN, and colors. Also tests the errors of both.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceMessages.h"
#include "Support/Checks/ReferenceProgress.h"
#include "Support/Meshes/ReferenceImageSource.h"

#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkMinimalStandardRandomSequence.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkQuadric.h"
#include "vtkSpatialImage.h"
#include "vtkSpatialPrimitive.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace
{

using namespace reference;
using Sample = vtkSpatialObject::Sample;

void CheckImplicit(Check& check)
{
  check.SetContext("implicit");
  // The sphere x^2 + y^2 + z^2 - 1 = 0. The values of this function are not distances.
  vtkNew<vtkQuadric> sphere;
  sphere->SetCoefficients(1.0, 1.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0);
  vtkNew<vtkSpatialPrimitive> object;
  object->SetShapeToImplicitFunction();
  Sample sample;
  const double origin[3] = { 0.0, 0.0, 0.0 };
  check.Contains(CaptureErrors(object, [&] { object->Evaluate(origin, sample); }), "no function");
  object->SetFunction(sphere);
  object->SetColor(0.5, 0.25, 0.125);
  for (double width : { 0.0, 0.2 })
  {
    object->SetEdgeWidth(width);
    vtkNew<vtkMinimalStandardRandomSequence> random;
    for (int i = 0; i < 3000; ++i)
    {
      double x[3];
      for (double& coordinate : x)
      {
        coordinate = random->GetNextRangeValue(-1.2, 1.2);
      }
      const double r = std::sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
      object->Evaluate(x, sample);
      // Distance estimate f / |grad f|.
      const double distance = (r * r - 1.0) / (2.0 * r);
      const double t = width > 0.0 ? std::max(-1.0, std::min(2.0 * distance / width, 1.0)) : 0.0;
      const double soft = 0.5 - 0.75 * t + 0.25 * t * t * t;
      check.Near(sample.Density, width > 0.0 ? soft : double(r <= 1.0), 1e-12, "density", 1.0);
    }
    object->Evaluate(origin, sample);
    check.Near(sample.Density, 1.0, 0.0, "density where the gradient is zero");
  }
  const double limits[6] = { -0.5, 0.5, -2.0, 2.0, 0.0, 3.0 };
  object->SetLimits(limits);
  double bounds[6];
  object->GetBounds(bounds);
  check.That(std::equal(limits, limits + 6, bounds), "the limits are the bounds");
  const double outside[3] = { 0.0, 0.0, -0.001 };
  object->Evaluate(outside, sample);
  check.Near(sample.Density, 0.0, 0.0, "density outside the limits");
  const double bad[6] = { 0.5, -0.5, -2.0, 2.0, 0.0, 3.0 };
  check.That(
    !CaptureErrors(object, [&] { object->SetLimits(bad); }).empty(), "limits out of order");
  const vtkMTimeType before = object->GetMTime();
  sphere->SetCoefficients(1.0, 1.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0);
  check.That(object->GetMTime() > before, "modifying the function modifies the object");
  object->Evaluate(origin, sample);
  check.Near(sample.Density, 0.0, 0.0, "density with the modified function");
  CheckPrinted(
    Print(object), { "Limits: -0.5 0.5 -2 2 0 3", "Function:", "Color: 0.5 0.25" }, check);
}

vtkSmartPointer<vtkImageData> MakeImage()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetExtent(-2, 5, 1, 7, 3, 8);
  image->SetOrigin(0.3, -0.2, 0.1);
  image->SetSpacing(0.25, 0.5, 0.125);
  image->SetDirectionMatrix(0.6, -0.8, 0.0, 0.8, 0.6, 0.0, 0.0, 0.0, 1.0);
  vtkNew<vtkDoubleArray> values;
  vtkNew<vtkUnsignedCharArray> colors;
  vtkNew<vtkDoubleArray> reals;
  colors->SetName("bytes");
  colors->SetNumberOfComponents(3);
  reals->SetName("reals");
  reals->SetNumberOfComponents(4);
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    double x[3];
    image->GetPoint(i, x);
    values->InsertNextValue(10.0 + x[0] - 2.0 * x[1] + 3.0 * x[2]);
    colors->InsertNextTuple3(51.0, 0.0, 255.0);
    reals->InsertNextTuple4(0.25 + 0.01 * x[0], 2.0, 0.75, 1.0);
  }
  image->GetPointData()->SetScalars(values);
  image->GetPointData()->AddArray(colors);
  image->GetPointData()->AddArray(reals);
  return image;
}

void CheckImage(Check& check)
{
  check.SetContext("image");
  const auto image = MakeImage();
  vtkNew<vtkSpatialImage> object;
  Sample sample;
  double x[3] = { 0.0, 0.0, 0.0 };
  check.Contains(CaptureErrors(object, [&] { object->Evaluate(x, sample); }), "no image");
  object->SetImage(image);
  object->SetScalarRange(14.0, 6.0);
  object->SetDensity(0.5);
  object->SetColorArrayName("reals");
  vtkNew<vtkMinimalStandardRandomSequence> random;
  double bounds[6];
  object->GetBounds(bounds);
  int inside = 0;
  for (int i = 0; i < 5000; ++i)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      x[axis] = random->GetNextRangeValue(bounds[2 * axis] - 0.1, bounds[2 * axis + 1] + 0.1);
    }
    double ijk[3];
    image->TransformPhysicalPointToContinuousIndex(x, ijk);
    const bool isInside =
      ijk[0] >= -2 && ijk[0] <= 5 && ijk[1] >= 1 && ijk[1] <= 7 && ijk[2] >= 3 && ijk[2] <= 8;
    inside += isInside;
    const double density = (4.0 - x[0] + 2.0 * x[1] - 3.0 * x[2]) / 8.0;
    object->Evaluate(x, sample);
    check.Near(sample.Density, isInside ? 0.5 * std::max(0.0, std::min(density, 1.0)) : 0.0, 1e-6,
      "density", 1.0);
    if (sample.Density > 0.0)
    {
      check.Near(sample.Color[0], 0.25 + 0.01 * x[0], 1e-6, "red", 1.0);
      check.Near(sample.Color[1], 1.0, 1e-6, "green, clamped", 1.0);
    }
  }
  check.That(inside > 500, "points inside");
  // The last point of the image has no next point along any axis to interpolate with.
  image->GetPoint(image->GetNumberOfPoints() - 1, x);
  vtkDataArray* values = image->GetPointData()->GetScalars();
  const double last = values->GetTuple1(image->GetNumberOfPoints() - 1);
  object->SetScalarRange(0.0, 100.0);
  object->Evaluate(x, sample);
  check.Near(sample.Density, 0.5 * last / 100.0, 1e-6, "density at the last point");
  object->SetColorArrayName("bytes");
  object->Evaluate(x, sample);
  check.Near(sample.Color[0], 0.2, 1e-6, "red of bytes");
  object->SetColorArrayName(nullptr);
  object->Evaluate(x, sample);
  check.Near(sample.Color[0], 1.0, 0.0, "red without an array");
  // The last two values of a row are 100 and NaN. Midway between them, half of 100 contributes.
  values->SetComponent(image->GetNumberOfPoints() - 2, 0, 100.0);
  values->SetComponent(image->GetNumberOfPoints() - 1, 0, std::nan(""));
  values->Modified();
  image->Modified();
  object->Evaluate(x, sample);
  check.Near(sample.Density, 0.0, 1e-15, "density of NaN", 1.0);
  double before[3];
  image->GetPoint(image->GetNumberOfPoints() - 2, before);
  const double between[3] = { 0.5 * (x[0] + before[0]), 0.5 * (x[1] + before[1]), x[2] };
  object->Evaluate(between, sample);
  check.Near(sample.Density, 0.25, 1e-6, "density next to NaN");
  CheckPrinted(Print(object), { "ScalarRange: 0 100", "ColorArrayName: ", "Image:" }, check);
}

void CheckRejections(Check& check)
{
  check.SetContext("refusals");
  vtkNew<vtkSpatialImage> object;
  Sample sample;
  const double x[3] = { 0.0, 0.0, 0.0 };
  for (double bad : { 0.0, std::numeric_limits<double>::infinity(), std::nan("") })
  {
    check.That(
      !CaptureErrors(object, [&] { object->SetScalarRange(0.0, bad); }).empty(), "a range");
  }
  check.Near(object->GetScalarRange()[1], 1.0, 0.0, "an invalid range is ignored");
  const auto image = MakeImage();
  object->SetImage(image);
  object->SetColorArrayName("nothing");
  check.Contains(CaptureErrors(object, [&] { object->Evaluate(x, sample); }),
    "The image has no point array \"nothing\".");
  vtkNew<vtkImageData> empty;
  object->SetImage(empty);
  check.Contains(CaptureErrors(object, [&] { object->Evaluate(x, sample); }), "point scalars");
}

// An image with one layer of points.
void CheckFlat(Check& check)
{
  check.SetContext("flat");
  vtkNew<vtkImageData> image;
  image->SetDimensions(3, 1, 2);
  vtkNew<vtkDoubleArray> values;
  for (double value : { 0.0, 0.5, 1.0, 0.5, 1.0, 1.5 })
  {
    values->InsertNextValue(value);
  }
  image->GetPointData()->SetScalars(values);
  vtkNew<vtkSpatialImage> object;
  object->SetImage(image);
  Sample sample;
  const double x[3] = { 0.5, 0.0, 0.5 };
  object->Evaluate(x, sample);
  check.Near(sample.Density, 0.5, 1e-7, "density in the plane");
  const double y[3] = { 0.5, 0.1, 0.5 };
  object->Evaluate(y, sample);
  check.Near(sample.Density, 0.0, 0.0, "density next to the plane");
}

}

int TestSpatialLeaves(int, char*[])
{
  return RunChecks({ CheckImplicit, CheckImage, CheckRejections, CheckFlat });
}
