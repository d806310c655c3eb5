// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Growth/GrowthQuantity.h"

#include "vtkAnalyticFlowSource.h"
#include "vtkImplicitFlowField.h"

#include "vtkImageData.h"
#include "vtkNew.h"

namespace growth
{
namespace
{
Job MakeJob(int samples, const BenchOptions& options)
{
  vtkNew<vtkAnalyticFlowSource> source;
  const int points = options.Pick(33, 17, 9);
  source->SetField(vtkAnalyticFlowSource::HURRICANE);
  source->SetDimensions(points, points, points);
  source->Update();
  vtkSmartPointer<vtkImageData> field = source->GetOutput();
  Job job;
  job.Measured.Fresh = WithThreads(options.Threads,
    [field, samples]()
    {
      vtkNew<vtkImplicitFlowField> filter;
      filter->SetInputData(field);
      filter->DomainFacesOn();
      filter->SetMaximumTime(2.0);
      filter->SetSampleMode(vtkImplicitFlowField::SAMPLES_OF_IMAGE);
      filter->SetSampleDimensions(samples, samples, samples);
      filter->Update();
      return vtkSmartPointer<vtkObjectBase>(filter->GetOutputDataObject(0));
    });
  job.GetN = [samples]() { return static_cast<double>(samples) * samples * samples; };
  job.InputKib = static_cast<double>(field->GetActualMemorySize());
  return job;
}
}

Quantity MakeSamples(const BenchOptions& options)
{
  return { "samples", "samples", "vtkImplicitFlowField of a hurricane on one grid, all threads",
    options.Pick<std::vector<int>>({ 24, 32, 48, 64, 80 }, { 16, 24, 32, 48 }, { 5, 7, 9 }),
    { 1.0, 1.0, "each sample has a streamline of its own, of the same mean length" },
    { 1.0, 1.0, "each sample has its answer in the output" }, MakeJob };
}
}
