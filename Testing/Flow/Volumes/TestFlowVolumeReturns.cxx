// SPDX-License-Identifier: BSD-3-Clause
// Flow that returns to its termination surface: on which side of the surface samples lie and
// streamlines arrive, which cells a flow volume omits, and the limit on time jumps.
#include "Support/AnalyticFlows/ReferenceFlowResults.h"
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceMessages.h"
#include "Support/Flow/ReferenceFlowGrid.h"

#include "vtkFlowStatus.h"
#include "vtkFlowVolume.h"
#include "vtkImplicitFlowField.h"
#include "vtkTerminationMesh.h"
#include "vtkTerminationPlane.h"
#include "vtkTerminationSphere.h"

#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace
{

using namespace reference;

constexpr double FullTurn = 6.283185307179586;

Vector Rotation(const Vector& x)
{
  return { { -x[1], x[0], 0.0 } };
}

vtkSmartPointer<vtkImageData> MakeImage(
  int points, const std::array<double, 6>& bounds, const VectorField& field)
{
  auto image = MakeFlowImage({ { points, points, 3 } }, bounds);
  AddVectors(image, field);
  return image;
}

vtkSmartPointer<vtkTerminationPlane> MakePlane(
  double x, double y, double z, const Vector& u, const Vector& v, int id = 0)
{
  auto plane = vtkSmartPointer<vtkTerminationPlane>::New();
  plane->SetOrigin(x, y, z);
  plane->SetPoint1(x + u[0], y + u[1], z + u[2]);
  plane->SetPoint2(x + v[0], y + v[1], z + v[2]);
  plane->SetId(id);
  return plane;
}

/// Returns the half-plane y = 0, x > 0 with normal along y.
vtkSmartPointer<vtkTerminationPlane> MakeHalfPlane()
{
  return MakePlane(0, 0, -1, { { 0, 0, 3 } }, { { 3, 0, 0 } });
}

double GetTime(vtkDataSet* data, vtkIdType id)
{
  return data->GetPointData()->GetArray("AdvectionTime")->GetComponent(id, 0);
}

int GetSide(vtkDataSet* data, vtkIdType id)
{
  return static_cast<int>(data->GetPointData()->GetArray("TerminationSide")->GetComponent(id, 0));
}

/// Counts cells whose points all have the same TerminationId and for which \a isOmitted(points) is
/// true.
vtkIdType CountCells(
  vtkDataSet* data, const std::function<bool(const std::vector<Vector>&)>& isOmitted)
{
  vtkDataArray* ids = data->GetPointData()->GetArray("TerminationId");
  vtkIdType count = 0;
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
  {
    data->GetCellPoints(cell, corners);
    const double id = ids->GetComponent(corners->GetId(0), 0);
    std::vector<Vector> points;
    for (const vtkIdType corner : *corners)
    {
      Vector x;
      data->GetPoint(corner, x.data());
      if (id >= 0.0 && ids->GetComponent(corner, 0) == id)
      {
        points.push_back(x);
      }
    }
    count += static_cast<vtkIdType>(points.size()) == corners->GetNumberOfIds() && isOmitted(points)
      ? 1
      : 0;
  }
  return count;
}

/// Counts tetrahedra with points on both sides of the zero level set of a function.
vtkIdType CountAcross(
  vtkUnstructuredGrid* mesh, const std::function<double(const double*)>& function, double tolerance)
{
  vtkIdType count = 0;
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    mesh->GetCellPoints(cell, corners);
    double lowest = VTK_DOUBLE_MAX;
    double highest = -VTK_DOUBLE_MAX;
    for (const vtkIdType corner : *corners)
    {
      const double value = function(mesh->GetPoint(corner));
      lowest = std::min(lowest, value);
      highest = std::max(highest, value);
    }
    count += lowest < -tolerance && highest > tolerance ? 1 : 0;
  }
  return count;
}

/// Returns the signed distance from the half-plane, or 0 past its edge x = 0.
double GetHalfPlane(const double* x)
{
  return x[0] > 0.0 ? x[1] : 0.0;
}

/// Checks the far-side results of a rotation with unit angular speed: the arc length is the time
/// multiplied by the radius.
void CheckFarSides(vtkDataSet* samples, Check& check)
{
  vtkFieldData* data = samples->GetFieldData();
  vtkDataArray* ids = data->GetArray("BeyondTerminationId");
  vtkDataArray* positions = data->GetArray("BeyondSamplePosition");
  vtkDataArray* times = data->GetArray("BeyondAdvectionTime");
  vtkDataArray* lengths = data->GetArray("BeyondArcLength");
  vtkIdType fullTurns = 0;
  for (vtkIdType i = 0; i < ids->GetNumberOfTuples(); ++i)
  {
    if (ids->GetComponent(i, 0) < 0.0)
    {
      continue;
    }
    const double radius = std::hypot(positions->GetComponent(i, 0), positions->GetComponent(i, 1));
    const double time = times->GetComponent(i, 0);
    check.Near(lengths->GetComponent(i, 0), radius * time, 1e-5, "arc length of a far side", 1e-3);
    fullTurns += time > 0.9 * FullTurn ? 1 : 0;
  }
  check.That(fullTurns > 0, "some far sides are reached after a full rotation");
}

