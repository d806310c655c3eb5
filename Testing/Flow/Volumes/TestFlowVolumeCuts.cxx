// SPDX-License-Identifier: BSD-3-Clause
// Flow volume cells cut at termination surfaces: volumes next to planes and spheres compared with
// formulas, for streamlines that end at the surface and for streamlines that return. Times and
// parameters extend up to the surface, and cut cells match adjacent cells.
#include "Support/AnalyticFlows/ReferenceFlowResults.h"
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceThreads.h"
#include "Support/Flow/ReferenceFlowGrid.h"
#include "Support/Flow/ReferenceFlowVolume.h"

#include "vtkFlowVolume.h"
#include "vtkImplicitFlowField.h"
#include "vtkInflowMapping.h"
#include "vtkTerminationPlane.h"
#include "vtkTerminationSphere.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iostream>
#include <map>

namespace
{

using namespace reference;

constexpr double Pi = 3.14159265358979323846;

struct Case
{
  VectorField Field;
  vtkSmartPointer<vtkTerminationSurface> Surface;
  bool IsForward = false;
};

/// Returns the implicit flow field of a case, with \a points samples along each axis of [-1,1]^3.
vtkSmartPointer<vtkDataSet> MakeSamples(const Case& one, int points = 33)
{
  auto image = MakeFlowImage({ { points, points, points } }, { { -1, 1, -1, 1, -1, 1 } });
  AddVectors(image, one.Field);
  vtkNew<vtkImplicitFlowField> field;
  field->SetInputData(image);
  field->SetSampleMode(vtkImplicitFlowField::SAMPLES_OF_FIELD);
  field->AddTerminationSurface(one.Surface);
  field->SetDirection(one.IsForward);
  field->Update();
  return vtkDataSet::SafeDownCast(field->GetOutputDataObject(0));
}

const Vector Center{ { 0.013, -0.021, 0.017 } };

vtkSmartPointer<vtkTerminationSphere> MakeSphere(double radius)
{
  auto sphere = vtkSmartPointer<vtkTerminationSphere>::New();
  sphere->SetCenter(Center[0], Center[1], Center[2]);
  sphere->SetRadius(radius);
  return sphere;
}

Vector Along(const Vector&)
{
  return { { 1, 0, 0 } };
}
Vector Outward(const Vector& x)
{
  return { { x[0] - Center[0], x[1] - Center[1], x[2] - Center[2] } };
}

void TestVolumes(Check& check)
{
  constexpr double radius = 0.27;
  const double ball = 4.0 / 3.0 * Pi * std::pow(radius, 3);
  const auto isInSphere = [](const double* x)
  { return std::sqrt(vtkMath::Distance2BetweenPoints(x, Center.data())) < radius; };
  const auto everywhere = [](const double*) { return true; };
  struct
  {
    const char* Name;
    Case One;
    std::function<bool(const double*)> IsInside;
    double Exact;
  } const cases[] = {
    { "plane between layers", { Along, MakeWidePlane(0.53), false }, everywhere, 4 * 0.47 },
    { "sphere of outward flow", { Outward, MakeSphere(radius), true }, everywhere, ball },
    { "sphere in uniform flow", { Along, MakeSphere(radius), false }, isInSphere, ball },
    { "sphere of a source", { Outward, MakeSphere(radius), false }, everywhere, 8 - ball },
  };
  for (const auto& one : cases)
  {
    check.SetContext(one.Name);
    const auto samples = MakeSamples(one.One);
    const double found = MeasureVolumeIn(ExtractFlow(samples), one.IsInside);
    const double before = MeasureVolumeIn(ExtractUncutFlow(samples), one.IsInside);
    std::cout << one.Name << ": " << 100.0 * (before / one.Exact - 1.0) << " % before, "
              << 100.0 * (found / one.Exact - 1.0) << " %\n";
    check.Near(found, one.Exact, 0.02, "volume");
  }
}

/// Cells crossed only by a termination surface are not refined. Cells at the boundary of the wake
/// of a sphere are refined.
void TestRefinement(Check& check)
{
  check.SetContext("refinement");
  auto image = MakeFlowImage({ { 9, 9, 9 } }, { { -1, 1, -1, 1, -1, 1 } });
  AddVectors(image, Along);
  vtkNew<vtkImplicitFlowField> field;
  field->SetInputData(image);
  field->AddTerminationSurface(MakeWidePlane(0.1));
  field->SetRefinementLevels(1);
  field->Update();
  check.Equal(field->GetReport()->GetCount("RefinedCells", 0), 0, "cells next to a plane");
  field->RemoveAllTerminationSurfaces();
  field->AddTerminationSurface(MakeSphere(0.6));
  field->Update();
  const vtkIdType refined = field->GetReport()->GetNumber("RefinedCells", 0);
  check.That(
    refined > 50 && refined < 200, "cells at the boundary of the wake: " + std::to_string(refined));
}

/// In oblique flow, parameters and times are correct up to the plane, with intervals of Inflow and
/// a time range. Tetrahedra match at faces, including those between cut cells and other cells, and
/// end at the plane.
void TestOblique(Check& check)
{
  check.SetContext("oblique");
  constexpr double position = -0.47;
  const auto samples = MakeSamples({ [](const Vector&) {
                                      return Vector{ { 1, 0.3, 0.2 } };
                                    },
                                     MakeWidePlane(position), false },
    12);
  vtkNew<vtkInflowMapping> mapping;
  mapping->SetInputData(samples);
  mapping->SetFormula(vtkInflowMapping::ALL, "10*u-5");
  vtkNew<vtkFlowVolume> volume;
  volume->SetInputConnection(mapping->GetOutputPort());
  volume->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  volume->SetInterval(0, -0.7, -0.1);
  volume->SetInterval(1, -0.1, 0.6);
  volume->SetTimeRange(0.0, 1.2);
  volume->SetTimeSurface(0, 0.05);
  volume->GenerateStreamSurfacesOn();
  volume->GenerateTimeSurfacesOn();
  volume->Update();
  check.That(volume->GetReport()->GetNumber("CellsCut") > 50, "some cells are cut");
  for (int port = 0; port < 3; ++port)
  {
    vtkUnstructuredGrid* mesh =
      vtkUnstructuredGrid::SafeDownCast(volume->GetOutputDataObject(port));
    check.That(mesh->GetNumberOfCells() > 0, "the output is not empty");
    check.That(mesh->GetFieldData()->GetArray("BeyondSampleId") == nullptr, "number of samples");
  }
  vtkUnstructuredGrid* mesh = volume->GetOutput();
  vtkPointData* data = mesh->GetPointData();
  vtkNew<vtkIdList> used;
  std::map<std::array<vtkIdType, 3>, int> faces;
  double range[2] = { 1.0, -1.0 };
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    mesh->GetCellPoints(cell, used);
    for (int out = 0; out < 4; ++out)
    {
      std::array<vtkIdType, 3> face{};
      for (int i = 0, next = 0; i < 4; ++i)
      {
        if (i != out)
        {
          face[static_cast<std::size_t>(next++)] = used->GetId(i);
        }
      }
      std::sort(face.begin(), face.end());
      ++faces[face];
    }
    for (const vtkIdType p : *used)
    {
      double x[3];
      mesh->GetPoint(p, x);
      range[0] = std::min(range[0], x[0]);
      range[1] = std::max(range[1], x[0]);
      const double time = x[0] - position;
      check.Near(data->GetArray("AdvectionTime")->GetComponent(p, 0), time, 1e-6, "time", 1.0);
      // Near the sides of the domain, streamlines leave the domain before they reach the plane.
      if (std::max(std::abs(x[1]), std::abs(x[2])) < 0.8)
      {
        check.Near(data->GetArray("TerminationUV")->GetComponent(p, 0),
          (x[1] - 0.3 * time + 5.0) / 10.0, 1e-6, "u", 1.0);
        check.Near(
          data->GetArray("Inflow")->GetComponent(p, 0), x[1] - 0.3 * time, 1e-6, "inflow", 1.0);
      }
    }
  }
  check.Near(range[0], position, 1e-9, "the volume extends to the plane");
  check.Near(range[1], position + 1.2, 1e-6, "the volume extends to the time limit");
  const auto isAt = [&](const std::array<vtkIdType, 3>& face, auto&& value, double level)
  {
    return std::all_of(
      face.begin(), face.end(), [&](vtkIdType p) { return std::abs(value(p) - level) < 1e-6; });
  };
  for (const auto& face : faces)
  {
    const auto position3 = [&](int axis)
    { return [mesh, axis](vtkIdType p) { return mesh->GetPoint(p)[axis]; }; };
    const auto inflow = [&](vtkIdType p) { return data->GetArray("Inflow")->GetComponent(p, 0); };
    // Cells whose streamlines leave through the sides are omitted, so that faces between layers of
    // samples may be boundaries.
    const auto layer = [&](vtkIdType p)
    { return std::remainder(mesh->GetPoint(p)[2] + 1.0, 2.0 / 11.0); };
    const auto layerY = [&](vtkIdType p)
    { return std::remainder(mesh->GetPoint(p)[1] + 1.0, 2.0 / 11.0); };
    const auto layerX = [&](vtkIdType p)
    { return std::remainder(mesh->GetPoint(p)[0] + 1.0, 2.0 / 11.0); };
    const bool isEnd = isAt(face.first, position3(0), position) ||
      isAt(face.first, position3(0), position + 1.2) || isAt(face.first, inflow, -0.7) ||
      isAt(face.first, inflow, 0.6) || isAt(face.first, layer, 0.0) ||
      isAt(face.first, layerY, 0.0) || isAt(face.first, layerX, 0.0);
    check.That(
      face.second == 2 || isEnd, "a face is shared by two tetrahedra or lies on a boundary");
  }
}

