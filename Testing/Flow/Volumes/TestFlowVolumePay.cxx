// SPDX-License-Identifier: BSD-3-Clause
// A flow volume does what is asked of it and no more: no extraction by what cuts nothing, none
// again of what has not changed, and no surfaces, normals or copies of points that nobody wants.
#include "Support/AnalyticFlows/ReferenceFlowAnswers.h"
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

// What an update of the volume costs: preparations, passes by Inflow and time, cuts, normals.
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
    this->Expect.Near(report->GetNumber("Preparations"), costs.Preparations, 0.0, "preparations");
    this->Expect.Near(
      report->GetNumber("InflowPasses"), costs.InflowPasses, 0.0, "passes by Inflow");
    this->Expect.Near(report->GetNumber("TimePasses"), costs.TimePasses, 0.0, "passes by time");
    this->Expect.Near(
      report->GetNumber("SurfaceCuts"), costs.SurfaceCuts, 0.0, "cuts of stream surfaces");
    this->Expect.Near(
      report->GetNumber("NormalPasses"), costs.NormalPasses, 0.0, "passes for normals");
    this->Expect.Near(report->GetNumber("PointsOnSeams"), 0, 0.0, "points on seams");
    this->Expect.That(this->Volume->GetOutput()->GetNumberOfCells() > 0, "there is output");
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
  ExpectWarnings(volume);
  watch.Update("nothing set: tetrahedra only", { 1, 0, 1, 0, 0 });
  volume->GenerateStreamSurfacesOn();
  volume->GenerateTimeSurfacesOn();
  volume->GenerateNormalsOn();
  watch.Update("surfaces, but none set", { 0, 0, 0, 0, 0 });
  watch.CountCells(false, false);
  volume->SetInterval(0, 0.2, 0.7);
  watch.Update("an interval", { 0, 1, 0, 0, 1 });
  watch.CountCells(true, false);
  volume->SetTimeRange(0.0, 100.0);
  volume->SetTimeRange(-5.0, VTK_DOUBLE_MAX);
  volume->SetTimeSurface(0, -1.0);
  watch.Update("times that cut nothing", { 0, 0, 0, 0, 1 });
  volume->SetTimeSurface(0, 0.5);
  watch.Update("a time surface", { 0, 0, 1, 1, 2 });
  watch.CountCells(true, true);
  volume->SetTimeRange(0.0, 0.6);
  watch.Update("a time range", { 0, 0, 1, 1, 2 });
  volume->SetNumberOfTimeSurfaces(0);
  watch.Update("the range only", { 0, 0, 1, 1, 2 });
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
  watch.Update("nothing has changed", { 0, 0, 0, 0, 0 });

  // A volume of times alone does not need the mapping.
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
