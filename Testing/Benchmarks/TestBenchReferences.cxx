// SPDX-License-Identifier: BSD-3-Clause
// Tests the references for error measurements: the exact trilinear region, splits into tetrahedra,
// the image of a field, moving regions, and time steps in memory.
#include "Benchmarks/Data/AnalyticCases.h"
#include "Benchmarks/Data/CellSplits.h"
#include "Benchmarks/Data/StoredTimeSteps.h"
#include "Benchmarks/Data/MovingFields.h"
#include "Benchmarks/Intervals/ExtractionMethods.h"
#include "Benchmarks/Intervals/TrilinearRegion.h"
#include "Benchmarks/Measures/PowerFit.h"
#include "Benchmarks/Measures/TetrahedronSums.h"
#include "Benchmarks/SpaceTime/RegionError.h"
#include "Benchmarks/Tetrahedra/FieldImage.h"
#include "Benchmarks/Tetrahedra/TetrahedraScene.h"
#include "Support/Images/ReferenceVolumeImage.h"

#include "vtkIntervalVolume.h"

#include "vtkDataSetSurfaceFilter.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>

namespace
{
bool Success = true;

void ExpectNear(double measured, double exact, double tolerance, const std::string& what)
{
  // The condition fails for NaN.
  if (!(std::abs(measured - exact) <= tolerance))
  {
    std::cerr << "ERROR: " << what << ": " << measured << ", expected " << exact << std::endl;
    Success = false;
  }
}

void TestPlane()
{
  const AnalyticCase plane = { "plane", "", [](double x, double y, double z) { return x + y + z; },
    0.0, 1.0, 0.0, 0.0, {} };
  const TrilinearRegion region(plane.Sample(4));
  // A plane that cuts the axes at distance c removes a corner of volume c^3 / 6 from the unit cube.
  ExpectNear(region.GetVolume(-1.0, 0.5), 0.125 / 6.0, 1e-5, "volume below a plane");
  ExpectNear(region.GetVolume(-1.0, 0.5, 9), 0.125 / 6.0, 1e-8,
    "volume below a plane with finer subdivision");
  ExpectNear(region.GetVolume(-1.0, 4.0), 1.0, 1e-14, "volume of the cube");
  const double point[3] = { 0.2, 0.1, 0.4 };
  ExpectNear(region.GetDistance(point, 1.0), 0.3 / std::sqrt(3.0), 1e-14, "distance to a plane");
}

void TestProduct()
{
  for (const AnalyticCase& analytic : MakeAnalyticCases())
  {
    if (analytic.Name == "product")
    {
      const TrilinearRegion region(analytic.Sample(9));
      ExpectNear(region.GetVolume(analytic.Lower, analytic.Upper), *analytic.Volume, 1e-6,
        "volume of the product field in closed form");
      return;
    }
  }
  ExpectNear(0.0, 1.0, 0.0, "there is a case named product");
}

void TestSampling()
{
  for (const AnalyticCase& analytic : MakeAnalyticCases())
  {
    if (analytic.Volume)
    {
      const TrilinearRegion region(analytic.Sample(65));
      ExpectNear(region.GetVolume(analytic.Lower, analytic.Upper) / *analytic.Volume, 1.0, 2e-3,
        analytic.Name + " at 65 points");
    }
  }
}

void TestSplit(int pieces)
{
  const std::string name = std::to_string(pieces) + " tetrahedra";
  const int cells = 3;
  auto image = MakeAnalyticCases().front().Sample(cells + 1);
  auto grid = SplitIntoTetrahedra(image, pieces);
  const TetrahedronSums sums = SumTetrahedra(grid);
  ExpectNear(sums.Tetrahedra, pieces * cells * cells * cells, 0.0, name + ", number of tetrahedra");
  ExpectNear(sums.Inverted, 0.0, 0.0, name + ", inverted tetrahedra");
  ExpectNear(sums.Volume, 8.0, 1e-13, name + ", volume");
  // If the faces of adjacent tetrahedra match, the surface is the box, with two triangles per cell
  // face.
  vtkNew<vtkDataSetSurfaceFilter> surface;
  surface->SetInputData(grid);
  surface->Update();
  ExpectNear(
    surface->GetOutput()->GetNumberOfCells(), 12 * cells * cells, 0.0, name + ", boundary faces");
}

/// Tests that images of a field on refined meshes converge to the exact image with second order.
void TestFieldImage()
{
  auto property = tetrahedra::MakeProperty();
  auto camera = tetrahedra::MakeCamera();
  reference::CameraSettings settings;
  settings.Size = { { 24, 24 } };
  const auto exact = RenderField(tetrahedra::GetField, tetrahedra::GetLow(), tetrahedra::GetHigh(),
    property, camera, settings.Size, 2000);
  double errors[2];
  for (int level = 0; level < 2; ++level)
  {
    auto grid = tetrahedra::MakeGrid(level == 0 ? 12 : 24);
    errors[level] = reference::CompareImages(
      reference::MakeReferenceImage(grid, property, camera, settings), exact)
                      .Mean;
  }
  ExpectNear(errors[1], 0.0, 4e-3, "error of the fine mesh");
  ExpectNear(errors[0] / errors[1], 4.0, 1.0, "error ratio of a mesh twice as coarse");
}

double GetOutputTime(StoredTimeSteps* steps, double requested)
{
  steps->UpdateTimeStep(requested);
  return steps->GetOutputDataObject(0)->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP());
}

