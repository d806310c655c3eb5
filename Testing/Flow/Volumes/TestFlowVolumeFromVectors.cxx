// SPDX-License-Identifier: BSD-3-Clause
// vtkFlowVolumeFromVectors: volumes of bands in a uniform flow, the same result as the three
// filters one after another, streamlines that are traced only if necessary, messages, settings,
// progress and abort. Cuts where the flow ends.
#include "Support/AnalyticFlows/ReferenceFlowResults.h"
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceMessages.h"
#include "Support/Checks/ReferenceProgress.h"
#include "Support/Checks/ReferenceThreads.h"
#include "Support/Flow/ReferenceFlowGrid.h"

#include "vtkFlowVolume.h"
#include "vtkFlowVolumeFromVectors.h"
#include "vtkImplicitFlowField.h"
#include "vtkInflowMapping.h"
#include "vtkTerminationPlane.h"
#include "vtkTerminationSphere.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

#include <string>

namespace
{

using namespace reference;

Vector Uniform(const Vector&)
{
  return { { 2.0, 0.0, 0.0 } };
}

/// Rotation about the line x = y = 2, with a drift along it.
Vector Spiral(const Vector& x)
{
  return { { 2.0 - x[1], x[0] - 2.0, 0.3 } };
}

/// A square that covers a part of the plane x = 0.1. Its edges are not at samples.
vtkSmartPointer<vtkTerminationPlane> MakeInlet()
{
  auto inlet = vtkSmartPointer<vtkTerminationPlane>::New();
  inlet->SetOrigin(0.1, 0.63, 0.77);
  inlet->SetPoint1(0.1, 3.13, 0.77);
  inlet->SetPoint2(0.1, 0.63, 3.27);
  return inlet;
}

/// The bands of the flow through the inlet are boxes.
void TestBands(Check& check)
{
  vtkNew<vtkFlowVolumeFromVectors> filter;
  filter->SetInputData(MakeFlowImage(9, Uniform));
  filter->SetTerminationSurface(MakeInlet());
  for (const int bands : { 5, 1, 3 })
  {
    check.SetContext(std::to_string(bands) + " bands");
    filter->SetNumberOfBands(bands);
    check.That(UpdateAndGetErrors(filter).empty(), "no messages");
    vtkUnstructuredGrid* volume = filter->GetOutput();
    check.Equal(filter->GetReport()->GetCount("Executions"), 1, "streamlines are traced once");
    for (int band = 0; band < bands; ++band)
    {
      // Three bisections locate each end of the width of 2.5 to an eighth of the spacing, 0.5.
      const double exact = 3.9 * 2.5 * 0.5 * 2.5 / bands;
      check.Near(MeasureVolume(volume, "IntervalId", band), exact, 0.05, "volume of a band");
    }
    check.That(volume->GetPointData()->GetScalars() == volume->GetPointData()->GetArray("Inflow"),
      "active scalars");
  }
  check.SetContext("preview");
  filter->SetResolution(vtkFlowVolumeFromVectors::PREVIEW);
  filter->Update();
  check.That(MeasureVolume(filter->GetOutput()) < 0.9 * 3.9 * 2.5 * 0.5 * 2.5,
    "without refinement and cuts, cells at the edge of the flow are missing");
}

/// Compares the output with that of the three filters, for other settings than the defaults.
void TestChain(Check& check)
{
  check.SetContext("chain");
  vtkNew<vtkTerminationSphere> sphere;
  sphere->SetCenter(2.0, 3.0, 2.0);
  sphere->SetRadius(0.6);
  const auto image = MakeFlowImage(41, Spiral);
  vtkNew<vtkFlowVolumeFromVectors> filter;
  filter->SetInputData(image);
  filter->SetTerminationSurface(sphere);
  filter->SetNumberOfBands(3);
  filter->SetResolution(vtkFlowVolumeFromVectors::FULL);
  filter->SetDirection(vtkImplicitFlowField::FORWARD);
  filter->SetMaximumTime(9.0);
  check.That(UpdateAndGetErrors(filter).empty(), "no messages");
  vtkNew<vtkImplicitFlowField> field;
  field->SetInputData(image);
  field->AddTerminationSurface(sphere);
  field->SetDirectionToForward();
  field->SetMaximumTime(9.0);
  field->SetSampleMode(vtkImplicitFlowField::SAMPLES_OF_FIELD);
  field->SetRefinementLevels(vtkImplicitFlowField::CUT_BOUNDARY);
  vtkNew<vtkInflowMapping> mapping;
  mapping->SetInputConnection(field->GetOutputPort());
  vtkNew<vtkFlowVolume> volume;
  volume->SetInputConnection(mapping->GetOutputPort());
  volume->SetInterval(0, 0.25 / 3.0, 0.75 / 3.0);
  volume->SetInterval(1, 1.25 / 3.0, 1.75 / 3.0);
  volume->SetInterval(2, 2.25 / 3.0, 2.75 / 3.0);
  volume->Update();
  check.That(volume->GetOutput()->GetNumberOfCells() > 1000, "there are tetrahedra");
  check.Equal(
    filter->GetOutput()->GetNumberOfCells(), volume->GetOutput()->GetNumberOfCells(), "tetrahedra");
  check.Near(MeasureVolume(filter->GetOutput()), MeasureVolume(volume->GetOutput()), 0.0, "volume");
  check.Contains(filter->GetSummary(), field->GetSummary());
  check.Contains(filter->GetSummary(), volume->GetSummary());
  check.SetContext("another sphere");
  sphere->SetRadius(0.4);
  filter->Update();
  check.That(MeasureVolume(filter->GetOutput()) < 0.9 * MeasureVolume(volume->GetOutput()),
    "a changed surface is used");
  check.SetContext("the default surface");
  filter->SetTerminationSurface(nullptr);
  check.That(!filter->GetTerminationSurface(), "null");
  filter->SetInputData(MakeFlowImage(9, Uniform));
  filter->SetDirection(vtkImplicitFlowField::BACKWARD);
  filter->SetMaximumTime(0.0);
  filter->Update();
  check.That(MeasureVolume(filter->GetOutput()) > 30.0, "half of the field");
}

void TestSummaries(Check& check)
{
  check.SetContext("summary");
  vtkNew<vtkImplicitFlowField> field;
  check.That(std::string(field->GetSummary()).empty(), "no summary before the first execution");
  field->SetInputData(MakeFlowImage(5, Uniform));
  field->AddTerminationSurface(MakeFlowPlane(2.0));
  field->SetRefinementLevels(vtkImplicitFlowField::CUT_BOUNDARY);
  field->Update();
  // The plane x = 2 of samples, and two of four other planes, reach the surface.
  check.That(std::string(field->GetSummary()) ==
      "Of 125 samples, 60 % reached a surface, 40 % left the field, 0 % stagnated, 0 % ended "
      "otherwise.",
    field->GetSummary());
  vtkNew<vtkFlowVolume> volume;
  volume->SetInputConnection(field->GetOutputPort());
  volume->Update();
  check.That(std::string(volume->GetSummary()) ==
      "Of 64 cells, 32 were skipped and 0 cut at a surface or at the boundary of the flow (32 have "
      "a corner that reached no surface).",
    volume->GetSummary());
}

void TestMessages(Check& check)
{
  check.SetContext("messages");
  vtkNew<vtkFlowVolumeFromVectors> filter;
  vtkNew<vtkImageData> empty;
  empty->SetDimensions(3, 3, 3);
  filter->SetInputData(empty);
  check.Contains(UpdateAndGetErrors(filter), "vectors");
  check.Equal(filter->GetOutput()->GetNumberOfCells(), 0, "empty after an error");
  filter->SetInputData(MakeFlowImage(9, [](const Vector&) { return Vector{}; }));
  const std::string errors = UpdateAndGetErrors(filter);
  check.Contains(errors, "no flow");
  check.That(errors.find("FlowStatus") == std::string::npos, "no messages of the filters after it");
  filter->SetInputData(MakeFlowImage(9, Uniform));
  filter->SetTerminationSurface(MakeFlowPlane(-3.0));
  check.Contains(WarningsOf(filter), "reached a termination surface");
  check.SetContext("clamped");
  filter->SetNumberOfBands(0);
  filter->SetResolution(7);
  check.Equal(filter->GetNumberOfBands(), 1, "bands");
  check.Equal(filter->GetResolution(), vtkFlowVolumeFromVectors::FULL, "resolution");
  CheckPrinted(Print(filter),
    { "NumberOfBands: 1", "Resolution: 2", "Direction: 0", "MaximumTime: 0" }, check);
}

void TestAbort(Check& check)
{
  check.SetContext("progress");
  vtkNew<vtkFlowVolumeFromVectors> filter;
  filter->SetInputData(MakeFlowImage(25, Spiral));
  ProgressWatch watch;
  ObserveProgress(filter, watch);
  filter->Update();
  CheckMonotonicProgress(watch, 3, check);
  const vtkIdType cells = filter->GetOutput()->GetNumberOfCells();
  watch.AbortAt = 0.1;
  filter->SetMaximumTime(1e6);
  filter->Update();
  check.Equal(filter->GetOutput()->GetNumberOfCells(), 0, "empty after an abort");
  watch.AbortAt = 2.0;
  filter->SetAbortExecute(0);
  filter->Update();
  check.Equal(filter->GetOutput()->GetNumberOfCells(), cells, "complete afterwards");
}

void TestThreads(Check& check)
{
  CheckThreads(
    "bands",
    []
    {
      vtkNew<vtkFlowVolumeFromVectors> filter;
      filter->SetInputData(MakeFlowImage(17, Spiral));
      filter->Update();
      return std::vector<vtkSmartPointer<vtkUnstructuredGrid>>{ filter->GetOutput() };
    },
    check);
}

/// Tests that CUT_BOUNDARY refines nothing, and that the output type remains the same.
void TestOutputType(Check& check)
{
  check.SetContext("output type");
  for (const int mode :
    { vtkImplicitFlowField::SAMPLES_OF_FIELD, vtkImplicitFlowField::SAMPLES_OF_IMAGE })
  {
    vtkNew<vtkImplicitFlowField> field;
    field->SetInputData(MakeFlowImage(9, Uniform));
    field->AddTerminationSurface(MakeInlet());
    field->SetSampleMode(mode);
    field->SetRefinementLevels(vtkImplicitFlowField::CUT_BOUNDARY);
    check.That(UpdateAndGetErrors(field).empty(), "no messages");
    check.That(vtkImageData::SafeDownCast(field->GetOutputDataObject(0)) != nullptr, "an image");
    check.Equal(field->GetReport()->GetSize("AddedSamples"), 0, "levels");
  }
}

}

int TestFlowVolumeFromVectors(int, char*[])
{
  return RunChecks(
    { TestBands, TestChain, TestSummaries, TestMessages, TestAbort, TestThreads, TestOutputType });
}
