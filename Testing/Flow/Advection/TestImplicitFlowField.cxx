// SPDX-License-Identifier: BSD-3-Clause
// vtkImplicitFlowField on grids of every kind: position and time of arrival, optional results,
// sample modes, domain faces, spheres around critical points, threads, pieces and errors.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceExecution.h"
#include "Support/Checks/ReferenceMessages.h"
#include "Support/Checks/ReferenceProgress.h"
#include "Support/Checks/ReferenceRandom.h"
#include "Support/Flow/ReferenceFlowGrid.h"

#include "vtkFlowStatus.h"
#include "vtkImplicitFlowField.h"
#include "vtkTerminationPlane.h"
#include "vtkTerminationSphere.h"

#include "vtkAnalyticFlowSource.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace
{

using namespace reference;

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

vtkDataArray* GetArray(vtkDataSet* data, const char* name)
{
  return data->GetPointData()->GetArray(name);
}

double GetValue(vtkDataSet* data, const char* name, vtkIdType id, int component = 0)
{
  return GetArray(data, name)->GetComponent(id, component);
}

Vector Shear(const Vector& x)
{
  return { { 1.0, 0.25 * x[2], 0.0 } };
}

/// Returns grids of all kinds over [0, 4]^3 with a field that all of them interpolate exactly.
std::vector<std::pair<std::string, vtkSmartPointer<vtkDataSet>>> MakeGrids()
{
  auto grids = MakeFlowGrids();
  for (auto& grid : grids)
  {
    AddVectors(grid.second, Shear);
  }
  return grids;
}

/// Follows the shear flow backward: streamlines end at the plane x = 0 or leave at y = 0.
void TestGrids(Check& check)
{
  for (const auto& grid : MakeGrids())
  {
    check.SetContext(grid.first);
    vtkNew<vtkImplicitFlowField> filter;
    filter->SetInputDataObject(grid.second);
    filter->AddTerminationSurface(MakeFlowPlane(0.0));
    filter->ComputeArcLengthOn();
    filter->ComputeMaximumSpeedOn();
    filter->ComputeMeanVorticityOn();
    filter->ComputeLocalAttributesOn();
    check.That(UpdateAndGetErrors(filter).empty(), "no messages");
    vtkDataSet* output = vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0));
    check.That(
      std::strcmp(output->GetClassName(), grid.second->GetClassName()) == 0, "the output type");
    check.Equal(output->GetNumberOfCells(), grid.second->GetNumberOfCells(), "cells");
    // In deformed cells, a straight line is a curve in cell coordinates and is integrated with an
    // error.
    const double tolerance = grid.first == "structured grid" ? 4e-6 : 1e-10;
    vtkIdType reached = 0;
    for (vtkIdType id = 0; id < output->GetNumberOfPoints(); ++id)
    {
      double x[3];
      output->GetPoint(id, x);
      const double rate = 0.25 * x[2];
      const double y = x[1] - rate * x[0];
      const auto status = static_cast<int>(GetValue(output, "FlowStatus", id));
      const double speed = std::sqrt(1.0 + rate * rate);
      check.Near(GetValue(output, "LocalSpeed", id), speed, 1e-12, "local speed");
      check.Near(GetValue(output, "LocalVorticity", id), 0.25, 1e-11, "local vorticity");
      if (std::abs(y) < 1e-9 && x[0] > 0.0)
      {
        // Rounding errors decide whether streamlines toward the common edge of the planes x = 0 and
        // y = 0 reach the plane x = 0.
        continue;
      }
      const bool reaches = y >= 0.0;
      check.Equal(
        status, reaches ? vtkFlowStatus::REACHED_SURFACE : vtkFlowStatus::LEFT_DOMAIN, "status");
      const double time = reaches ? x[0] : x[1] / rate;
      check.Near(GetValue(output, "AdvectionTime", id), time, tolerance, "time", 1.0);
      check.Equal(static_cast<int>(GetValue(output, "TerminationId", id)), reaches ? 0 : -1, "id");
      check.Near(
        GetValue(output, "TerminationUV", id, 0), reaches ? y / 4.0 : 0.0, tolerance, "u", 1.0);
      check.Near(
        GetValue(output, "TerminationUV", id, 1), reaches ? x[2] / 4.0 : 0.0, tolerance, "v", 1.0);
      check.Near(
        GetValue(output, "ArcLength", id), speed * time, 10.0 * tolerance, "arc length", 1.0);
      check.Near(GetValue(output, "MaximumSpeed", id), speed, 10.0 * tolerance, "speed", 1.0);
      if (time > 0.0)
      {
        check.Near(GetValue(output, "MeanVorticity", id), 0.25, 10.0 * tolerance, "vorticity", 1.0);
      }
      reached += reaches ? 1 : 0;
    }
    vtkInterlumeReport* report = filter->GetReport();
    check.Equal(report->GetCount("Samples"), output->GetNumberOfPoints(), "samples in the report");
    check.That(report->GetNumber("Statuses", vtkFlowStatus::REACHED_SURFACE) >= reached,
      "samples that reached a surface in the report");
    check.Equal(report->GetCount("SurfaceIds"), 0, "id of the surface");
    check.Equal(report->GetCount("SamplesBySurface"),
      report->GetCount("Statuses", vtkFlowStatus::REACHED_SURFACE), "number of samples per id");
    check.Near(report->GetNumber("MaximumError"), 1e-6 * std::sqrt(2.0), 1e-3, "automatic error");
    check.Near(
      report->GetNumber("MinimumSpeed"), 1e-9 * std::sqrt(2.0), 1e-3, "automatic minimum speed");
    check.Equal(report->GetCount("Executions"), 1, "executions");
    vtkDataArray* surfaces = output->GetFieldData()->GetArray("TerminationSurfaces");
    check.Equal(surfaces->GetNumberOfTuples(), 1, "ids of surfaces");
  }
  check.SetContext("");
}