void TestRotation(Check& check)
{
  for (const bool isForward : { false, true })
  {
    for (const int points : { 24, 25 })
    {
      check.SetContext(std::string(isForward ? "forward" : "backward") +
        (points % 2 == 0 ? ", surface within cells" : ", surface on points"));
      vtkNew<vtkImplicitFlowField> field;
      field->SetInputData(MakeImage(points, { { -1, 1, -1, 1, 0, 0.2 } }, Rotation));
      field->AddTerminationSurface(MakeHalfPlane());
      field->SetDirection(isForward);
      field->ComputeArcLengthOn();
      field->Update();
      vtkDataSet* samples = vtkDataSet::SafeDownCast(field->GetOutput());
      CheckFarSides(samples, check);
      // On the upper side of the surface, forward streamlines lead away from it, and backward
      // streamlines lead toward it.
      const int upper = isForward ? vtkFlowStatus::AWAY : vtkFlowStatus::TOWARD;
      const int lower = isForward ? vtkFlowStatus::TOWARD : vtkFlowStatus::AWAY;
      const double size = 2.0 / (points - 1);
      vtkIdType sided = 0;
      for (vtkIdType id = 0; id < samples->GetNumberOfPoints(); ++id)
      {
        double x[3];
        samples->GetPoint(id, x);
        const double side = GetSide(samples, id);
        const bool isNear = std::abs(x[1]) < 1.01 * size && x[0] > 1e-9 && x[0] < 0.9;
        sided += side != 0.0 ? 1 : 0;
        if (isNear && std::abs(x[1]) > 1e-9)
        {
          check.Near(side, x[1] > 0.0 ? upper : -lower, 0.0, "side", 1.0);
        }
        else if (!isNear && x[0] < 0.9 && std::abs(x[0]) > 1e-9)
        {
          check.Near(side, 0.0, 0.0, "samples away from the surface have no side", 1.0);
        }
      }
      check.That(sided > 0, "some samples have a side");
      vtkNew<vtkFlowVolume> volume;
      AllowWarnings(volume);
      volume->SetInputData(samples);
      volume->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
      volume->Update();
      check.Equal(
        CountAcross(volume->GetOutput(), GetHalfPlane, 1e-9), 0, "no cell crosses the surface");
      check.That(!volume->GetOutput()->GetPointData()->HasArray("TerminationSide"),
        "TerminationSide is not passed");
      vtkUnstructuredGrid* mesh = volume->GetOutput();
      for (vtkIdType id = 0; id < mesh->GetNumberOfPoints(); ++id)
      {
        double x[3];
        mesh->GetPoint(id, x);
        const double angle = std::atan2(x[1], x[0]);
        const double signedAngle = isForward ? -angle : angle;
        check.Near(
          std::remainder(GetTime(mesh, id) - signedAngle, FullTurn), 0.0, 1e-5, "time", 1.0);
      }
      const vtkIdType expected = CountCells(samples,
        [&](const std::vector<Vector>& corners)
        {
          double lowest = 1.0;
          double highest = -1.0;
          double right = -1.0;
          for (const Vector& x : corners)
          {
            lowest = std::min(lowest, std::abs(x[1]) < 1e-9 ? 0.0 : x[1]);
            highest = std::max(highest, std::abs(x[1]) < 1e-9 ? 0.0 : x[1]);
            right = std::max(right, x[0]);
          }
          // A cell that only reaches the edge of the half plane, at x = 0, still touches it.
          return right > -1e-9 &&
            (isForward ? lowest <= 0.0 && highest > 0.0 : lowest < 0.0 && highest >= 0.0);
        });
      check.Equal(
        volume->GetReport()->GetCount("CellsAcrossSurfaces"), expected, "cells across the surface");
      check.That(expected >= 20, "some cells are across the surface");
      check.Equal(volume->GetReport()->GetCount("CellsWithTimeJumps"), 0, "no limit of time jumps");
      // Without the far-side arrays, cells across the surface are omitted.
      vtkSmartPointer<vtkDataSet> bare = vtk::TakeSmartPointer(samples->NewInstance());
      bare->ShallowCopy(samples);
      bare->GetFieldData()->RemoveArray("BeyondSampleId");
      volume->SetInputData(bare);
      volume->Update();
      check.Equal(volume->GetReport()->GetCount("CellsAcrossSurfaces"), expected,
        "cells across the surface, omitted");
      check.Equal(volume->GetReport()->GetCount("CellsCut"), 0, "no cell is cut");
      const vtkIdType before = volume->GetOutput()->GetNumberOfCells();
      // Without TerminationSide, cells across the surface are not detected.
      bare->GetPointData()->RemoveArray("TerminationSide");
      bare->Modified();
      volume->Update();
      check.Equal(
        volume->GetReport()->GetCount("CellsAcrossSurfaces"), 0, "no cells across the surface");
      check.That(volume->GetOutput()->GetNumberOfCells() > before, "more cells");
      // With a limit on time jumps, some or all of these cells are skipped instead.
      volume->SetMaximumTimeJump(0.9 * FullTurn);
      volume->Update();
      const vtkIdType jumps = volume->GetReport()->GetNumber("CellsWithTimeJumps");
      check.That(jumps > 0 && jumps <= expected, "time jumps");
      volume->SetMaximumTimeJump(1e-300);
      volume->Update();
      check.Equal(volume->GetOutput()->GetNumberOfCells(), 0, "times differ in all cells");
    }
  }
}

