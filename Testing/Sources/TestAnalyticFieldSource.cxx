// SPDX-License-Identifier: BSD-3-Clause
// Each field compared with an independent implementation of its formula, regions of known volume,
// and the documented number of vortex tetrahedra and tubes.
#include "Support/Arrays/ReferenceVector.h"
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Intervals/ReferenceExtraction.h"
#include "Support/Meshes/ReferenceField.h"
#include "Support/Meshes/ReferenceVolume.h"

#include "vtkAnalyticFieldSource.h"
#include "vtkConnectivityFilter.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkMinimalStandardRandomSequence.h"
#include "vtkNew.h"
#include "vtkUnstructuredGrid.h"

#include <array>
#include <cmath>
#include <vector>

namespace
{

using namespace reference;
using Vector = std::array<double, 3>;

const double Pi = std::acos(-1.0);

double EvaluateElementary(int field, const Vector& x, double t)
{
  const Vector moved = x - Vector{ { 0.3, -0.2, 0.1 } } - t * Vector{ { 0.2, 0.4, -0.3 } };
  const Vector a = 2.0 * Pi * moved;
  switch (field)
  {
    case vtkAnalyticFieldSource::WAVE:
      return x[2] - 0.4 * std::cos(Pi * x[0] + Pi / 4.0 * x[1] - Pi / 2.0 * t);
    case vtkAnalyticFieldSource::LINEAR:
      return -0.5 + 2.0 * x[0] - 3.0 * x[1] + 0.25 * x[2] + 1.5 * t;
    case vtkAnalyticFieldSource::SPHERE_DISTANCE:
      return GetNorm(moved) - 0.7 + 0.2 * t;
    default:
      return std::sin(a[0]) * std::cos(a[1]) + std::sin(a[1]) * std::cos(a[2]) +
        std::sin(a[2]) * std::cos(a[0]);
  }
}

void CheckElementary(Check& check)
{
  vtkNew<vtkAnalyticFieldSource> source;
  source->SetConstant(-0.5);
  source->SetGradient(2.0, -3.0, 0.25);
  source->SetRate(1.5);
  source->SetCenter(0.3, -0.2, 0.1);
  source->SetVelocity(0.2, 0.4, -0.3);
  source->SetRadius(0.7);
  source->SetGrowth(-0.2);
  vtkNew<vtkMinimalStandardRandomSequence> random;
  for (int field : { vtkAnalyticFieldSource::WAVE, vtkAnalyticFieldSource::LINEAR,
         vtkAnalyticFieldSource::SPHERE_DISTANCE, vtkAnalyticFieldSource::GYROID })
  {
    source->SetField(field);
    check.SetContext(vtkAnalyticFieldSource::GetFieldName(field));
    for (int i = 0; i < 100; ++i)
    {
      double values[4];
      for (double& value : values)
      {
        value = random->GetNextRangeValue(-2.0, 2.0);
      }
      check.Near(source->Evaluate(values, values[3]),
        EvaluateElementary(field, { { values[0], values[1], values[2] } }, values[3]), 1e-13,
        "value", 1.0);
    }
  }
}

// Parameters of a vortex tube, as in VortexTubes.cxx.
struct Tube
{
  Vector Center, Velocity, Along;
  double HalfLength, Radius, Bend, WaveNumber, Phase, PhaseSpeed, PeakTime, LifeTime;
};

struct TubeAtTime
{
  TubeAtTime(const Tube& tube, double t)
    : Constants(tube)
    , Time(t)
    , E0((1.0 / GetNorm(tube.Along)) * tube.Along)
  {
    vtkMath::Perpendiculars(this->E0.data(), this->E1.data(), this->E2.data(), 0.0);
  }

  Vector GetAxis(double s) const
  {
    const Tube& c = this->Constants;
    const double angle = c.WaveNumber * s + c.Phase + c.PhaseSpeed * this->Time;
    return c.Center + this->Time * c.Velocity + s * this->E0 + c.Bend * std::sin(angle) * this->E1 +
      0.5 * c.Bend * std::cos(1.6 * angle) * this->E2;
  }

  // Evaluates the tube at \a offset from the axis point with parameter \a s. The offset is
  // perpendicular to the straight axis.
  double Evaluate(double s, const Vector& offset) const
  {
    const Tube& c = this->Constants;
    const double step = 1e-5;
    const Vector tangent = this->GetAxis(s + step) - this->GetAxis(s - step);
    const double distance = GetNorm(Cross(offset, tangent)) / GetNorm(tangent);
    return std::exp(-std::pow((this->Time - c.PeakTime) / c.LifeTime, 2) -
      std::pow(distance / c.Radius, 2) - std::pow(s / c.HalfLength, 4));
  }