/// Tests samples on a separate image and on another dataset. Some samples are outside the field.
void TestSamples(Check& check)
{
  auto image = MakeFlowImage(5, Shear);
  vtkNew<vtkImplicitFlowField> filter;
  filter->SetInputDataObject(image);
  filter->AddTerminationSurface(MakeFlowPlane(0.0));
  filter->SetSampleMode(vtkImplicitFlowField::SAMPLES_OF_IMAGE);
  filter->SetSampleDimensions(9, 3, 1);
  filter->Update();
  vtkImageData* samples = vtkImageData::SafeDownCast(filter->GetOutputDataObject(0));
  check.That(samples != nullptr, "an image of samples");
  check.Equal(samples->GetNumberOfPoints(), 27, "samples");
  double bounds[6];
  samples->GetBounds(bounds);
  const double expected[6] = { 0.0, 4.0, 0.0, 4.0, 2.0, 2.0 };
  for (int i = 0; i < 6; ++i)
  {
    check.Near(bounds[i], expected[i], 0.0, "bounds of the field", 1.0);
  }
  for (vtkIdType id = 0; id < 27; ++id)
  {
    check.Near(GetValue(samples, "TerminationUV", id, 1),
      GetValue(samples, "FlowStatus", id) == 0.0 ? 0.5 : 0.0, 1e-12, "v at the center", 1.0);
  }
  filter->SetSampleBounds(-1.0, 5.0, 1.0, 1.0, 0.0, 4.0);
  filter->SetSampleDimensions(7, 1, 5);
  check.That(!samples->GetPointData()->HasArray("LocalSpeed"), "no local attributes by default");
  filter->ComputeLocalAttributesOn();
  filter->Update();
  for (const char* name : { "LocalSpeed", "LocalVorticity" })
  {
    check.Near(GetValue(samples, name, 0), 0.0, 0.0, "0 outside the field", 1.0);
    check.That(GetValue(samples, name, 3) > 0.0, "local attributes inside the field");
  }
  check.Equal(
    filter->GetReport()->GetCount("Statuses", vtkFlowStatus::OUTSIDE), 10, "samples outside");
  check.Equal(filter->GetReport()->GetCount("Executions"), 2, "executions");

  // Any subextent of the image has the values of the full image.
  const int part[6] = { 2, 4, 0, 0, 1, 3 };
  vtkNew<vtkImageData> whole;
  whole->DeepCopy(filter->GetOutputDataObject(0));
  vtkNew<vtkImplicitFlowField> other;
  other->SetInputDataObject(image);
  other->AddTerminationSurface(MakeFlowPlane(0.0));
  other->SetSampleMode(vtkImplicitFlowField::SAMPLES_OF_IMAGE);
  other->SetSampleBounds(-1.0, 5.0, 1.0, 1.0, 0.0, 4.0);
  other->SetSampleDimensions(7, 1, 5);
  other->UpdateExtent(part);
  vtkImageData* some = vtkImageData::SafeDownCast(other->GetOutputDataObject(0));
  check.Equal(some->GetNumberOfPoints(), 9, "samples of a subextent");
  for (int k = 1; k <= 3; ++k)
  {
    for (int i = 2; i <= 4; ++i)
    {
      int ijk[3] = { i, 0, k };
      check.That(GetValue(some, "AdvectionTime", some->ComputePointId(ijk)) ==
          GetValue(whole, "AdvectionTime", whole->ComputePointId(ijk)),
        "a subextent has the values of the full image");
    }
  }

  auto mesh = MakeFlowMesh(FlowMeshKinds().front(), { { 2, 2, 2 } });
  vtkNew<vtkDoubleArray> own;
  own->SetName("Own");
  own->SetNumberOfTuples(mesh->GetNumberOfPoints());
  own->Fill(7.0);
  mesh->GetPointData()->AddArray(own);
  filter->SetSampleData(mesh);
  filter->SetSampleMode(vtkImplicitFlowField::SAMPLES_OF_INPUT);
  filter->Update();
  auto* output = vtkUnstructuredGrid::SafeDownCast(filter->GetOutputDataObject(0));
  check.That(output != nullptr, "samples of another grid");
  check.Equal(output->GetNumberOfPoints(), mesh->GetNumberOfPoints(), "points of the other grid");
  check.That(GetArray(output, "Own") != nullptr, "arrays of the other grid");
  check.That(mesh->GetPointData()->GetNumberOfArrays() == 1, "the input is unchanged");
}

