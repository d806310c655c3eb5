// SPDX-License-Identifier: BSD-3-Clause
#include "ParaView/Extractions/TimeVaryingNumbers.h"

#include "ParaView/Extractions/ExtractionMeasures.h"
#include "ParaView/Extractions/TimeVaryingExtraction.h"
#include "vtkAnalyticFieldSource.h"
#include "vtkNew.h"
#include "vtkSimplexTimeSlice.h"
#include "vtkTimeVaryingIntervalVolume.h"
#include "vtkUnstructuredGrid.h"

#include <array>
#include <stdexcept>
#include <string>

using nlohmann::json;

namespace
{
json MeasureNotEmpty(vtkUnstructuredGrid* grid, const char* idArray)
{
  if (grid->GetNumberOfCells() == 0)
  {
    throw std::runtime_error(std::string("no cells to measure by ") + idArray);
  }
  return MeasureExtraction(grid, idArray);
}

json Measure(json extraction)
{
  const auto volume = MakeTimeVaryingVolume(extraction);
  volume->Update();
  extraction["tetrahedra"] = MeasureNotEmpty(volume->GetOutput(0), "SimplexClass");
  extraction["boundaries"] = MeasureNotEmpty(volume->GetOutput(1), "BoundaryKind");
  extraction["simplices"] = MeasureNotEmpty(volume->GetOutput(2), "TimeSlab");
  extraction["slices"] = json::array();
  for (const json& time : extraction["slice_times"])
  {
    vtkNew<vtkSimplexTimeSlice> slice;
    slice->SetInputConnection(volume->GetOutputPort(2));
    slice->SetTime(time);
    slice->Update();
    extraction["slices"].push_back(MeasureNotEmpty(slice->GetOutput(), "IntervalId"));
  }
  return extraction;
}

json FieldProperties(int field, const std::array<int, 6>& extent,
  const std::array<double, 6>& bounds, int numberOfTimeSteps)
{
  return { { "Field", field }, { "WholeExtent", extent }, { "Bounds", bounds },
    { "NumberOfTimeSteps", numberOfTimeSteps }, { "TimeRange", { 0.0, 2.0 } } };
}

const json ALL_KINDS = { 0, 1, 2, 3, 4, 5, 6, 7 };

// Two touching intervals, and a time step between two slabs.
const json VORTEX = { { "source", "AnalyticField" },
  { "source_properties",
    FieldProperties(vtkAnalyticFieldSource::VORTEX, { 0, 19, 0, 23, 0, 15 },
      { -0.5, 0.5, -0.6, 0.6, -0.4, 0.4 }, 3) },
  { "properties",
    { { "Intervals", { 0.4, 0.5, 0.5, 0.8 } }, { "Boundaries", ALL_KINDS },
      { "GenerateSimplices", 1 } } },
  { "slice_times", { 0.3, 1.0 } } };

// Some of the steps, and a direction that is not the time.
const json WAVE = { { "source", "AnalyticField" },
  { "source_properties",
    FieldProperties(vtkAnalyticFieldSource::WAVE, { 0, 19, 0, 9, 0, 9 },
      { -2.0, 2.0, -1.0, 1.0, -1.0, 1.0 }, 5) },
  { "properties",
    { { "Intervals", { -0.15, 0.15 } }, { "TimeStepRange", { 1, 3 } },
      { "ProjectionDirection", { 0.5, 0.0, 0.25, 1.0 } }, { "OutputPointsPrecision", 1 },
      { "Boundaries", { 1, 2, 4 } }, { "GenerateSimplices", 1 } } },
  { "slice_times", { 0.75 } } };

const json CYLINDER = { { "source", "TaperedCylinderWake" },
  { "source_properties",
    { { "Dimensions", { 16, 24, 8 } }, { "NumberOfTimeSteps", 2 },
      { "TimeRange", { 0.0, 0.5 } } } },
  { "properties",
    { { "Intervals", { 0.9934, 0.9944 } }, { "Boundaries", ALL_KINDS },
      { "GenerateSimplices", 1 } } },
  { "slice_times", { 0.25 } } };
}

json MeasureTimeVaryingVolumes()
{
  return { Measure(VORTEX), Measure(WAVE), Measure(CYLINDER) };
}