/// Rotating flow: time increases from 0 on one side of the half-plane to the period on the other.
void TestReturning(Check& check)
{
  check.SetContext("returning");
  auto plane = vtkSmartPointer<vtkTerminationPlane>::New();
  plane->SetOrigin(0, 0, -2);
  plane->SetPoint1(3, 0, -2);
  plane->SetPoint2(0, 0, 2);
  const auto rotation = [](const Vector& x) { return Vector{ { -x[1], x[0], 0.0 } }; };
  const auto samples = MakeSamples({ rotation, plane, false }, 16);
  const auto full = ExtractFlow(samples);
  vtkUnstructuredGrid* mesh = full;
  double times[2] = { 10.0, -1.0 };
  for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
  {
    double x[3];
    mesh->GetPoint(p, x);
    const double time = mesh->GetPointData()->GetArray("AdvectionTime")->GetComponent(p, 0);
    check.Near(std::remainder(time - std::atan2(x[1], x[0]), 2.0 * Pi), 0.0, 1e-4, "time", 1.0);
    times[0] = std::min(times[0], time);
    times[1] = std::max(times[1], time);
  }
  check.Near(times[0], 0.0, 1e-12, "minimum time at the surface", 1.0);
  check.Near(times[1], 2.0 * Pi, 1e-5, "maximum time at the surface", 1.0);
  const auto isRight = [](const double* x)
  { return x[0] > 0.2 && x[0] < 0.8 && std::abs(x[1]) < 0.4; };
  check.Near(MeasureVolumeIn(full, isRight), 2.0 * 0.6 * 0.8, 0.1, "no gap next to the surface");
  check.That(
    MeasureVolumeIn(ExtractUncutFlow(samples), isRight) < 0.9 * MeasureVolumeIn(full, isRight),
    "a gap without cutting");
}

void TestThreads(Check& check)
{
  check.SetContext("threads");
  CheckThreads(
    "cut",
    []()
    {
      auto copy = vtkSmartPointer<vtkUnstructuredGrid>::New();
      copy->ShallowCopy(ExtractFlow(MakeSamples({ Along, MakeSphere(0.5), false }, 14)));
      return std::vector<vtkSmartPointer<vtkUnstructuredGrid>>{ copy };
    },
    check);
}
}

int TestFlowVolumeCuts(int, char*[])
{
  return RunChecks({ TestVolumes, TestRefinement, TestOblique, TestReturning, TestThreads });
}
