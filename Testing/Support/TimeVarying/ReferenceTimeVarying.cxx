// SPDX-License-Identifier: BSD-3-Clause
#include "Support/TimeVarying/ReferenceTimeVarying.h"

#include "vtkUnstructuredGrid.h"

namespace reference
{

void Apply(const TimeVaryingSettings& settings, vtkTimeVaryingIntervalVolume* filter)
{
  filter->SetNumberOfIntervals(static_cast<int>(settings.Intervals.size()));
  for (size_t i = 0; i < settings.Intervals.size(); ++i)
  {
    filter->SetInterval(static_cast<int>(i), settings.Intervals[i][0], settings.Intervals[i][1]);
  }
  const auto& d = settings.Direction;
  filter->SetProjectionDirection(d[0], d[1], d[2], d[3]);
  filter->SetTimeStepRange(settings.Steps[0], settings.Steps[1]);
  filter->SetGenerateTetrahedra(settings.Tetrahedra);
  filter->SetGenerateBoundaries(settings.Boundaries);
  filter->SetGenerateSimplices(settings.Simplices);
  filter->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  filter->RemoveAllCriteria();
  for (const Range& range : settings.Criteria)
  {
    filter->AddCriterion(range.Array, range.Lower, range.Upper);
  }
  filter->SetCriteriaOperation(settings.CriteriaOperation);
}

TimeVaryingPipeline::TimeVaryingPipeline(
  const TimeSteps& steps, const TimeVaryingSettings& settings)
{
  this->Source->SetSteps(steps);
  this->Filter->SetInputConnection(this->Source->GetOutputPort());
  Apply(settings, this->Filter);
}

TimeVaryingExtraction ExtractTimeVarying(
  const TimeSteps& steps, const TimeVaryingSettings& settings)
{
  const TimeVaryingPipeline pipeline(steps, settings);
  pipeline.Filter->Update();
  auto output = [&](int port)
  { return vtkUnstructuredGrid::SafeDownCast(pipeline.Filter->GetOutputDataObject(port)); };
  return { output(0), output(1), output(2), pipeline.Filter->GetReport() };
}

}
