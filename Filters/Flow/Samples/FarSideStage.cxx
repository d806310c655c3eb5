// SPDX-License-Identifier: BSD-3-Clause
#include "Samples/FarSideStage.h"

#include "Samples/BeyondCorners.h"
#include "Samples/BeyondSamples.h"
#include "Samples/BeyondTrace.h"
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
/// The field arrays of far-side samples.
class FarSideRows
{
public:
  FarSideRows(vtkDataSet* samples, const vtkFlowSettings& settings, vtkIdType number)
    : Samples(samples)
    , Points(this->Add<vtkIdTypeArray>(BeyondSamples::Point, 1, number))
    , Positions(this->Add<vtkDoubleArray>(BeyondSamples::Position, 3, number))
    , Distances(this->Add<vtkDoubleArray>(BeyondSamples::Distance, 1, number))
    , Normals(this->Add<vtkDoubleArray>(BeyondSamples::Normal, 3, number))
    , Surfaces(this->Add<vtkIntArray>(BeyondSamples::Surface, 1, number))
    , Arrays(SampleArrays::Make(
        settings, samples->GetFieldData(), number, vtkFlowStatus::BeyondPrefix()))
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
    array->SetName(BeyondSamples::GetName(name).c_str());
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
  BeyondSamples::Remove(data);
  ImplicitFlowArrays known;
  std::vector<BeyondCorners::Corner> corners;
  std::vector<BeyondCorners::Pair> pairs;
  if (!known.Find(samples))
  {
    corners =
      BeyondCorners::Find(samples, known, context.Options, findsBoundary ? &pairs : nullptr);
  }
  BeyondTrace trace(context, samples);
  std::vector<BeyondTrace::Answer> answers;
  bool isDone = trace.Find(corners, answers);
  std::vector<ReachedBoundary::Answer> boundary;
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
    rows.Append(corners[i].Sample, std::abs(corners[i].Distance), answers[i].Normal,
      answers[i].IsStill ? BeyondSamples::StandsStill : corners[i].Surface, answers[i].Side,
      answers[i].Beyond);
  }
  for (const ReachedBoundary::Answer& answer : boundary)
  {
    constexpr double unknown[3] = { 0.0, 0.0, 0.0 };
    rows.Append(answer.Sample, answer.Distance, unknown, BeyondSamples::NoSurface,
      answer.IsReached ? vtkFlowStatus::TOWARDS : -vtkFlowStatus::AWAY, answer.Beyond);
  }
  // The id tells whether something is reached.
  data->RemoveArray(BeyondSamples::GetName(vtkFlowStatus::StatusArray()).c_str());
  return true;
}

}
