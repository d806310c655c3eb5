// SPDX-License-Identifier: BSD-3-Clause
// Flow filters with default settings: they limit the number of samples for large fields, set active
// scalars for coloring, and warn if the output is empty, stating properties of the data.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceMessages.h"
#include "Support/Flow/ReferenceFlowGrid.h"

#include "vtkFlowBoundary.h"
#include "vtkFlowCriticalPoints.h"
#include "vtkFlowLIC.h"
#include "vtkFlowVolume.h"
#include "vtkImplicitFlowField.h"
#include "vtkInflowMapping.h"
#include "vtkStreamSurfaceParameters.h"
#include "vtkTerminationInflow.h"
#include "vtkTerminationPlane.h"
#include "vtkVortexAxis.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkRectilinearGrid.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStructuredGrid.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace
{

using namespace reference;

Vector Along(const Vector&)
{
  return { { 0.5, 0.0, 0.0 } };
}

std::string ScalarsOf(vtkAlgorithm* filter, int port = 0)
{
  vtkDataSet* output = vtkDataSet::SafeDownCast(filter->GetOutputDataObject(port));
  vtkDataArray* scalars = output ? output->GetPointData()->GetScalars() : nullptr;
  return scalars && scalars->GetName() ? scalars->GetName() : "none";
}

vtkDataSet* Sample(vtkImplicitFlowField* filter, vtkDataSet* field)
{
  filter->SetInputDataObject(field);
  filter->Update();
  return vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0));
}

void CheckBounds(vtkDataSet* samples, vtkDataSet* field, Check& check)
{
  double expected[6];
  double found[6];
  field->GetBounds(expected);
  samples->GetBounds(found);
  for (int i = 0; i < 6; ++i)
  {
    check.Near(found[i], expected[i], 1e-12, "bounds of the samples", 4.0);
  }
}

/// Default samples: every n-th point of large grids, a regular grid for large meshes, and all
/// points of small grids.
void TestSamples(Check& check)
{
  vtkNew<vtkTerminationInflow> surface;
  vtkNew<vtkImplicitFlowField> filter;
  filter->AddTerminationSurface(surface);
  check.Equal(filter->GetSampleMode(), vtkImplicitFlowField::SAMPLES_AUTOMATIC, "the default mode");
  for (const auto& grid : MakeFlowGrids())
  {
    check.SetContext(grid.first);
    AddVectors(grid.second, Along);
    vtkDataSet* samples = Sample(filter, grid.second);
    check.That(samples->IsA(grid.second->GetClassName()), "the output has the type of the field");
    check.Equal(
      samples->GetNumberOfPoints(), grid.second->GetNumberOfPoints(), "points of the field");
  }

  check.SetContext("large image");
  const auto image = MakeFlowImage(41, Along);
  auto* thin = vtkImageData::SafeDownCast(Sample(filter, image));
  check.That(thin != nullptr, "an image");
  check.That(thin->GetNumberOfPoints() <= 32768 && thin->GetNumberOfPoints() > 8192,
    "the number of points is limited");
  CheckBounds(thin, image, check);

  check.SetContext("large structured grid");
  const auto structured = MakeStructuredGrid({ { 40, 30, 50 } });
  MovePoints(structured, MakeDisplacement({ { 40, 30, 50 } }, 0.2));
  AddVectors(structured, Along);
  vtkNew<vtkDoubleArray> ids;
  ids->SetName("Ids");
  for (vtkIdType p = 0; p < structured->GetNumberOfPoints(); ++p)
  {
    ids->InsertNextValue(static_cast<double>(p));
  }
  structured->GetPointData()->AddArray(ids);
  auto* every = vtkStructuredGrid::SafeDownCast(Sample(filter, structured));
  check.That(every != nullptr, "a structured grid");
  int dimensions[3];
  every->GetDimensions(dimensions);
  // The number of points is halved along one axis at a time: 41 x 31 x 51 = 64821, 41 x 31 x 26 =
  // 33046, 21 x 31 x 26.
  check.That(
    dimensions[0] == 21 && dimensions[1] == 31 && dimensions[2] == 26, "every second point");
  CheckBounds(every, structured, check);
  vtkDataArray* retained = every->GetPointData()->GetArray("Ids");
  for (vtkIdType p = 0; retained && p < every->GetNumberOfPoints(); ++p)
  {
    double x[3];
    structured->GetPoint(static_cast<vtkIdType>(retained->GetComponent(p, 0)), x);
    check.That(std::equal(x, x + 3, every->GetPoint(p)), "a point of the field with its values");
  }
  check.That(retained != nullptr, "arrays are passed");
  vtkIdType cells = 0;
  const vtkIdType whole = every->GetNumberOfCells();
  for (int piece = 0; piece < 3; ++piece)
  {
    filter->UpdatePiece(piece, 3, 0);
    cells += vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0))->GetNumberOfCells();
  }
  check.Equal(cells, whole, "cells of three pieces");
  filter->UpdatePiece(0, 1, 0);

  check.SetContext("large rectilinear grid");
  vtkNew<vtkRectilinearGrid> rectilinear;
  rectilinear->SetDimensions(34, 34, 34);
  vtkNew<vtkDoubleArray> positions;
  for (int i = 0; i < 34; ++i)
  {
    positions->InsertNextValue(i * i);
  }
  rectilinear->SetXCoordinates(positions);
  rectilinear->SetYCoordinates(positions);
  rectilinear->SetZCoordinates(positions);
  AddVectors(rectilinear, Along);
  vtkDataSet* rows = Sample(filter, rectilinear);
  check.That(rows->IsA("vtkRectilinearGrid"), "a rectilinear grid");
  check.Equal(rows->GetNumberOfPoints(), 18 * 34 * 34, "every second point along x");
  CheckBounds(rows, rectilinear, check);

  check.SetContext("large mesh");
  const auto mesh = MakeFlowMesh(FlowMeshKinds().front(), { { 36, 36, 36 } });
  AddVectors(mesh, Along);
  vtkDataSet* voxels = Sample(filter, mesh);
  check.That(voxels->IsA("vtkUnstructuredGrid"), "an unstructured grid");
  check.That(mesh->GetNumberOfPoints() > 32768 && voxels->GetNumberOfPoints() <= 32768, "fewer");
  check.Equal(voxels->GetNumberOfCells(), 30 * 30 * 30, "voxels");
  CheckBounds(voxels, mesh, check);
}