/// A mesh yields the same sides as a plane. Positions past its boundary edge have no side.
void TestMesh(Check& check)
{
  check.SetContext("mesh");
  vtkNew<vtkPlaneSource> source;
  source->SetOrigin(0, 0, -1);
  source->SetPoint1(0, 0, 2);
  source->SetPoint2(3, 0, -1);
  source->SetResolution(2, 3);
  source->Update();
  vtkNew<vtkTerminationMesh> mesh;
  mesh->SetMesh(source->GetOutput());
  const auto image = MakeImage(16, { { -1, 1, -1, 1, 0, 0.2 } }, Rotation);
  vtkNew<vtkImplicitFlowField> byMesh;
  byMesh->SetInputData(image);
  byMesh->AddTerminationSurface(mesh);
  byMesh->Update();
  vtkNew<vtkImplicitFlowField> byPlane;
  byPlane->SetInputData(image);
  byPlane->AddTerminationSurface(MakeHalfPlane());
  byPlane->Update();
  for (vtkIdType id = 0; id < image->GetNumberOfPoints(); ++id)
  {
    check.Equal(GetSide(vtkDataSet::SafeDownCast(byMesh->GetOutput()), id),
      GetSide(vtkDataSet::SafeDownCast(byPlane->GetOutput()), id), "the same side");
  }
  double locations[3][3] = { { 1, 5, 0 }, { -1, 5, 0 }, { 1, -2, 2.5 } };
  for (vtkTerminationSurface* surface :
    std::initializer_list<vtkTerminationSurface*>{ mesh, byPlane->GetTerminationSurface(0) })
  {
    check.That(surface->ProjectsOntoSurface(locations[0]), "beside");
    check.That(
      !surface->ProjectsOntoSurface(locations[1]) && !surface->ProjectsOntoSurface(locations[2]),
      "no side outside the boundary edge");
  }
}

/// If two surfaces have the same id, the TerminationSide of a sample refers to the closer one.
/// Cells midway between the surfaces, where the side changes, are not omitted.
void TestOneId(Check& check)
{
  check.SetContext("two surfaces with one id");
  vtkNew<vtkImplicitFlowField> field;
  field->SetInputData(MakeImage(40, { { 0.05, 2, 0, 1, 0, 1 } },
    [](const Vector&) {
      return Vector{ { 1, 0, 0 } };
    }));
  for (const double x : { 0.07, 0.93 })
  {
    field->AddTerminationSurface(MakePlane(x, -1, -1, { { 0, 3, 0 } }, { { 0, 0, 3 } }, 7));
  }
  field->Update();
  vtkNew<vtkFlowVolume> volume;
  volume->SetInputConnection(field->GetOutputPort());
  volume->Update();
  // Only one layer of cells, at the second surface, is counted. Samples upstream of the first
  // surface reach no surface.
  check.Equal(volume->GetReport()->GetCount("CellsAcrossSurfaces"), 39 * 2, "cells");
  // The tolerance allows for single-precision points.
  check.Equal(CountAcross(
                volume->GetOutput(), [](const double* x) { return x[0] - 0.93; }, 1e-6),
    0, "no cell crosses a surface");
  check.That(CountAcross(
               volume->GetOutput(), [](const double* x) { return x[0] - 0.52; }, 1e-6) > 0,
    "the center has cells");
}

