// SPDX-License-Identifier: BSD-3-Clause
// Stream volumes, stream surfaces and time surfaces of flows with known streamlines: volumes, areas
// and fluxes compared with formulas. Errors converge with second order on every kind of grid.
#include "Support/AnalyticFlows/ReferenceFlowResults.h"
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Meshes/ReferenceGrid.h"
#include "Support/Meshes/ReferenceLattice.h"

#include "vtkFlowVolume.h"
#include "vtkImageData.h"
#include "vtkInflowMapping.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>
#include <functional>

namespace
{

using namespace reference;

const double Pi = vtkMath::Pi();

// A pipeline of a mapping and a flow volume.
struct Pipeline
{
  vtkNew<vtkInflowMapping> Mapping;
  vtkNew<vtkFlowVolume> Volume;

  Pipeline(vtkDataSet* data, const char* formula)
  {
    this->Mapping->SetInputData(data);
    this->Mapping->SetFormula(vtkInflowMapping::ALL, formula);
    this->Volume->SetInputConnection(this->Mapping->GetOutputPort());
    this->Volume->GenerateStreamSurfacesOn();
    this->Volume->GenerateTimeSurfacesOn();
    this->Volume->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  }

  vtkUnstructuredGrid* Update(int port = 0)
  {
    this->Volume->Update();
    return this->Volume->GetOutput(port);
  }
};

// Checks that the relative error of \a measure is at most \a bound, and about four times smaller
// at twice the resolution.
void CheckOrder(const std::function<double(int)>& measure, int resolution, double expected,
  double bound, const std::string& what, Check& check)
{
  const double coarse = std::abs(measure(resolution) - expected) / expected;
  const double fine = std::abs(measure(2 * resolution) - expected) / expected;
  check.That(coarse <= bound, what + " error " + std::to_string(coarse));
  check.That(fine <= 0.3 * coarse + 1e-12,
    what + " decreases from " + std::to_string(coarse) + " to " + std::to_string(fine));
}

vtkSmartPointer<vtkImageData> MakeUniform(int points)
{
  // Samples upstream of the plane have no result.
  auto image = MakeFlowImage(
    { { points + 1, points, points } }, { { -1.0 / (points - 1), 1.0, 0.0, 1.0, 0.0, 1.0 } });
  AddFlow(image, UniformFlow(0.5), { { { 0, 0, 0 } } });
  return image;
}

// The cylinder of streamlines through a circle. The times 0.4 to 1.5 correspond to x = 0.2 to 0.75.
void CheckUniform(Check& check)
{
  check.SetContext("uniform flow");
  const double radius = 0.35;
  const auto make = [&](int points)
  {
    auto pipeline = std::make_unique<Pipeline>(MakeUniform(points), "(u-0.5)^2+(v-0.5)^2");
    pipeline->Volume->SetInterval(0, -1.0, radius * radius);
    pipeline->Volume->SetTimeRange(0.4, 1.5);
    return pipeline;
  };
  const double length = 0.55;
  CheckOrder([&](int n) { return MeasureVolume(make(n)->Update()); }, 12,
    Pi * radius * radius * length, 0.03, "volume", check);
  CheckOrder([&](int n) { return MeasureArea(make(n)->Update(1), "StreamSurfaceId", 1); }, 12,
    2.0 * Pi * radius * length, 0.02, "stream surface", check);
  for (int time : { 0, 1 })
  {
    CheckOrder([&](int n) { return MeasureArea(make(n)->Update(2), "TimeSurfaceId", time); }, 12,
      Pi * radius * radius, 0.03, "time surface", check);
  }
  // Without a time range, the volume extends from the plane to the end of the grid.
  auto full = make(24);
  full->Volume->SetTimeRange(0.0, VTK_DOUBLE_MAX);
  check.Near(MeasureVolume(full->Update()), Pi * radius * radius, 0.01, "full length");
  // The volume is proportional to the length of the time range.
  const double perTime = MeasureVolume(full->Update()) * 0.5;
  for (int step = 1; step <= 5; ++step)
  {
    full->Volume->SetTimeRange(0.0, 0.37 * step);
    check.Near(MeasureVolume(full->Update()), 0.37 * step * perTime, 1e-9, "growth per time");
    check.Equal(full->Volume->GetReport()->GetCount("InflowPasses"), 0, "no additional pass");
  }
}

void CheckForms(Check& check)
{
  std::vector<GeometricSimplex> expected[3];
  for (const DataSetVariant& form : FormsOf(MakeUniform(9)))
  {
    check.SetContext(form.Name);
    AddFlow(form.Data, UniformFlow(0.5), { { { 0, 0, 0 } } });
    Pipeline pipeline(form.Data, "u^2+0.8*v+0.1*u*v");
    pipeline.Volume->SetInterval(0, 0.21, 0.53);
    pipeline.Volume->SetInterval(1, 0.6, 0.9);
    pipeline.Volume->SetStreamSurface(0, 0.43);
    pipeline.Volume->SetTimeRange(0.1, 1.7);
    pipeline.Volume->SetTimeSurface(0, 0.77);
    const char* const ids[3] = { "IntervalId", "StreamSurfaceId", "TimeSurfaceId" };
    for (int port = 0; port < 3; ++port)
    {
      auto found = GeometricSet(pipeline.Update(port), { ids[port] });
      check.That(!found.empty(), "the output is not empty");
      if (expected[port].empty())
      {
        expected[port] = found;
      }
      check.That(found == expected[port],
        "port " + std::to_string(port) + " equals the output for the image");
    }
  }
}

// A spherical shell between two cones of constant polar angle.
void CheckSphere(Check& check)
{
  check.SetContext("source and sphere");
  const auto make = [&](int n)
  {
    auto image = MakeFlowImage({ { n, n, n } }, { { -1, 1, -1, 1, -1, 1 } });
    AddFlow(image, SphereFlow(0.2), { { { 0, 1, 0 } } });
    auto pipeline = std::make_unique<Pipeline>(image, "v");
    pipeline->Volume->SetInterval(0, 0.3, 0.55);
    pipeline->Volume->SetTimeRange(0.2, 0.7);
    pipeline->Volume->SetTimeSurface(0, 0.5);
    return pipeline;
  };
  const double cap = std::cos(0.3 * Pi) - std::cos(0.55 * Pi);
  CheckOrder([&](int n) { return MeasureVolume(make(n)->Update()); }, 22,
    2.0 * Pi / 3.0 * cap * (std::pow(0.9, 3) - std::pow(0.4, 3)), 0.02, "volume", check);
  CheckOrder([&](int n) { return MeasureArea(make(n)->Update(2), "TimeSurfaceId", 1); }, 22,
    2.0 * Pi * cap * 0.49, 0.02, "time surface", check);
  CheckOrder([&](int n) { return MeasureArea(make(n)->Update(1), "StreamSurfaceId", 0); }, 22,
    Pi * std::sin(0.3 * Pi) * (0.81 - 0.16), 0.02, "cone", check);
  // A full spherical shell, without a mapping.
  auto image = MakeFlowImage({ { 44, 44, 44 } }, { { -1, 1, -1, 1, -1, 1 } });
  AddFlow(image, SphereFlow(0.2), { { { 0, 1, 0 } } });
  vtkNew<vtkFlowVolume> shell;
  shell->SetInputData(image);
  shell->SetTimeRange(0.3, 0.6);
  shell->Update();
  check.Near(MeasureVolume(shell->GetOutput()),
    4.0 / 3.0 * Pi * (std::pow(0.8, 3) - std::pow(0.5, 3)), 0.01, "shell");
  check.That(
    shell->GetReport()->GetNumber("CellsAroundPoles") > 0, "cells around the poles are counted");
}

// A quarter of a ring in a rotating flow.
void CheckRotation(Check& check)
{
  check.SetContext("rotation");
  const auto make = [&](int n)
  {
    auto image = MakeFlowImage({ { n, n, 4 } }, { { -1, 1, 0.05, 1, 0, 1 } });
    AddFlow(image, RotationFlow(), { { { 0, 0, 0 } } });
    auto pipeline = std::make_unique<Pipeline>(image, "u");
    pipeline->Volume->SetInterval(0, 0.5, 0.8);
    pipeline->Volume->SetTimeRange(0.25 * Pi, 0.75 * Pi);
    return pipeline;
  };
  CheckOrder([&](int n) { return MeasureVolume(make(n)->Update()); }, 16, 0.25 * Pi * (0.64 - 0.25),
    0.02, "volume", check);
  CheckOrder([&](int n) { return MeasureArea(make(n)->Update(1), "StreamSurfaceId", 1); }, 16,
    0.5 * Pi * 0.8, 0.02, "outer surface", check);
  CheckOrder([&](int n) { return MeasureArea(make(n)->Update(2), "TimeSurfaceId", 0); }, 16, 0.3,
    0.02, "time surface", check);
}

// In fields without divergence, the flux through all time surfaces of a stream volume is the same.
void CheckFlux(Check& check)
{
  check.SetContext("flux");
  struct
  {
    const char* Name;
    FlowResultFunction Flow;
    std::function<std::array<double, 3>(const double*)> Field;
    std::array<double, 6> Bounds;
    const char* Formula;
    double Upper;
  } const cases[] = { { "saddle", SaddleFlow(),
                        [](const double* x) {
                          return std::array<double, 3>{ { x[0], -x[1], 0.0 } };
                        },
                        { { -1, 1, 0.2, 1, 0, 1 } }, "u^2+0.3*(v-0.5)^2", 0.03 },
    { "shear",
      [](const double* x) -> FlowResult {
        return { 0, 0, x[1], x[2], x[0] / (1.0 + x[1] + 0.5 * x[2] * x[2]) };
      },
      [](const double* x) {
        return std::array<double, 3>{ { 1.0 + x[1] + 0.5 * x[2] * x[2], 0.0, 0.0 } };
      },
      { { 0, 2, 0, 1, 0, 1 } }, "(u-0.5)^2+(v-0.5)^2", 0.1 } };
  for (const auto& one : cases)
  {
    auto image = MakeFlowImage({ { 40, 40, 40 } }, one.Bounds);
    AddFlow(image, one.Flow, { { { 0, 0, 0 } }, { { 1, 0, 0 } } });
    Pipeline pipeline(image, one.Formula);
    pipeline.Volume->SetInterval(0, -1.0, one.Upper);
    for (int surface = 0; surface < 4; ++surface)
    {
      pipeline.Volume->SetTimeSurface(surface, 0.15 * (surface + 1));
    }
    const double first = MeasureFlux(pipeline.Update(2), one.Field, "TimeSurfaceId", 1);
    check.That(std::abs(first) > 0.1, std::string(one.Name) + " flows");
    for (int surface = 2; surface <= 4; ++surface)
    {
      check.Near(MeasureFlux(pipeline.Update(2), one.Field, "TimeSurfaceId", surface), first, 0.01,
        std::string(one.Name) + ", flux of surface " + std::to_string(surface));
    }
  }
}

}

int TestFlowVolumeShapes(int, char*[])
{
  return RunChecks({ CheckUniform, CheckForms, CheckSphere, CheckRotation, CheckFlux });
}