/// Uses domain faces as surfaces in a flow that leaves through all of them.
void TestDomainFaces(Check& check)
{
  auto image = MakeFlowImage(5,
    [](const Vector& x) {
      return Vector{ { x[0] - 2.0, x[1] - 2.0, x[2] - 2.0 } };
    });
  vtkNew<vtkImplicitFlowField> filter;
  filter->SetInputDataObject(image);
  filter->DomainFacesOn();
  filter->SetDirectionToForward();
  filter->SetSampleMode(vtkImplicitFlowField::SAMPLES_OF_IMAGE);
  filter->SetSampleDimensions(6, 7, 8);
  filter->SetSampleBounds(0.5, 3.4, 0.7, 3.6, 0.9, 3.45);
  filter->Update();
  vtkDataSet* output = vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  check.Equal(filter->GetReport()->GetSize("SurfaceIds"), 6, "number of faces that are reached");
  for (vtkIdType id = 0; id < output->GetNumberOfPoints(); ++id)
  {
    double x[3];
    output->GetPoint(id, x);
    int axis = 0;
    for (int i = 1; i < 3; ++i)
    {
      axis = std::abs(x[i] - 2.0) > std::abs(x[axis] - 2.0) ? i : axis;
    }
    const int face = 2 * axis + (x[axis] > 2.0 ? 1 : 0);
    check.Equal(static_cast<int>(GetValue(output, "TerminationId", id)), 1000 + face, "face");
    check.Near(GetValue(output, "AdvectionTime", id), std::log(2.0 / std::abs(x[axis] - 2.0)), 1e-5,
      "time to the face", 1.0);
    const double scale = 2.0 / std::abs(x[axis] - 2.0);
    int component = 0;
    for (int i = 0; i < 3; ++i)
    {
      if (i != axis)
      {
        check.Near(GetValue(output, "TerminationUV", id, component++),
          0.5 + 0.25 * scale * (x[i] - 2.0), 1e-5, "position on the face", 1.0);
      }
    }
  }
}

