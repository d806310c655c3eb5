// SPDX-License-Identifier: BSD-3-Clause
// A flow volume does only the work that is requested: no passes for bounds outside the data, no
// repeated passes for unchanged settings, and no surfaces, normals or copies of points that are not
// requested.
#include "Support/AnalyticFlows/ReferenceFlowResults.h"
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceMessages.h"

#include "vtkDataArray.h"
#include "vtkFlowVolume.h"
#include "vtkImageData.h"
#include "vtkInflowMapping.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

namespace
{

using namespace reference;

// Expected cost of an update: how often each stage runs.
struct Costs
{
  int Preparations;
  int InflowPasses;
  int TimePasses;
  int SurfaceCuts;
  int NormalPasses;
};

class Watch
{
public:
  explicit Watch(Check& check)
    : Expect(check)
  {
    auto image = MakeFlowImage({ { 8, 8, 8 } }, { { -0.1, 0.9, 0, 1, 0, 1 } });
    AddFlow(image, UniformFlow(1.0), { { { 0, 0, 0 } } });
    this->Mapping->SetInputData(image);
    this->Volume->SetInputConnection(this->Mapping->GetOutputPort());
  }

  void Update(const std::string& name, const Costs& costs)
  {
    this->Expect.SetContext(name);
    this->Volume->Update();
    vtkInterlumeReport* report = this->Volume->GetReport();
    this->Expect.Equal(report->GetCount("Preparations"), costs.Preparations, "preparations");
    this->Expect.Equal(report->GetCount("InflowPasses"), costs.InflowPasses, "passes by Inflow");
    this->Expect.Equal(report->GetCount("TimePasses"), costs.TimePasses, "passes by time");
    this->Expect.Equal(
      report->GetCount("SurfaceCuts"), costs.SurfaceCuts, "cuts of stream surfaces");
    this->Expect.Equal(report->GetCount("NormalPasses"), costs.NormalPasses, "passes for normals");
    this->Expect.Equal(report->GetCount("PointsOnSeams"), 0, "points on seams");
    this->Expect.That(this->Volume->GetOutput()->GetNumberOfCells() > 0, "the output is not empty");
  }

  void CountCells(bool hasStream, bool hasTime)
  {
    this->Expect.Equal(this->Volume->GetOutput(1)->GetNumberOfCells() > 0, hasStream, "port 1");
    this->Expect.Equal(this->Volume->GetOutput(2)->GetNumberOfCells() > 0, hasTime, "port 2");
  }

  vtkNew<vtkInflowMapping> Mapping;
  vtkNew<vtkFlowVolume> Volume;

private:
  Check& Expect;
};

}

int TestFlowVolumePay(int, char*[])
{
  Check check;
  Watch watch(check);
  vtkFlowVolume* volume = watch.Volume;
  AllowWarnings(volume);
  watch.Update("no settings: only tetrahedra", { 1, 0, 1, 0, 0 });
  volume->GenerateStreamSurfacesOn();
  volume->GenerateTimeSurfacesOn();
  volume->GenerateNormalsOn();
  watch.Update("surfaces on, but no values", { 0, 0, 0, 0, 0 });
  watch.CountCells(false, false);
  volume->SetInterval(0, 0.2, 0.7);
  watch.Update("an interval", { 0, 1, 0, 0, 1 });
  watch.CountCells(true, false);
  volume->SetTimeRange(0.0, 100.0);
  volume->SetTimeRange(-5.0, VTK_DOUBLE_MAX);
  volume->SetTimeSurface(0, -1.0);
  watch.Update("time bounds outside the data", { 0, 0, 0, 0, 1 });
  volume->SetTimeSurface(0, 0.5);
  watch.Update("a time surface", { 0, 0, 1, 1, 2 });
  watch.CountCells(true, true);
  volume->SetTimeRange(0.0, 0.6);
  watch.Update("a time range", { 0, 0, 1, 1, 2 });
  volume->SetNumberOfTimeSurfaces(0);
  watch.Update("only the time range", { 0, 0, 1, 1, 2 });
  volume->SetTimeRange(0.0, 0.7);
  watch.Update("growing", { 0, 0, 1, 1, 2 });
  volume->GenerateNormalsOff();
  watch.Update("no normals", { 0, 0, 0, 1, 0 });
  volume->GenerateStreamSurfacesOff();
  watch.Update("no stream surfaces", { 0, 1, 1, 0, 0 });
  watch.CountCells(false, true);
  volume->GenerateTimeSurfacesOff();
  watch.Update("no surfaces", { 0, 0, 1, 0, 0 });
  watch.CountCells(false, false);
  volume->SetStreamSurface(0, 5.0);
  watch.Update("a stream surface outside", { 0, 0, 0, 0, 0 });
  volume->SetStreamSurface(0, 0.5);
  watch.Update("a stream surface inside", { 0, 1, 1, 0, 0 });
  watch.Mapping->SetFormula(vtkInflowMapping::ALL, "v");
  watch.Update("another mapping", { 1, 1, 1, 0, 0 });
  volume->SetNumberOfIntervals(0);
  volume->SetNumberOfStreamSurfaces(0);
  watch.Update("no intervals", { 0, 0, 1, 0, 0 });
  volume->Modified();
  watch.Update("no change", { 0, 0, 0, 0, 0 });

  // A volume with only time bounds does not require the mapping.
  check.SetContext("without a mapping");
  vtkNew<vtkFlowVolume> times;
  times->SetInputConnection(watch.Mapping->GetInputConnection(0, 0));
  times->SetInputData(watch.Mapping->GetInput());
  times->SetTimeRange(0.2, 0.5);
  times->Update();
  check.Near(MeasureVolume(times->GetOutput()), 0.3, 1e-6, "volume");
  check.That(times->GetOutput()->GetPointData()->GetArray("Inflow") == nullptr, "no Inflow");
  return check.Result();
}