  Tube Constants;
  double Time;
  Vector E0, E1, E2;
};

// Close to a tube, the contributions of the other tubes are negligible.
void CheckVortices(Check& check)
{
  const std::array<Tube, 3> tubes = { { { { { -0.55, -0.5, 0.45 } }, { { 0.068, 0.022, -0.015 } },
                                          { { 1.0, 0.5, 0.2 } }, 0.42, 0.052, 0.1, 5.0, 0.3, 0.35,
                                          1.0, 9.0 },
    { { { -0.7, 0.05, -0.05 } }, { { 0.03, 0.053, 0.03 } }, { { -0.2, 0.9, 0.7 } }, 0.34, 0.052,
      0.08, 6.0, 1.3, 0.3, 2.2, 1.3 },
    { { { -0.5, 0.62, 0.55 } }, { { 0.03, -0.038, 0.038 } }, { { 0.8, 1.0, -0.5 } }, 0.34, 0.05,
      0.08, 5.5, 4.4, -0.3, 0.0, 1.1 } } };
  vtkNew<vtkAnalyticFieldSource> source;
  for (const Tube& constants : tubes)
  {
    for (double t : { 0.0, 0.4, 1.0 })
    {
      const TubeAtTime tube(constants, t);
      check.SetContext(
        "tube at " + std::to_string(constants.Center[0]) + ", time " + std::to_string(t));
      for (double s : { -0.2, -0.1, 0.0, 0.15 })
      {
        for (double turn : { 0.0, 1.0, 2.5, 4.0 })
        {
          const Vector offset = 0.03 * std::cos(turn) * tube.E1 + 0.03 * std::sin(turn) * tube.E2;
          const Vector x = tube.GetAxis(s) + offset;
          check.Near(source->Evaluate(x.data(), t), tube.Evaluate(s, offset), 1e-7, "value", 1.0);
        }
      }
    }
  }
}

vtkSmartPointer<vtkUnstructuredGrid> Extract(
  vtkAnalyticFieldSource* source, double t, double lower, double upper)
{
  source->UpdateTimeStep(t);
  return ExtractIntervals(source->GetOutput(), { { lower, upper } }).Volume;
}

double GetVolume(vtkAnalyticFieldSource* source, double t, double lower, double upper)
{
  return static_cast<double>(MeasureTetrahedra(Extract(source, t, lower, upper)).Sum);
}

void CheckVolumes(Check& check)
{
  vtkNew<vtkAnalyticFieldSource> source;
  source->SetOutputScalarType(VTK_DOUBLE);

  check.SetContext("ball");
  source->SetFieldToSphereDistance();
  const double shell = 4.0 / 3.0 * Pi * (std::pow(0.55, 3) - std::pow(0.4, 3));
  std::vector<double> errors;
  for (int points : { 21, 41, 81 })
  {
    source->SetDimensions(points, points, points);
    errors.push_back(std::fabs(GetVolume(source, 1.0, -0.1, 0.05) - shell));
  }
  check.Near(errors[2], 0.0, 1e-3, "error of the shell's volume", shell);
  check.That(errors[0] > 3.0 * errors[1] && errors[1] > 3.0 * errors[2],
    "the error decreases with the square of the spacing");

  check.SetContext("linear");
  source->SetFieldToLinear();
  source->SetConstant(0.3);
  source->SetGradient(1.0, 0.5, 0.25);
  source->SetRate(-0.4);
  source->SetDimensions(9, 8, 7);
  source->SetBounds(0.0, 1.0, 0.0, 2.0, 0.0, 1.5);
  const std::array<double, 3> size = { { 1.0, 2.0, 1.5 } };
  const LinearFunction function = { 0.3 - 0.4 * 0.5, { { 1.0, 0.5, 0.25 } } };
  const long double slab =
    BoxVolumeBelow(size, function, 1.25) - BoxVolumeBelow(size, function, 0.75);
  check.Near(GetVolume(source, 0.5, 0.75, 1.25), static_cast<double>(slab), 1e-12, "volume");

  check.SetContext("gyroid");
  source->SetFieldToGyroid();
  source->SetBounds(0.0, 1.0, 0.0, 1.0, 0.0, 1.0);
  source->SetDimensions(41, 41, 41);
  check.Near(GetVolume(source, 0.3, -2.0, 0.0), 0.5, 1e-3, "volume of one half");

  check.SetContext("wave");
  source->SetFieldToWave();
  source->SetBounds(-2.0, 2.0, -1.0, 1.0, -1.0, 1.0);
  source->SetDimensions(40, 20, 20);
  check.Near(GetVolume(source, 0.0, -0.15, 0.15), 2.4, 1e-3, "volume of the sheet");
}

// Checks that extent and bounds determine the point coordinates.
void CheckGrid(Check& check)
{
  check.SetContext("lattice");
  vtkNew<vtkAnalyticFieldSource> source;
  source->SetWholeExtent(-2, 6, 1, 5, 7, 7);
  source->SetBounds(1.0, 3.0, -1.0, 0.0, 4.0, 9.0);
  source->Update();
  double bounds[6];
  source->GetOutput()->GetBounds(bounds);
  const double expected[6] = { 1.0, 3.0, -1.0, 0.0, 4.0, 4.0 };
  for (int i = 0; i < 6; ++i)
  {
    check.Near(bounds[i], expected[i], 1e-14, "a bound", 1.0);
  }
  check.Equal(source->GetOutput()->GetNumberOfPoints(), 9 * 5, "points");
}

long long CountRegions(vtkUnstructuredGrid* grid)
{
  vtkNew<vtkConnectivityFilter> regions;
  regions->SetInputData(grid);
  regions->SetExtractionModeToAllRegions();
  regions->Update();
  return regions->GetNumberOfExtractedRegions();
}

void CheckVortexCounts(Check& check)
{
  check.SetContext("vortices");
  vtkNew<vtkAnalyticFieldSource> source;
  source->SetDimensions(128, 128, 128);
  const std::array<long long, 3> tetrahedra = { { 78000, 62000, 72000 } };
  // At time 2, two of the eight tubes touch.
  const std::array<long long, 3> regions = { { 9, 7, 7 } };
  for (int t = 0; t < 3; ++t)
  {
    const auto mesh = Extract(source, t, 0.5, 0.8);
    check.Near(static_cast<double>(mesh->GetNumberOfCells()), tetrahedra[t], 0.01,
      "tetrahedra at time " + std::to_string(t));
    check.Equal(CountRegions(mesh), regions[t], "tubes at time " + std::to_string(t));
  }
}

}

int TestAnalyticFieldSource(int, char*[])
{
  return RunChecks({ CheckElementary, CheckVortices, CheckVolumes, CheckGrid, CheckVortexCounts });
}