/// With CriticalPointSpheres, a flow source is enclosed in a sphere. Without this setting,
/// streamlines stagnate there.
void TestCriticalPoints(Check& check)
{
  const auto field = [](const Vector& x) {
    return Vector{ { x[0] - 1.9, 2.0 * (x[1] - 2.1), x[2] - 1.8 } };
  };
  auto image = MakeFlowImage(9, field);
  vtkNew<vtkImplicitFlowField> filter;
  filter->SetInputDataObject(image);
  filter->CriticalPointSpheresOn();
  filter->SetCriticalPointRadius(0.5);
  filter->Update();
  // One of 729 samples is inside the sphere.
  check.Equal(filter->GetReport()->GetCount("SurfaceIds"), 2000, "the sphere's id");
  check.Equal(
    filter->GetReport()->GetCount("SamplesBySurface"), 728, "all samples reach the sphere");
  check.Equal(
    filter->GetReport()->GetCount("Statuses", vtkFlowStatus::STAGNATED), 1, "one sample is inside");
  // In the forward direction there is no sphere, and all streamlines leave the field.
  filter->DomainFacesOn();
  filter->SetDirectionToForward();
  filter->Update();
  for (vtkIdType i = 0; i < filter->GetReport()->GetSize("SurfaceIds"); ++i)
  {
    check.That(filter->GetReport()->GetNumber("SurfaceIds", i) != 2000, "no sphere forward");
  }
  filter->SetDirectionToBackward();
  filter->CriticalPointSpheresOff();
  filter->SetMaximumError(1e-3);
  AllowWarnings(filter);
  filter->Update();
  check.Equal(filter->GetReport()->GetCount("Statuses", vtkFlowStatus::STAGNATED), 729,
    "without a sphere they stagnate");
}

/// Tests explicit and automatic ids, the surfaces that use them, and execution after modifying a
/// surface.
void TestIds(Check& check)
{
  auto image = MakeFlowImage(5, [](const Vector&) { return Vector{ { 1.0, 0.0, 0.0 } }; });
  vtkNew<vtkImplicitFlowField> filter;
  filter->SetInputDataObject(image);
  auto first = MakeFlowPlane(1.0);
  auto second = MakeFlowPlane(2.0);
  auto third = MakeFlowPlane(3.0);
  second->SetId(0);
  filter->AddTerminationSurface(first);
  filter->AddTerminationSurface(second);
  filter->AddTerminationSurface(third);
  filter->Update();
  vtkDataSet* output = vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  const int expected[5] = { -1, 1, 0, 2, 2 };
  for (vtkIdType i = 0; i < 5; ++i)
  {
    check.Equal(static_cast<int>(GetValue(output, "TerminationId", i)), expected[i], "id at x");
  }
  vtkTerminationSurface* const surfaces[4] = { first, second, third, nullptr };
  const int ids[4] = { 1, 0, 2, -1 };
  for (int i = 0; i < 4; ++i)
  {
    check.Equal(filter->GetUsedSurface(i) == surfaces[i], true, "the id is in use");
    check.Equal(filter->GetUsedSurfaceId(i), ids[i], "the surface has its id");
  }
  const auto executions = filter->GetReport()->GetCount("Executions");
  first->SetOrigin(0.5, 0.0, 0.0);
  first->SetPoint1(0.5, 4.0, 0.0);
  first->SetPoint2(0.5, 0.0, 4.0);
  filter->Update();
  check.Equal(filter->GetReport()->GetCount("Executions"), executions + 1,
    "a modified surface causes an execution");
  output = vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  check.Near(GetValue(output, "AdvectionTime", 1), 0.5, 1e-12, "time to the modified surface", 1.0);
}

std::string GetBytes(vtkDataSet* data)
{
  std::string bytes;
  for (int i = 0; i < data->GetPointData()->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = data->GetPointData()->GetArray(i);
    bytes.append(static_cast<const char*>(array->GetVoidPointer(0)),
      static_cast<std::size_t>(array->GetNumberOfValues() * array->GetDataTypeSize()));
  }
  return bytes;
}

/// Output and counts are identical for any number of threads.
void TestThreads(Check& check)
{
  vtkNew<vtkAnalyticFlowSource> source;
  source->SetField(vtkAnalyticFlowSource::HURRICANE);
  source->SetDimensions(17, 17, 9);
  std::string bytes;
  vtkIdType steps = 0;
  for (int threads : { 1, 2, 5 })
  {
    vtkSMPTools::LocalScope(vtkSMPTools::Config{ threads },
      [&]
      {
        vtkNew<vtkImplicitFlowField> filter;
        filter->SetInputConnection(source->GetOutputPort());
        filter->DomainFacesOn();
        filter->SetMaximumNumberOfSteps(500);
        filter->StoreStepCountsOn();
        filter->Update();
        const auto found = GetBytes(vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0)));
        check.That(!found.empty() && (bytes.empty() || found == bytes), "bytes");
        check.That(steps == 0 || steps == filter->GetReport()->GetNumber("Steps"), "steps");
        bytes = found;
        steps = filter->GetReport()->GetNumber("Steps");
      });
  }
  check.That(steps > 1000, "the report has steps");
}