/// In uniform flow through a sphere, the time jumps at the side where the flow leaves the sphere.
void TestSphere(Check& check)
{
  check.SetContext("sphere");
  vtkNew<vtkImplicitFlowField> field;
  auto image = MakeFlowImage({ { 30, 30, 30 } }, { { -1, 1, -1, 1, -1, 1 } });
  AddVectors(image, [](const Vector&) { return Vector{ { 1, 0, 0 } }; });
  field->SetInputData(image);
  vtkNew<vtkTerminationSphere> sphere;
  sphere->SetRadius(0.55);
  field->AddTerminationSurface(sphere);
  field->DomainFacesOn();
  field->Update();
  vtkDataSet* samples = vtkDataSet::SafeDownCast(field->GetOutput());
  vtkNew<vtkFlowVolume> volume;
  volume->SetInputData(samples);
  volume->Update();
  const auto distance = [](const double* x) { return vtkMath::Norm(x) - 0.55; };
  const vtkIdType expected = CountCells(samples,
    [&](const std::vector<Vector>& corners)
    {
      const auto isInside = [&](const Vector& x) { return distance(x.data()) < 0.0; };
      const auto inside = std::count_if(corners.begin(), corners.end(), isInside);
      return inside > 0 && inside < static_cast<std::ptrdiff_t>(corners.size());
    });
  check.Equal(
    volume->GetReport()->GetCount("CellsAcrossSurfaces"), expected, "cells across the surface");
  check.That(expected > 200, "some cells are across the surface");
  // The tolerance allows for the fourth-order error of cut edges in cells of width 0.07.
  check.Equal(CountAcross(volume->GetOutput(), distance, 1e-4), 0, "no cell crosses");
  for (vtkIdType id = 0; id < samples->GetNumberOfPoints(); ++id)
  {
    double x[3];
    samples->GetPoint(id, x);
    const bool isOfSphere =
      samples->GetPointData()->GetArray("TerminationId")->GetComponent(id, 0) == 0;
    check.That(GetSide(samples, id) == 0 || isOfSphere, "domain faces have no sides");
  }
}

/// Two blocks with flow away from the plane between them: time is 0 at the plane on both sides.
void TestSource(Check& check)
{
  check.SetContext("source");
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> vectors;
  vectors->SetName("Vectors");
  vectors->SetNumberOfComponents(3);
  vtkNew<vtkUnstructuredGrid> grid;
  for (const double way : { -1.0, 1.0 })
  {
    vtkIdType ids[8];
    for (int corner = 0; corner < 8; ++corner)
    {
      const double height = std::min(way, 0.0) + (corner >> 2);
      ids[corner] = points->InsertNextPoint(corner & 1, (corner >> 1) & 1, height);
      vectors->InsertNextTuple3(0.0, 0.0, way);
    }
    grid->InsertNextCell(VTK_VOXEL, 8, ids);
  }
  grid->SetPoints(points);
  grid->GetPointData()->SetVectors(vectors);
  vtkNew<vtkImplicitFlowField> field;
  field->SetInputData(grid);
  field->SetSampleMode(vtkImplicitFlowField::SAMPLES_OF_IMAGE);
  field->SetSampleDimensions(6, 6, 20);
  field->AddTerminationSurface(MakePlane(-1, -1, 0, { { 3, 0, 0 } }, { { 0, 3, 0 } }));
  vtkNew<vtkFlowVolume> volume;
  volume->SetInputConnection(field->GetOutputPort());
  volume->SetTimeRange(0.2, 0.6);
  check.That(UpdateAndGetErrors(volume).empty(), "no messages");
  check.Equal(volume->GetReport()->GetCount("CellsAcrossSurfaces"), 0, "no cell is omitted");
  check.Near(MeasureVolume(volume->GetOutput()), 0.8, 1e-6, "volume");
  vtkIdType sided = 0;
  vtkDataSet* samples = vtkDataSet::SafeDownCast(field->GetOutput());
  for (vtkIdType id = 0; id < samples->GetNumberOfPoints(); ++id)
  {
    sided += GetSide(samples, id) != 0 ? 1 : 0;
  }
  check.Equal(sided, 72, "sides of the layers at the plane");
}

void TestBadArray(Check& check)
{
  check.SetContext("array with an invalid number of components");
  auto image = MakeFlowImage({ { 4, 4, 4 } }, { { 0, 1, 0, 1, 0, 1 } });
  AddFlow(image, UniformFlow(1.0), { { { 0, 0, 0 } } });
  vtkNew<vtkFloatArray> sides;
  sides->SetName("TerminationSide");
  sides->SetNumberOfComponents(2);
  sides->SetNumberOfTuples(image->GetNumberOfPoints());
  sides->Fill(0.0);
  image->GetPointData()->AddArray(sides);
  vtkNew<vtkFlowVolume> volume;
  volume->SetInputData(image);
  const std::string message = UpdateAndGetErrors(volume);
  check.Contains(message, "\"TerminationSide\" has 2 components");
  check.Equal(volume->GetOutput()->GetNumberOfCells(), 0, "nothing");
}

}

int TestFlowVolumeReturns(int, char*[])
{
  return RunChecks({ TestRotation, TestMesh, TestOneId, TestSphere, TestSource, TestBadArray });
}
