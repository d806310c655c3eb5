// SPDX-License-Identifier: BSD-3-Clause
#include "Samples/FarSideStage.h"

#include "Samples/FarSideCorners.h"
#include "Samples/FarSideSamples.h"
#include "Samples/FarSideTracer.h"
#include "Samples/ImplicitFlowArrays.h"
#include "Samples/ReachedBoundary.h"
#include "Samples/SampleArrays.h"

#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSignedCharArray.h"

#include <cmath>

namespace interlume
{

namespace
{
/// Field arrays of far-side samples.
class FarSideRows
{
public:
  FarSideRows(vtkDataSet* samples, const vtkFlowSettings& settings, vtkIdType number)
    : Samples(samples)
    , Points(this->Add<vtkIdTypeArray>(FarSideSamples::Point, 1, number))
    , Positions(this->Add<vtkDoubleArray>(FarSideSamples::Position, 3, number))
    , Distances(this->Add<vtkDoubleArray>(FarSideSamples::Distance, 1, number))
    , Normals(this->Add<vtkDoubleArray>(FarSideSamples::Normal, 3, number))
    , Surfaces(this->Add<vtkIntArray>(FarSideSamples::Surface, 1, number))
    , Arrays(SampleArrays::Make(
        settings, samples->GetFieldData(), number, vtkFlowStatus::FarSidePrefix()))
  {
  }

  void Append(vtkIdType sample, double distance, const double normal[3], int surface, int side,
    const AdvectionResult& result)
  {
    const vtkIdType row = this->Next++;
    this->Points->SetValue(row, sample);
    this->Positions->SetTuple(row, this->Samples->GetPoint(sample));
    this->Distances->SetValue(row, distance);
    this->Normals->SetTuple(row, normal);
    this->Surfaces->SetValue(row, surface);
    this->Arrays.Set(row, result);
    this->Arrays.Side->SetValue(row, static_cast<signed char>(side));
  }

private:
  template <typename Array>
  Array* Add(const char* name, int components, vtkIdType number)
  {
    vtkNew<Array> array;
    array->SetName(FarSideSamples::GetName(name).c_str());
    array->SetNumberOfComponents(components);
    array->SetNumberOfTuples(number);
    this->Samples->GetFieldData()->AddArray(array);
    return array;
  }

  vtkDataSet* Samples;
  vtkIdTypeArray* Points;
  vtkDoubleArray* Positions;
  vtkDoubleArray* Distances;
  vtkDoubleArray* Normals;
  vtkIntArray* Surfaces;
  SampleArrays Arrays;
  vtkIdType Next = 0;
};
}

bool FarSideStage::Run(StageContext& context, vtkDataSet* samples, bool findsBoundary)
{
  vtkFieldData* data = samples->GetFieldData();
  FarSideSamples::Remove(data);
  ImplicitFlowArrays known;
  std::vector<FarSideCorners::Corner> corners;
  std::vector<FarSideCorners::Pair> pairs;
  if (!known.Find(samples))
  {
    corners =
      FarSideCorners::Find(samples, known, context.Options, findsBoundary ? &pairs : nullptr);
    if (context.Boundary.PrefersEdges)
    {
      FarSideCorners::RemoveRedundant(pairs);
    }
  }
  FarSideTracer tracer(context, samples);
  std::vector<FarSideTracer::SampleResult> sampleResults;
  bool isDone = tracer.Find(corners, sampleResults);
  std::vector<ReachedBoundary::SampleResult> boundary;
  if (isDone && findsBoundary)
  {
    const SampleArrays results = SampleArrays::Find(context.Options, samples->GetPointData());
    isDone = ReachedBoundary(context, samples, known).Find(pairs, results, boundary);
  }
  const auto number = static_cast<vtkIdType>(corners.size() + boundary.size());
  if (number == 0 || !isDone)
  {
    return isDone;
  }
  FarSideRows rows(samples, context.Options, number);
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    rows.Append(corners[i].Sample, std::abs(corners[i].Distance), sampleResults[i].Normal,
      sampleResults[i].IsStagnant ? FarSideSamples::Stagnant : corners[i].Surface,
      sampleResults[i].Side, sampleResults[i].FarSide);
  }
  for (const ReachedBoundary::SampleResult& sample : boundary)
  {
    constexpr double unknown[3] = { 0.0, 0.0, 0.0 };
    rows.Append(sample.Sample, sample.Distance, unknown, FarSideSamples::NoSurface,
      sample.IsReached ? vtkFlowStatus::TOWARD : -vtkFlowStatus::AWAY, sample.FarSide);
  }
  // The id is -1 if no surface is reached, so the status is redundant.
  data->RemoveArray(FarSideSamples::GetName(vtkFlowStatus::StatusArray()).c_str());
  return true;
}

}