/// The filters set active scalars and pass the scalars that were active before.
void TestScalars(Check& check)
{
  check.SetContext("scalars");
  const auto image = MakeFlowImage(9, Along);
  vtkNew<vtkDoubleArray> before;
  before->SetName("Before");
  before->SetNumberOfValues(image->GetNumberOfPoints());
  before->Fill(1.0);
  image->GetPointData()->SetScalars(before);
  vtkNew<vtkTerminationInflow> surface;
  vtkNew<vtkImplicitFlowField> field;
  field->SetInputDataObject(image);
  field->AddTerminationSurface(surface);
  vtkNew<vtkInflowMapping> mapping;
  mapping->SetInputConnection(field->GetOutputPort());
  vtkNew<vtkFlowVolume> volume;
  volume->SetInputConnection(mapping->GetOutputPort());
  volume->GenerateStreamSurfacesOn();
  volume->SetStreamSurface(0, 0.5);
  check.That(WarningsOf(volume).empty(), "no warning");
  vtkNew<vtkStreamSurfaceParameters> texture;
  texture->SetInputConnection(volume->GetOutputPort(1));
  texture->SetMapping(mapping);
  texture->AddTerminationSurface(field->GetUsedSurface(0), field->GetUsedSurfaceId(0));
  texture->Update();
  vtkNew<vtkFlowLIC> lic;
  lic->SetInputData(image);
  lic->Update();
  check.That(ScalarsOf(field) == "AdvectionTime", "active scalars of the field");
  check.That(ScalarsOf(mapping) == "Inflow", "active scalars of the mapping");
  check.That(ScalarsOf(volume) == "Inflow", "active scalars of the volume");
  check.That(ScalarsOf(volume, 1) == "Inflow", "active scalars of the stream surfaces");
  check.That(ScalarsOf(texture) == "AdvectionTime", "active scalars of the texture");
  check.That(ScalarsOf(lic) == "LIC", "active scalars of the convolution");
  for (vtkAlgorithm* filter : { static_cast<vtkAlgorithm*>(field.GetPointer()),
         static_cast<vtkAlgorithm*>(mapping.GetPointer()),
         static_cast<vtkAlgorithm*>(lic.GetPointer()) })
  {
    vtkDataSet* output = vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0));
    check.That(
      output->GetPointData()->HasArray("Before"), "the previously active scalars are passed");
  }
  check.That(vtkDataSet::SafeDownCast(mapping->GetOutputDataObject(0))
               ->GetPointData()
               ->HasArray("AdvectionTime"),
    "the advection time is passed");
  // A time range that contains all times does not cut the volume.
  volume->SetTimeRange(0.0, 8.0);
  volume->Update();
  check.Equal(volume->GetReport()->GetCount("TimePasses"), 0, "no cut by time");
  volume->SetTimeRange(0.0, 2.0);
  volume->Update();
  check.Equal(volume->GetReport()->GetCount("TimePasses"), 1, "the range is cut at its end");
}