/// Tests a block of points with NaN. Only samples that are in the block or reach it have the status
/// NOT_FINITE.
void TestNotFinite(Check& check)
{
  auto image = MakeFlowImage(9,
    [](const Vector& x) {
      return Vector{ { x[0] >= 1.5 && x[0] <= 2.0 && x[1] <= 1.0 ? NaN : 1.0, 0.0, 0.0 } };
    });
  vtkNew<vtkImplicitFlowField> filter;
  filter->SetInputDataObject(image);
  filter->AddTerminationSurface(MakeFlowPlane(0.0));
  check.That(WarningsOf(filter).find("NaN or infinite") != std::string::npos, "a warning");
  vtkDataSet* output = vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  for (vtkIdType id = 0; id < output->GetNumberOfPoints(); ++id)
  {
    double x[3];
    output->GetPoint(id, x);
    const auto status = static_cast<int>(GetValue(output, "FlowStatus", id));
    if (x[1] > 1.5 || x[0] < 1.0)
    {
      check.Equal(status, vtkFlowStatus::REACHED_SURFACE, "away from the block");
    }
    if (x[1] < 1.5 && x[0] > 1.0)
    {
      check.Equal(status, vtkFlowStatus::NOT_FINITE, "samples in the block or behind it");
    }
  }
}

void TestErrors(Check& check)
{
  auto image = MakeFlowImage(3, Shear);
  vtkNew<vtkImplicitFlowField> filter;
  filter->SetInputDataObject(image);
  CheckError(filter, "no surface to end on", check);
  vtkNew<vtkTerminationSphere> sphere;
  sphere->SetRadius(1.0);
  filter->AddTerminationSurface(sphere);
  filter->SetSampleMode(vtkImplicitFlowField::SAMPLES_OF_INPUT);
  CheckError(filter, "has no connection", check);
  filter->SetSampleMode(vtkImplicitFlowField::SAMPLES_OF_FIELD);
  filter->AddMeanArray("Missing");
  CheckError(filter, "\"Missing\"", check);
  filter->RemoveAllMeanArrays();
  vtkNew<vtkDoubleArray> scalar;
  scalar->SetName("Scalar");
  scalar->SetNumberOfTuples(27);
  scalar->Fill(0.5);
  image->GetPointData()->AddArray(scalar);
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Scalar");
  CheckError(filter, "Array \"Scalar\" has 1 component; 3 are needed", check);
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Nowhere");
  CheckError(filter, "The field has no point or cell array \"Nowhere\"", check);
  vtkNew<vtkTerminationPlane> line;
  line->SetOrigin(0.0, 0.0, 0.0);
  line->SetPoint1(1.0, 0.0, 0.0);
  line->SetPoint2(2.0, 0.0, 0.0);
  filter->AddTerminationSurface(line);
  filter->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::VECTORS);
  CheckError(filter, "Termination surface 1 (vtkTerminationPlane)", check);
}

void TestMeans(Check& check)
{
  auto image = MakeFlowImage(5, [](const Vector&) { return Vector{ { 2.0, 0.0, 0.0 } }; });
  vtkNew<vtkDoubleArray> scalar;
  scalar->SetName("Heat");
  for (vtkIdType id = 0; id < image->GetNumberOfPoints(); ++id)
  {
    scalar->InsertNextValue(3.0 * image->GetPoint(id)[0] + 1.0);
  }
  image->GetPointData()->AddArray(scalar);
  vtkNew<vtkImplicitFlowField> filter;
  filter->SetInputDataObject(image);
  filter->AddTerminationSurface(MakeFlowPlane(0.0));
  filter->AddMeanArray("Heat");
  filter->Update();
  vtkDataSet* output = vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  for (vtkIdType id = 0; id < output->GetNumberOfPoints(); ++id)
  {
    double x[3];
    output->GetPoint(id, x);
    check.Near(
      GetValue(output, "MeanHeat", id), 1.5 * x[0] + 1.0, 1e-10, "mean along the streamline", 1.0);
  }
  check.That(GetArray(output, "ArcLength") == nullptr, "no arrays that are not requested");
}

