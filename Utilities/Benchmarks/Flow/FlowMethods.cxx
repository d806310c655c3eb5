// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Flow/FlowMethods.h"

#include "Benchmarks/Measures/BenchTiming.h"

#include "vtkFlowStatus.h"
#include "vtkTerminationBox.h"

#include "vtkBoundingBox.h"
#include "vtkCallbackCommand.h"
#include "vtkCell.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>

namespace flow
{
namespace
{
double GetLargestSpeed(const Case& what)
{
  return what.Field->GetPointData()->GetVectors()->GetMaxNorm();
}

/// Returns true if a streamline has left the box, where vtkImplicitFlowField also ends it. This
/// avoids unnecessary steps.
bool HasLeftBox(void* bounds, vtkPoints* points, vtkDataArray*, int)
{
  const vtkIdType number = points->GetNumberOfPoints();
  return number > 0 &&
    !vtkBoundingBox(static_cast<const double*>(bounds)).ContainsPoint(points->GetPoint(number - 1));
}
}

vtkSmartPointer<vtkImplicitFlowField> NewFlowField(
  const Case& what, int integrator, double tolerance)
{
  vtkNew<vtkTerminationBox> box;
  double bounds[6];
  std::copy(what.Box.begin(), what.Box.end(), bounds);
  box->SetBounds(bounds);
  box->SetId(0);
  auto filter = vtkSmartPointer<vtkImplicitFlowField>::New();
  // In stiff fields, explicit methods may reach no surface. The warning is ignored, since the row
  // shows the number of results.
  vtkNew<vtkCallbackCommand> ignore;
  filter->AddObserver(vtkCommand::WarningEvent, ignore);
  filter->SetInputData(what.Field);
  filter->SetSampleMode(vtkImplicitFlowField::SAMPLES_OF_INPUT);
  filter->SetSampleData(what.Seeds);
  filter->AddTerminationSurface(box);
  filter->SetMaximumTime(MaximumTime);
  filter->SetMaximumNumberOfSteps(MaximumSteps);
  filter->SetIntegrator(integrator);
  filter->SetMaximumError(tolerance * GetLargestSpeed(what));
  return filter;
}

MethodResult GetFlowFieldResult(const Case& what, vtkImplicitFlowField* filter)
{
  vtkDataSet* output = vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  vtkPointData* data = output->GetPointData();
  vtkDataArray* statuses = data->GetArray(vtkFlowStatus::StatusArray());
  vtkDataArray* ids = data->GetArray(vtkFlowStatus::IdArray());
  vtkDataArray* parameters = data->GetArray(vtkFlowStatus::ParametersArray());
  vtkDataArray* times = data->GetArray(vtkFlowStatus::TimeArray());
  vtkTerminationSurface* box = filter->GetTerminationSurface(0);
  MethodResult result;
  result.Ends.resize(static_cast<std::size_t>(what.Seeds->GetNumberOfPoints()));
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    End& end = result.Ends[static_cast<std::size_t>(i)];
    end.HasResult = statuses->GetTuple1(i) == vtkFlowStatus::REACHED_SURFACE;
    end.Time = times->GetTuple1(i);
    result.Time += end.Time;
    if (end.HasResult)
    {
      double uv[2];
      parameters->GetTuple(i, uv);
      box->EvaluatePoint(static_cast<int>(ids->GetTuple1(i)), uv, end.Position.data());
    }
  }
  vtkInterlumeReport* report = filter->GetReport();
  result.Steps = report->GetCount("Steps") + report->GetCount("StiffSteps");
  return result;
}

BenchSeconds TimeWithOneThread(vtkAlgorithm* filter)
{
  return TimeOnce(WithThreads(1,
    [filter]()
    {
      filter->Update();
      return vtkSmartPointer<vtkObjectBase>(filter);
    }));
}

std::string TracerSettings::GetName() const
{
  return this->Integrator == vtkStreamTracer::RUNGE_KUTTA45
    ? "RK45"
    : (this->Integrator == vtkStreamTracer::RUNGE_KUTTA4 ? "RK4" : "RK2");
}

vtkSmartPointer<vtkStreamTracer> NewTracer(const Case& what, const TracerSettings& settings)
{
  auto tracer = vtkSmartPointer<vtkStreamTracer>::New();
  tracer->SetInputData(what.Field);
  tracer->SetSourceData(what.Seeds);
  tracer->SetInterpolatorPrototype(NewInterpolator(settings.Search));
  tracer->SetIntegrationDirectionToBackward();
  tracer->SetIntegratorType(settings.Integrator);
  tracer->SetIntegrationStepUnit(vtkStreamTracer::CELL_LENGTH_UNIT);
  if (settings.Integrator == vtkStreamTracer::RUNGE_KUTTA45)
  {
    tracer->SetInitialIntegrationStep(0.5);
    tracer->SetMinimumIntegrationStep(1e-4);
    tracer->SetMaximumIntegrationStep(2.0);
    tracer->SetMaximumError(settings.Parameter);
  }
  else
  {
    tracer->SetInitialIntegrationStep(settings.Parameter);
  }
  tracer->SetMaximumNumberOfSteps(1000000);
  tracer->SetMaximumPropagation(MaximumLength);
  tracer->SetTerminalSpeed(1e-9 * GetLargestSpeed(what));
  tracer->SetComputeVorticity(false);
  tracer->AddCustomTerminationCallback(&HasLeftBox, const_cast<double*>(what.Box.data()),
    vtkStreamTracer::FIXED_REASONS_FOR_TERMINATION_COUNT);
  return tracer;
}

BenchWork MakeTracerWork(const Case& what, const TracerSettings& settings)
{
  return [&what, settings]()
  {
    const auto tracer = NewTracer(what, settings);
    tracer->Update();
    return vtkSmartPointer<vtkObjectBase>(tracer);
  };
}

MethodResult GetTracerResult(const Case& what, vtkStreamTracer* tracer)
{
  vtkPolyData* output = tracer->GetOutput();
  MethodResult result;
  result.Ends.resize(static_cast<std::size_t>(what.Seeds->GetNumberOfPoints()));
  vtkDataArray* seeds = output->GetCellData()->GetArray("SeedIds");
  vtkDataArray* times = output->GetPointData()->GetArray("IntegrationTime");
  for (vtkIdType line = 0; line < output->GetNumberOfLines(); ++line)
  {
    vtkIdType number = 0;
    const vtkIdType* points = nullptr;
    output->GetLines()->GetCellAtId(line, number, points);
    if (number < 2)
    {
      continue;
    }
    End& end = result.Ends[static_cast<std::size_t>(seeds->GetTuple1(line))];
    vtkIdType last = number - 1;
    result.Time += std::abs(times->GetTuple1(points[last]));
    result.Steps += last;
    const vtkBoundingBox box(what.Box.data());
    while (last > 0 && !box.ContainsPoint(output->GetPoint(points[last])))
    {
      --last;
    }
    end.HasResult = last > 0;
    end.Time = std::abs(times->GetTuple1(points[last]));
    output->GetPoint(points[last], end.Position.data());
  }
  return result;
}
}
