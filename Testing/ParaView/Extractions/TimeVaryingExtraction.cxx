// SPDX-License-Identifier: BSD-3-Clause
#include "ParaView/Extractions/TimeVaryingExtraction.h"

#include "ParaView/Extractions/PropertySetters.h"
#include "vtkAnalyticFieldSource.h"
#include "vtkTaperedCylinderSource.h"
#include "vtkTimeVaryingIntervalVolume.h"

#include <array>

using nlohmann::json;

namespace
{
template <typename Source>
Setters<Source> TemporalSetters()
{
  return { { "NumberOfTimeSteps",
             [](Source* source, const json& value) { source->SetNumberOfTimeSteps(value); } },
    { "TimeRange",
      [](Source* source, const json& value) { source->SetTimeRange(value[0], value[1]); } } };
}

vtkSmartPointer<vtkAlgorithm> MakeAnalyticField(const json& properties)
{
  using Source = vtkAnalyticFieldSource;
  Setters<Source> setters = TemporalSetters<Source>();
  setters["Field"] = [](Source* source, const json& value) { source->SetField(value); };
  setters["WholeExtent"] = [](Source* source, const json& value)
  { source->SetWholeExtent(value.get<std::array<int, 6>>().data()); };
  setters["Bounds"] = [](Source* source, const json& value)
  { source->SetBounds(value.get<std::array<double, 6>>().data()); };
  const auto field = vtkSmartPointer<Source>::New();
  SetProperties<Source>(field, properties, setters);
  return field;
}

vtkSmartPointer<vtkAlgorithm> MakeCylinder(const json& properties)
{
  using Source = vtkTaperedCylinderSource;
  Setters<Source> setters = TemporalSetters<Source>();
  setters["Dimensions"] = [](Source* source, const json& value)
  { source->SetDimensions(value[0], value[1], value[2]); };
  const auto cylinder = vtkSmartPointer<Source>::New();
  SetProperties<Source>(cylinder, properties, setters);
  return cylinder;
}

Setters<vtkTimeVaryingIntervalVolume> VolumeSetters()
{
  using Volume = vtkTimeVaryingIntervalVolume;
  return {
    { "Intervals", SetIntervals<Volume> },
    { "TimeStepRange",
      [](Volume* volume, const json& range) { volume->SetTimeStepRange(range[0], range[1]); } },
    { "ProjectionDirection",
      [](Volume* volume, const json& direction)
      { volume->SetProjectionDirection(direction.get<std::array<double, 4>>().data()); } },
    { "OutputPointsPrecision",
      [](Volume* volume, const json& value) { volume->SetOutputPointsPrecision(value); } },
    { "GenerateSimplices",
      [](Volume* volume, const json& value) { volume->SetGenerateSimplices(value == 1); } },
    { "Boundaries",
      [](Volume* volume, const json& kinds)
      {
        for (const json& kind : kinds)
        {
          volume->GenerateBoundaryOn(kind);
        }
      } },
  };
}
}

vtkSmartPointer<vtkAlgorithm> MakeTemporalSource(const json& extraction)
{
  return extraction["source"] == "AnalyticField"
    ? MakeAnalyticField(extraction["source_properties"])
    : MakeCylinder(extraction["source_properties"]);
}

vtkSmartPointer<vtkTimeVaryingIntervalVolume> MakeTimeVaryingVolume(const json& extraction)
{
  const auto source = MakeTemporalSource(extraction);
  auto volume = vtkSmartPointer<vtkTimeVaryingIntervalVolume>::New();
  volume->SetInputConnection(source->GetOutputPort());
  SetProperties<vtkTimeVaryingIntervalVolume>(volume, extraction["properties"], VolumeSetters());
  return volume;
}