/// The pieces together contain all cells of the field without duplicates. Their samples have the
/// same results as in the full field.
void TestPieces(Check& check)
{
  constexpr int pieces = 3;
  for (const auto& grid : MakeGrids())
  {
    check.SetContext("pieces of " + grid.first);
    vtkNew<vtkImplicitFlowField> filter;
    filter->SetInputDataObject(grid.second);
    filter->AddTerminationSurface(MakeFlowPlane(0.0));
    filter->Update();
    auto whole = vtk::TakeSmartPointer(
      vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0)->NewInstance()));
    whole->DeepCopy(filter->GetOutputDataObject(0));
    vtkIdType cells = 0;
    for (int piece = 0; piece < pieces; ++piece)
    {
      filter->UpdatePiece(piece, pieces, 0);
      vtkDataSet* part = vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0));
      cells += part->GetNumberOfCells();
      check.That(
        part->GetNumberOfCells() < whole->GetNumberOfCells(), "a proper subset of the cells");
      for (vtkIdType id = 0; id < part->GetNumberOfPoints(); ++id)
      {
        const vtkIdType same = whole->FindPoint(part->GetPoint(id));
        check.That(GetValue(part, "AdvectionTime", id) == GetValue(whole, "AdvectionTime", same),
          "time in a piece");
      }
    }
    check.Equal(cells, whole->GetNumberOfCells(), "cells of all pieces");
  }
}

/// Progress is reported while the field is built. An abort at any time leaves an empty output
/// without an error.
void TestBuildingProgress(Check& check)
{
  for (const auto& grid : MakeGrids())
  {
    check.SetContext("progress of " + grid.first);
    vtkNew<vtkImplicitFlowField> filter;
    filter->SetInputDataObject(grid.second);
    filter->AddTerminationSurface(MakeFlowPlane(0.0));
    ProgressWatch watch;
    ObserveProgress(filter, watch);
    filter->Update();
    const std::vector<double> reports = watch.Progress;
    CheckMonotonicProgress(watch, 10, check);
    const auto isBuilding = [](double progress) { return progress > 0.0 && progress < 0.1; };
    const bool isIndexed = grid.first == "image" || grid.first == "rectilinear grid";
    check.That(std::count_if(reports.begin(), reports.end(), isBuilding) >= (isIndexed ? 1 : 3),
      "while building");
    // The executive itself sends the last event, after the filter's work.
    for (std::size_t after = 0; after + 1 < reports.size(); ++after)
    {
      watch.Progress.clear();
      watch.AbortAfter = after;
      // Executives of newer VTK versions do not reset the abort flag.
      filter->SetAbortExecute(0);
      filter->Modified();
      check.That(UpdateAndGetErrors(filter).empty(), "an abort is not an error");
      auto* output = vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0));
      check.Equal(output->GetNumberOfPoints(), 0, "points after an abort");
      check.Equal(filter->GetReport()->GetCount("Executions"), 1, "an aborted execution");
      // Executives of newer VTK versions report progress 1 even for an aborted execution.
      const std::size_t ends = watch.Progress.back() == 1.0 ? 1 : 0;
      check.That(watch.Progress.size() - ends == after + 1, "no progress after an abort");
    }
  }
  check.SetContext("");
}

void TestProgress(Check& check)
{
  vtkNew<vtkImplicitFlowField> filter;
  filter->SetInputDataObject(MakeFlowImage(17, Shear));
  filter->AddTerminationSurface(MakeFlowPlane(0.0));
  const auto update = [&filter]()
  {
    filter->Update();
    return GetBytes(vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0)));
  };
  CheckAborts(filter, 5, { 0.4 }, update, check);
  CheckPrinted(
    Print(filter), { "MaximumTime", "NumberOfTerminationSurfaces: 1", "Statuses: " }, check);
  check.Equal(filter->GetReport()->GetCount("Statuses", vtkFlowStatus::STAGNATED), 0,
    "samples that stagnated");
}

}

int TestImplicitFlowField(int, char*[])
{
  Check check;
  TestGrids(check);
  TestSamples(check);
  TestDomainFaces(check);
  TestCriticalPoints(check);
  TestIds(check);
  TestThreads(check);
  TestNotFinite(check);
  TestErrors(check);
  TestMeans(check);
  TestPieces(check);
  TestProgress(check);
  TestBuildingProgress(check);
  return check.Result();
}
