// SPDX-License-Identifier: BSD-3-Clause
#include "FuzzCases.h"
#include "FuzzData.h"
#include "FuzzRun.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkFlowStatus.h"
#include "vtkFlowVolume.h"
#include "vtkImplicitFlowField.h"
#include "vtkInflowMapping.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkTerminationPlane.h"
#include "vtkTerminationSphere.h"

#include <algorithm>

namespace fuzz
{

namespace
{

struct Choice
{
  vtkSmartPointer<vtkDataSet> Data;
  int Surface = 0;
  int SampleMode = 0;
  int Integrator = 0;
  int Direction = 0;
  int RefinementLevels = 0;
  bool ComputesMore = false;
  bool HasDomainFaces = false;
};

vtkSmartPointer<vtkImplicitFlowField> MakeFilter(const Choice& choice)
{
  auto filter = vtkSmartPointer<vtkImplicitFlowField>::New();
  filter->SetInputData(choice.Data);
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "v");
  double center[3];
  choice.Data->GetCenter(center);
  if (choice.Surface == 1)
  {
    vtkNew<vtkTerminationPlane> plane;
    plane->SetOrigin(center);
    plane->SetPoint1(center[0], center[1] + 1.0, center[2]);
    plane->SetPoint2(center[0], center[1], center[2] + 1.0);
    filter->AddTerminationSurface(plane);
  }
  else if (choice.Surface == 2)
  {
    vtkNew<vtkTerminationSphere> sphere;
    sphere->SetCenter(center);
    sphere->SetRadius(std::max(0.2 * choice.Data->GetLength(), 1e-9));
    filter->AddTerminationSurface(sphere);
  }
  filter->SetDomainFaces(choice.HasDomainFaces);
  filter->SetSampleMode(choice.SampleMode);
  filter->SetSampleDimensions(5, 4, 3);
  filter->SetIntegrator(choice.Integrator);
  filter->SetDirection(choice.Direction);
  filter->SetRefinementLevels(choice.RefinementLevels);
  filter->SetMaximumNumberOfSteps(200);
  filter->SetComputeArcLength(choice.ComputesMore);
  filter->SetComputeMaximumSpeed(choice.ComputesMore);
  filter->SetComputeMeanVorticity(choice.ComputesMore);
  filter->SetComputeLocalAttributes(choice.ComputesMore);
  return filter;
}

/// In some cases, sets 30 % of the vectors to one fill value.
void AddFillValues(FuzzRandom& random, FuzzData& data)
{
  vtkDataArray* vectors = data.Data->GetPointData()->GetArray("v");
  const double value = random.Pick<double>({ 1e20, -9999.0, -30000.0, 9.96921e36 });
  const bool isFloat =
    vectors && (vectors->GetDataType() == VTK_FLOAT || vectors->GetDataType() == VTK_DOUBLE);
  if (!isFloat || !random.Chance(0.15))
  {
    return;
  }
  for (vtkIdType i = 0; i < vectors->GetNumberOfTuples(); ++i)
  {
    const bool isFilled = random.Chance(0.3);
    for (int c = 0; isFilled && c < vectors->GetNumberOfComponents(); ++c)
    {
      vectors->SetComponent(i, c, value);
    }
  }
  data.Text += ", fill values of " + std::to_string(value);
}

}

void RunFlow(FuzzRandom& random, std::string& text, reference::Check& check)
{
  FuzzData data = MakeData(random);
  AddVectors(random, data);
  AddFillValues(random, data);
  Choice choice;
  choice.Data = data.Data;
  choice.Surface = random.Integer(0, 2);
  choice.SampleMode = random.Pick<int>({ vtkImplicitFlowField::SAMPLES_OF_FIELD,
    vtkImplicitFlowField::SAMPLES_OF_IMAGE, vtkImplicitFlowField::SAMPLES_AUTOMATIC });
  choice.Integrator = random.Integer(0, 3);
  choice.Direction = random.Integer(0, 1);
  choice.RefinementLevels = random.Chance(0.2) ? 1 : 0;
  choice.ComputesMore = random.Chance(0.3);
  choice.HasDomainFaces = random.Chance(0.5);
  text = data.Text + ", surface " + std::to_string(choice.Surface) + ", samples " +
    std::to_string(choice.SampleMode) + ", integrator " + std::to_string(choice.Integrator) +
    ", levels " + std::to_string(choice.RefinementLevels);
  CheckRun([&choice]() { return MakeFilter(choice); }, true, check);

  Messages messages;
  const auto filter = MakeFilter(choice);
  filter->Update();
  auto* output = vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  vtkDataArray* status =
    output ? output->GetPointData()->GetArray(vtkFlowStatus::StatusArray()) : nullptr;
  if (!status || status->GetNumberOfTuples() == 0)
  {
    return;
  }
  double range[2];
  status->GetRange(range);
  check.That(range[0] >= vtkFlowStatus::REACHED_SURFACE && range[1] <= vtkFlowStatus::CLOSED_ORBIT,
    "valid statuses; found " + std::to_string(range[0]) + " to " + std::to_string(range[1]));
  vtkNew<vtkInflowMapping> mapping;
  mapping->SetInputConnection(filter->GetOutputPort());
  vtkNew<vtkFlowVolume> volume;
  volume->SetInputConnection(mapping->GetOutputPort());
  volume->SetNumberOfIntervals(1);
  volume->SetInterval(0, 0.2, 0.7);
  volume->Update();
  check.That(volume->GetOutputDataObject(0) != nullptr, "the flow volume has an output");
}

}
