// SPDX-License-Identifier: BSD-3-Clause
// Input and output of flow volumes: errors, arrays and their types, settings, progress and abort,
// and bit-identical output for any number of threads.
#include "Support/AnalyticFlows/ReferenceFlowResults.h"
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceMessages.h"
#include "Support/Checks/ReferenceProgress.h"
#include "Support/Checks/ReferenceThreads.h"
#include "Support/Meshes/ReferenceGrid.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkFlowVolume.h"
#include "vtkImageData.h"
#include "vtkInflowMapping.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>
#include <functional>

namespace
{

using namespace reference;

vtkSmartPointer<vtkImageData> MakeInput(int points = 10)
{
  auto image = MakeFlowImage({ { points, points, points } }, { { -1, 1, -1, 1, 0, 1 } });
  AddFlow(image, CylinderFlow(0.2), { { { 0, 1, 0 } } });
  vtkNew<vtkInflowMapping> mapping;
  mapping->SetFormula(vtkInflowMapping::ALL, "v+0.2*cos(6.283185307179586*u)");
  mapping->SetInputData(image);
  mapping->Update();
  auto input = vtkSmartPointer<vtkImageData>::New();
  input->ShallowCopy(mapping->GetOutput());
  return input;
}

void SetAll(vtkFlowVolume* volume)
{
  volume->SetInterval(0, 0.3, 0.6);
  volume->SetInterval(1, 0.6, 0.8);
  volume->SetStreamSurface(0, 0.45);
  volume->SetTimeRange(0.1, 0.6);
  volume->SetTimeSurface(0, 0.35);
  volume->GenerateStreamSurfacesOn();
  volume->GenerateTimeSurfacesOn();
  volume->GenerateNormalsOn();
}

void CheckErrors(Check& check)
{
  struct
  {
    const char* Part;
    std::function<void(vtkFlowVolume*, vtkImageData*)> Spoil;
  } const cases[] = {
    { "\"FlowStatus\"",
      [](vtkFlowVolume*, vtkImageData* d) { d->GetPointData()->RemoveArray("FlowStatus"); } },
    { "\"TerminationId\"",
      [](vtkFlowVolume*, vtkImageData* d) { d->GetPointData()->RemoveArray("TerminationId"); } },
    { "\"TerminationUV\"",
      [](vtkFlowVolume*, vtkImageData* d) { d->GetPointData()->RemoveArray("TerminationUV"); } },
    { "The input has no point array \"AdvectionTime\". Pass the output of vtkImplicitFlowField.",
      [](vtkFlowVolume*, vtkImageData* d) { d->GetPointData()->RemoveArray("AdvectionTime"); } },
    { "Array \"Inflow\" has 3 components; 1 is needed. Intervals and stream surfaces need the "
      "Inflow of vtkInflowMapping",
      [](vtkFlowVolume*, vtkImageData* d)
      {
        vtkNew<vtkDoubleArray> wide;
        wide->SetName("Inflow");
        wide->SetNumberOfComponents(3);
        wide->SetNumberOfTuples(d->GetNumberOfPoints());
        d->GetPointData()->AddArray(wide);
      } },
    { "The input has no point array \"Inflow\"",
      [](vtkFlowVolume*, vtkImageData* d) { d->GetPointData()->RemoveArray("Inflow"); } },
    { "\"TerminationSurfaces\"",
      [](vtkFlowVolume*, vtkImageData* d)
      { d->GetFieldData()->RemoveArray("TerminationSurfaces"); } },
    { "Interval 1 has lower value 2 above its upper value 1.",
      [](vtkFlowVolume* v, vtkImageData*) { v->SetInterval(1, 2, 1); } },
    { "Interval 0 [nan",
      [](vtkFlowVolume* v, vtkImageData*) { v->SetInterval(0, std::nan(""), 1); } },
    { "time range has lower value 3",
      [](vtkFlowVolume* v, vtkImageData*) { v->SetTimeRange(3, 2); } },
    { "time range", [](vtkFlowVolume* v, vtkImageData*) { v->SetTimeRange(0, std::nan("")); } },
    { "Stream surface 0",
      [](vtkFlowVolume* v, vtkImageData*) { v->SetStreamSurface(0, INFINITY); } },
    { "Time surface 1", [](vtkFlowVolume* v, vtkImageData*) { v->SetTimeSurface(1, INFINITY); } },
    { "10001 parts",
      [](vtkFlowVolume* v, vtkImageData*)
      {
        v->SetInterval(0, 0.0, 1.0);
        v->SetInterval(1, 2.0, 3.0);
        v->SetNumberOfStreamSurfaces(9999);
        for (int i = 0; i < 9999; ++i)
        {
          v->SetStreamSurface(i, (i + 1) / 10001.0);
        }
      } },
  };
  for (const auto& one : cases)
  {
    check.SetContext(one.Part);
    auto input = MakeInput(4);
    vtkNew<vtkFlowVolume> volume;
    AllowWarnings(volume);
    SetAll(volume);
    one.Spoil(volume, input);
    volume->SetInputData(input);
    const std::string message = UpdateAndGetErrors(volume);
    check.Contains(message, one.Part);
    for (int port = 0; port < 3; ++port)
    {
      check.Equal(volume->GetOutput(port)->GetNumberOfCells(), 0, "no output");
    }
    volume->SetInputData(MakeInput(4));
    volume->SetNumberOfStreamSurfaces(0);
    volume->SetNumberOfTimeSurfaces(0);
    SetAll(volume);
    check.That(UpdateAndGetErrors(volume).empty(), "output after the correction");
  }
  check.SetContext("settings");
  vtkNew<vtkFlowVolume> volume;
  AllowWarnings(volume);
  check.Contains(CaptureErrors(volume, [&]() { volume->SetStreamSurface(-1, 0.5); }), "-1");
  check.Contains(CaptureErrors(volume, [&]() { volume->SetInterval(10000, 0.0, 1.0); }),
    "Interval index 10000 is not in the range 0 to 9999.");
  check.Near(volume->GetStreamSurface(3), 0.0, 0.0, "intervals that do not exist", 1.0);
  volume->SetTimeSurface(2, 0.5);
  check.Equal(volume->GetNumberOfTimeSurfaces(), 3, "surfaces are added");
  check.Near(volume->GetTimeSurface(2), 0.5, 0.0, "a time");
  const vtkMTimeType before = volume->GetMTime();
  volume->SetTimeSurface(2, 0.5);
  check.Equal(static_cast<long long>(volume->GetMTime() - before), 0,
    "setting the same values does not modify the filter");
  SetAll(volume);
  CheckPrinted(Print(volume),
    { "0.3 to 0.6", "TimeRange: 0.1 to 0.6", "StreamSurfaces: 0.45", "TimeSurfaces: 0.35 0 0.5",
      "CellsOnSeams: 0", "TimePasses: 0" },
    check);
  // Inputs that are empty or have only lower-dimensional cells.
  for (int thickness : { 0, 1 })
  {
    auto flat = MakeFlowImage({ { 5, 5, 2 } }, { { -1, 1, -1, 1, 0, 1 } });
    flat->SetDimensions(5, 5, thickness);
    AddFlow(flat, CylinderFlow(0.2), { { { 0, 1, 0 } } });
    vtkNew<vtkFlowVolume> times;
    AllowWarnings(times);
    times->SetInputData(flat);
    check.That(UpdateAndGetErrors(times).empty(), "no error");
    check.Equal(times->GetOutput()->GetNumberOfCells(), 0, "no cells");
  }
}

void CheckArrays(Check& check)
{
  check.SetContext("arrays");
  auto input = MakeInput();
  vtkNew<vtkFloatArray> heat;
  heat->SetName("Heat");
  heat->SetNumberOfValues(input->GetNumberOfPoints());
  vtkNew<vtkIntArray> zone;
  // The filter once passed its own data under this name.
  zone->SetName("InflowItem");
  zone->SetNumberOfValues(input->GetNumberOfCells());
  for (vtkIdType p = 0; p < input->GetNumberOfPoints(); ++p)
  {
    heat->SetValue(p, static_cast<float>(input->GetPoint(p)[0]));
  }
  for (vtkIdType c = 0; c < input->GetNumberOfCells(); ++c)
  {
    zone->SetValue(c, static_cast<int>(c));
  }
  input->GetPointData()->AddArray(heat);
  input->GetCellData()->AddArray(zone);
  vtkNew<vtkFlowVolume> volume;
  AllowWarnings(volume);
  volume->SetInputData(input);
  SetAll(volume);
  volume->ParametersAsTextureCoordinatesOn();
  volume->Update();
  for (int port = 0; port < 3; ++port)
  {
    vtkUnstructuredGrid* output = volume->GetOutput(port);
    vtkPointData* data = output->GetPointData();
    check.That(IsValid(output, port == 0 ? VTK_TETRA : VTK_TRIANGLE), "cells are valid");
    check.That(vtkUnsignedCharArray::SafeDownCast(data->GetArray("FlowStatus")), "FlowStatus");
    auto* ids = vtkIntArray::SafeDownCast(data->GetArray("TerminationId"));
    check.That(ids && ids->GetRange()[0] == 0 && ids->GetRange()[1] == 0, "TerminationId");
    check.That(data->GetArray("Inflow") && data->GetArray("AdvectionTime"), "Inflow and time");
    check.That(data->GetTCoords() && data->GetTCoords() == data->GetArray("TerminationUV"),
      "texture coordinates");
    for (const char* name : { "OriginPoints", "OriginWeight", "vtkGhostType" })
    {
      check.That(!data->HasArray(name), std::string("no ") + name);
    }
    for (const char* name : { "OriginCell", "vtkFlowVolumeItem", "BoundarySide" })
    {
      check.That(!output->GetCellData()->HasArray(name), std::string("no ") + name);
    }
    check.That(output->GetFieldData()->HasArray("TerminationSurfaces"), "field arrays");
    for (vtkIdType p = 0; p < output->GetNumberOfPoints(); ++p)
    {
      check.Near(data->GetArray("Heat")->GetComponent(p, 0), output->GetPoint(p)[0], 1e-6,
        "array of the input", 1.0);
    }
  }
  vtkDataArray* zones = volume->GetOutput()->GetCellData()->GetArray("InflowItem");
  check.That(zones && zones->GetRange()[1] > 100, "cell array of the input");
  vtkDataArray* inflow = volume->GetOutput(1)->GetCellData()->GetArray("Inflow");
  vtkDataArray* ids = volume->GetOutput(1)->GetCellData()->GetArray("StreamSurfaceId");
  const double values[4] = { 0.3, 0.45, 0.6, 0.8 };
  int met[4] = { 0, 0, 0, 0 };
  for (vtkIdType c = 0; c < inflow->GetNumberOfTuples(); ++c)
  {
    const int id = static_cast<int>(ids->GetComponent(c, 0));
    ++met[id];
    check.Near(inflow->GetComponent(c, 0), values[id], 0.0, "Inflow of a triangle");
  }
  check.That(met[0] && met[1] && met[2] && met[3], "number of stream surfaces");
  check.That(input->GetPointData()->HasArray("FlowStatus") &&
      !input->GetCellData()->HasArray("vtkGhostType"),
    "the input is unchanged");
  // Arrays of other types, as readers may create them.
  check.SetContext("other types");
  auto other = MakeInput();
  for (const char* name : { "FlowStatus", "TerminationId", "TerminationUV", "AdvectionTime" })
  {
    vtkNew<vtkFloatArray> copy;
    copy->DeepCopy(other->GetPointData()->GetArray(name));
    copy->SetName(name);
    other->GetPointData()->AddArray(copy);
  }
  const vtkIdType expected = volume->GetOutput()->GetNumberOfCells();
  volume->SetInputData(other);
  volume->Update();
  check.Near(static_cast<double>(volume->GetOutput()->GetNumberOfCells()),
    static_cast<double>(expected), 0.01, "the number of cells is the same");
}

void CheckRuns(Check& check)
{
  const auto run = []()
  {
    std::vector<vtkSmartPointer<vtkUnstructuredGrid>> outputs;
    vtkNew<vtkFlowVolume> volume;
    volume->SetInputData(MakeInput(20));
    SetAll(volume);
    volume->Update();
    for (int port = 0; port < 3; ++port)
    {
      auto copy = vtkSmartPointer<vtkUnstructuredGrid>::New();
      copy->ShallowCopy(volume->GetOutput(port));
      outputs.push_back(copy);
    }
    return outputs;
  };
  CheckThreads("flow volume", run, check);
  check.SetContext("progress");
  vtkNew<vtkFlowVolume> volume;
  SetAll(volume);
  CheckProgress(volume, MakeInput(20), VTK_TETRA, check);
}

}

int TestFlowVolumeInput(int, char*[])
{
  return RunChecks({ CheckErrors, CheckArrays, CheckRuns });
}