/// Each empty output causes a warning that states the reason.
void TestWarnings(Check& check)
{
  check.SetContext("warnings");
  const auto image = MakeFlowImage(9, Along);
  const auto beside = MakeFlowPlane(9.0);
  vtkNew<vtkImplicitFlowField> field;
  field->SetInputDataObject(image);
  field->AddTerminationSurface(beside);
  check.Contains(WarningsOf(field),
    "None of the 729 samples reached a termination surface (left domain: "
    "729). Put a surface where the flow comes from");
  vtkNew<vtkInflowMapping> mapping;
  mapping->SetInputConnection(field->GetOutputPort());
  check.Contains(WarningsOf(mapping), "Inflow is NaN at all 729 samples: 0 of them reached");
  vtkNew<vtkFlowVolume> volume;
  volume->SetInputConnection(mapping->GetOutputPort());
  check.Contains(WarningsOf(volume), "None of the 729 samples reached");
  check.That(WarningsOf(volume).find("None") == std::string::npos, "one warning per execution");

  field->RemoveAllTerminationSurfaces();
  field->AddTerminationSurface(MakeFlowPlane(0.0));
  check.That(WarningsOf(field).empty(), "all samples");
  volume->SetInterval(0, 2.0, 3.0);
  check.Contains(
    WarningsOf(volume), "Interval 0, [2, 3], is outside of the range of Inflow, [0, 1].");
  volume->SetNumberOfIntervals(0);
  volume->SetTimeRange(20.0, 30.0);
  check.Contains(WarningsOf(volume),
    "The time range, [20, 30], is outside of the range of AdvectionTime, [0, 8].");
  volume->SetTimeRange(0.0, 30.0);
  volume->GenerateStreamSurfacesOn();
  check.Contains(WarningsOf(volume), "no value for stream surfaces");
  vtkNew<vtkStreamSurfaceParameters> texture;
  texture->SetInputData(vtkNew<vtkUnstructuredGrid>());
  texture->SetMapping(mapping);
  check.Contains(WarningsOf(texture), "The input has no triangles.");
  // Samples in a plane enclose no volume.
  const auto flat = MakeFlowImage(9, Along);
  flat->SetDimensions(9, 9, 1);
  vtkNew<vtkImageData> sheet;
  sheet->SetDimensions(9, 9, 1);
  vtkNew<vtkImplicitFlowField> onSheet;
  onSheet->SetInputDataObject(image);
  onSheet->SetSampleMode(vtkImplicitFlowField::SAMPLES_OF_INPUT);
  onSheet->SetSampleData(sheet);
  onSheet->AddTerminationSurface(MakeFlowPlane(0.0));
  vtkNew<vtkFlowVolume> none;
  none->SetInputConnection(onSheet->GetOutputPort());
  check.Contains(WarningsOf(none), "cells of fewer than three dimensions have no volume");

  vtkNew<vtkFlowCriticalPoints> points;
  points->SetInputData(image);
  check.Contains(WarningsOf(points),
    "no isolated critical point in any of its 512 cells. The velocity is 0 throughout 0 cells");
  vtkNew<vtkFlowBoundary> boundary;
  boundary->SetInputData(image);
  boundary->SetMinimumNormalSpeed(1.0);
  check.Contains(WarningsOf(boundary), "No flow passes through the boundary, which has 384 faces");
  vtkNew<vtkVortexAxis> axis;
  axis->SetInputData(image);
  check.Contains(WarningsOf(axis), "No plane perpendicular to Axis (0, 0, 1) has a vortex");
  vtkNew<vtkFlowLIC> lic;
  vtkNew<vtkImageData> away;
  away->SetDimensions(3, 3, 3);
  away->SetOrigin(100.0, 0.0, 0.0);
  lic->SetInputData(away);
  lic->SetFieldData(image);
  check.Contains(WarningsOf(lic), "All 27 points lie outside the field");
  // Spheres around critical points in a field without critical points.
  vtkNew<vtkImplicitFlowField> spheres;
  spheres->SetInputDataObject(image);
  spheres->AddTerminationSurface(MakeFlowPlane(0.0));
  spheres->CriticalPointSpheresOn();
  check.That(WarningsOf(spheres).empty(), "no warning from the internal search");
}

/// If there are no active vectors, the error lists arrays that could be used.
void TestErrors(Check& check)
{
  check.SetContext("errors");
  const auto image = MakeFlowImage(5, Along);
  image->GetPointData()->SetActiveVectors(nullptr);
  vtkNew<vtkImplicitFlowField> field;
  field->SetInputDataObject(image);
  field->AddTerminationSurface(MakeFlowPlane(0.0));
  check.Contains(UpdateAndGetErrors(field), "Its arrays with three components: \"");
}
}

int TestFlowDefaults(int, char*[])
{
  return RunChecks({ TestSamples, TestScalars, TestWarnings, TestErrors });
}