void TestStoredSteps()
{
  vtkNew<vtkAnalyticFieldSource> source;
  source->SetFieldToLinear();
  source->SetDimensions(3, 4, 5);
  source->SetNumberOfTimeSteps(3);
  source->SetTimeRange(1.0, 2.0);
  vtkNew<StoredTimeSteps> steps;
  steps->AddStepsFrom(source);
  ExpectNear(steps->GetNumberOfSteps(), 3, 0.0, "number of steps in memory");
  for (int step = 0; step < 3; ++step)
  {
    ExpectNear(steps->GetStepTime(step), 1.0 + 0.5 * step, 1e-15, "time of a step");
    ExpectNear(
      GetOutputTime(steps, 1.0 + 0.5 * step), 1.0 + 0.5 * step, 1e-15, "output time of a step");
    // f = x + t, and x = -1 at the first point.
    auto* image = vtkImageData::SafeDownCast(steps->GetOutputDataObject(0));
    ExpectNear(
      image->GetScalarComponentAsDouble(0, 0, 0, 0), 0.5 * step, 1e-6, "first value of a step");
    ExpectNear(
      static_cast<double>(image->GetNumberOfPoints()), 60, 0.0, "number of points of a step");
  }
  ExpectNear(GetOutputTime(steps, 1.7), 1.5, 1e-15, "the previous step is used between steps");
  ExpectNear(GetOutputTime(steps, 0.0), 1.0, 1e-15, "the first step is used for earlier times");
}

vtkSmartPointer<vtkUnstructuredGrid> MakeRegion(const interval4d::MovingField& field, double time)
{
  field.Source->UpdateTimeStep(time);
  auto filter = methods::NewIntervalVolume(field.Source->GetOutput(), field.Lower, field.Upper);
  filter->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  filter->Update();
  return filter->GetOutput();
}

void TestMovingFields()
{
  BenchOptions options;
  for (const interval4d::MovingField& field : interval4d::MakeMovingFields(options))
  {
    for (const double time : { 0.0, 0.7, 2.0 })
    {
      const auto error = interval4d::MeasureRegionError(field, time, MakeRegion(field, time));
      ExpectNear(error.Volume, 0.0, 3e-3, field.Name + ", volume");
      ExpectNear(error.SymmetricDifference, 0.0, 2e-2, field.Name + ", symmetric difference");
    }
    // The planes that bound the region of the linear field move by 0.05 along z per unit of time.
    // Their projection along z is a 2 x 2 square.
    if (field.Name == "linear")
    {
      const auto error = interval4d::MeasureRegionError(field, 1.4, MakeRegion(field, 1.0));
      ExpectNear(error.Volume, 0.0, 1e-12, "a shifted slab, volume");
      ExpectNear(error.SymmetricDifference, 2.0 * 4.0 * 0.05 * 0.4 / 0.8, 1e-9,
        "a shifted slab, symmetric difference");
    }
  }
}

void TestPowerFit()
{
  ExpectNear(FitExponent({ 1.0, 2.0, 4.0 }, { 3.0, 3.0 * std::pow(2.0, 2.5), 3.0 * 32.0 }), 2.5,
    1e-12, "exponent of a power");
}
}

int main()
{
  TestStoredSteps();
  TestMovingFields();
  TestPowerFit();
  TestFieldImage();
  TestPlane();
  TestProduct();
  TestSampling();
  for (int pieces : { 5, 6 })
  {
    TestSplit(pieces);
  }
  return Success ? EXIT_SUCCESS : EXIT_FAILURE;
}
