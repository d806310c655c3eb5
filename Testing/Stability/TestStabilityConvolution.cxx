// SPDX-License-Identifier: BSD-3-Clause
// Tests line integral convolution at extreme scales and speeds, with a million steps per
// streamline, with zero or non-finite vectors, and outside the field.
#include "StabilityChecks.h"

#include "Support/Checks/LargestError.h"
#include "Support/Flow/ReferenceFlowGrid.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFlowLIC.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRectilinearGrid.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{

using namespace reference;
using namespace stability;

Vector Rotate(const Vector& x)
{
  return { { -x[1], x[0], 0.25 } };
}

/// Returns an image of \a field in the cube [-2, 2]^3. The cube is scaled by \a size, and the
/// vectors are scaled by \a speed.
vtkSmartPointer<vtkImageData> MakeImage(
  const VectorField& field, double size = 1.0, double speed = 1.0, int points = 17)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(points, points, points);
  image->SetOrigin(-2.0 * size, -2.0 * size, -2.0 * size);
  const double spacing = 4.0 * size / (points - 1);
  image->SetSpacing(spacing, spacing, spacing);
  AddVectors(image,
    [&](const Vector& x)
    {
      const Vector v = field({ { x[0] / size, x[1] / size, x[2] / size } });
      return Vector{ { speed * v[0], speed * v[1], speed * v[2] } };
    });
  return image;
}

/// Returns the box of MakeImage() as a rectilinear grid.
vtkSmartPointer<vtkRectilinearGrid> MakeGrid(double size)
{
  auto grid = vtkSmartPointer<vtkRectilinearGrid>::New();
  vtkNew<vtkDoubleArray> coordinates;
  for (int i = -8; i <= 8; ++i)
  {
    coordinates->InsertNextValue(0.25 * i * size);
  }
  grid->SetDimensions(17, 17, 17);
  grid->SetXCoordinates(coordinates);
  grid->SetYCoordinates(coordinates);
  grid->SetZCoordinates(coordinates);
  AddVectors(grid,
    [&](const Vector& x) {
      return Rotate({ { x[0] / size, x[1] / size, x[2] / size } });
    });
  return grid;
}

vtkDataArray* GetValues(vtkFlowLIC* filter)
{
  return filter->GetOutput()->GetPointData()->GetArray("LIC");
}

double CompareValues(vtkFlowLIC* found, vtkFlowLIC* expected)
{
  if (!UpdateFilter(found).Errors.empty() || !GetValues(found))
  {
    return NaN;
  }
  double largest = 0.0;
  for (vtkIdType i = 0; i < GetValues(expected)->GetNumberOfTuples(); ++i)
  {
    const double difference =
      std::abs(GetValues(found)->GetComponent(i, 0) - GetValues(expected)->GetComponent(i, 0));
    reference::KeepLargest(largest, difference);
  }
  return largest;
}

void TestScales(StabilityCatalogue& catalogue)
{
  // Scaling by powers of two does not change the noise.
  vtkNew<vtkFlowLIC> plain;
  plain->SetInputData(MakeImage(&Rotate));
  plain->SetNoiseScale(0.25);
  plain->Update();
  for (const double size :
    { 0x1p-800, 0x1p-400, 0x1p-300, 0x1p-40, 0x1p40, 0x1p300, 0x1p400, 0x1p800 })
  {
    for (const double speed : { 0x1p-600, 0x1p-400, 0x1p-40, 0x1p40, 0x1p400, 0x1p600 })
    {
      if (!std::isnormal(speed / size))
      {
        continue;
      }
      vtkNew<vtkFlowLIC> scaled;
      scaled->SetInputData(MakeImage(&Rotate, size, speed));
      scaled->SetNoiseScale(0.25 * size);
      const double difference = CompareValues(scaled, plain);
      catalogue.Measure("size-" + FormatShort(size) + "-speed-" + FormatShort(speed),
        "a box of " + FormatShort(size) + " with speeds of " + FormatShort(speed),
        "largest difference from the result at size 1", difference, 1e-5,
        "Runge-Kutta 4: " + FormatShort(scaled->GetReport()->GetNumber("Steps")) +
          " per direction");
    }
  }
}

/// The default noise scale is 1/128 of the diagonal of the bounding box.
void TestAutomaticNoise(StabilityCatalogue& catalogue)
{
  vtkNew<vtkFlowLIC> plain;
  plain->SetInputData(MakeGrid(1.0));
  plain->Update();
  for (const double size : { 0x1p-800, 0x1p-600, 0x1p-300, 0x1p300, 0x1p600, 0x1p800 })
  {
    vtkNew<vtkFlowLIC> automatic;
    automatic->SetInputData(MakeGrid(size));
    const double difference = CompareValues(automatic, plain);
    // The points are a quarter of the size apart.
    catalogue.Measure("noise-" + FormatShort(size),
      "a box of " + FormatShort(size) + ", default noise scale",
      "relative error of the noise scale",
      automatic->GetReport()->GetNumber("NoiseScale") / (0.5 * size) - 1.0, 1e-14);
    catalogue.Measure("noise-" + FormatShort(size) + "-value",
      "a box of " + FormatShort(size) + ", default noise scale",
      "largest difference from the result at size 1", difference, 1e-5);
  }
}

/// Returns a point on the x-axis.
vtkSmartPointer<vtkPolyData> MakePoint(double x)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->InsertNextPoint(x, 0.0, 0.0);
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  return data;
}

void TestLongLines(StabilityCatalogue& catalogue)
{
  vtkNew<vtkFlowLIC> filter;
  filter->SetInputData(MakePoint(1.0));
  filter->SetFieldData(MakeImage([](const Vector& x) { return Vector{ { -x[1], x[0], 0.0 } }; }));
  filter->SetNoiseScale(0.25);
  filter->SetStepLength(0.0078125);
  filter->SetLength(7812.5);
  const Messages messages = UpdateFilter(filter);
  vtkInterlumeReport* report = filter->GetReport();
  catalogue.Measure("steps-1000000", "a circle traced for a million steps per direction",
    "short streamlines, and missing steps",
    messages.Errors.empty()
      ? report->GetNumber("PointsWithShortLines") + 1e6 - report->GetNumber("Steps")
      : NaN,
    0.0, "Runge-Kutta 4: " + std::to_string(report->GetCount("Steps")) + " per direction");
  catalogue.Measure("steps-1000000-value", "a circle traced for a million steps per direction",
    "values outside [0, 1]", CountOutside(GetValues(filter), 0.0, 1.0), 0.0);
  filter->SetLength(7813.0);
  ReportRejection(catalogue, filter, "steps-more", "more than a million steps", "steps",
    [&]() { filter->SetLength(1.0); });
  filter->SetLength(1e-300);
  filter->SetStepLength(0.0);
  const std::string errors = UpdateFilter(filter).Errors;
  catalogue.Measure("length-1e-300", "streamlines of length 1e-300", "values outside [0, 1]",
    errors.empty() ? CountOutside(GetValues(filter), 0.0, 1.0) : NaN, 0.0);
  filter->SetLength(0.0);
  filter->SetContrast(0.0);
  filter->Update();
  catalogue.Measure("contrast-0", "no contrast", "values other than 0.5",
    CountOutside(GetValues(filter), 0.5, 0.5), 0.0);
}

void TestStill(StabilityCatalogue& catalogue)
{
  vtkNew<vtkFlowLIC> noise;
  noise->SetInputData(MakeImage([](const Vector&) { return Vector{ { 0.0, 0.0, 0.0 } }; }));
  noise->SetNoiseScale(0.25);
  const std::string errors = UpdateFilter(noise).Errors;
  const auto number = static_cast<double>(noise->GetOutput()->GetNumberOfPoints());
  catalogue.Measure("zero-field", "vectors 0 everywhere",
    "points not at rest, and values outside [0, 1]",
    errors.empty() ? number - noise->GetReport()->GetNumber("PointsAtRest") +
        CountOutside(GetValues(noise), 0.0, 1.0)
                   : NaN,
    0.0);
  vtkNew<vtkFlowLIC> broken;
  broken->SetInputData(MakeImage([](const Vector&) { return Vector{ { NaN, 0.0, 0.0 } }; }));
  broken->SetNoiseScale(0.25);
  catalogue.Measure("nan-field", "vectors NaN everywhere", "largest difference from vectors of 0",
    CompareValues(broken, noise), 0.0);
  auto image = MakeImage(&Rotate);
  for (const vtkIdType point : { 0, 2456, 4912 })
  {
    image->GetPointData()->GetVectors()->SetComponent(
      point, 1, std::numeric_limits<double>::infinity());
  }
  vtkNew<vtkFlowLIC> some;
  some->SetInputData(image);
  some->SetNoiseScale(0.25);
  const std::string words = UpdateFilter(some).Errors;
  catalogue.Measure("infinite-points", "three infinite vectors", "values outside [0, 1]",
    words.empty() ? CountOutside(GetValues(some), 0.0, 1.0) : NaN, 0.0);
  // All points of a cell with an infinite vector at one of its corners are at rest as well.
  catalogue.Measure("infinite-points-rest", "three infinite vectors",
    "points at rest except the three, among their 26 + 7 + 7 neighbors",
    some->GetReport()->GetNumber("PointsAtRest") - 3.0, 40.0);
}

void TestPositions(StabilityCatalogue& catalogue)
{
  vtkNew<vtkFlowLIC> filter;
  filter->SetFieldData(MakeImage(&Rotate));
  filter->SetNoiseScale(0.25);
  for (const double position : { 2.1, 1e300, NaN })
  {
    filter->SetInputData(MakePoint(position));
    const Messages messages = UpdateFilter(filter);
    catalogue.Measure("outside-" + FormatShort(position),
      "a point outside the field, at " + FormatShort(position),
      "values other than 0, with a warning",
      messages.Errors.empty() && messages.Warnings.find("outside the field") != std::string::npos
        ? CountOutside(GetValues(filter), 0.0, 0.0)
        : NaN,
      0.0);
  }
  filter->SetInputData(MakePoint(0.5));
  vtkNew<vtkImageData> bare;
  bare->SetDimensions(3, 3, 3);
  filter->SetFieldData(bare);
  const auto mend = [&]() { filter->SetFieldData(MakeImage(&Rotate)); };
  ReportRejection(catalogue, filter, "no-vectors", "a field without vectors", "vectors", mend);
  auto flat = vtkSmartPointer<vtkImageData>::New();
  flat->SetDimensions(5, 5, 1);
  AddVectors(flat, &Rotate);
  filter->SetFieldData(flat);
  ReportRejection(catalogue, filter, "two-dimensions", "a two-dimensional field", "three", mend);
}

}

int TestStabilityConvolution(int argc, char* argv[])
{
  return RunCases(__func__, "vtkFlowLIC", argc, argv,
    { TestScales, TestAutomaticNoise, TestLongLines, TestStill, TestPositions });
}
