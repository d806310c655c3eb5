// SPDX-License-Identifier: BSD-3-Clause
// Vortices and grid compared with independent implementations of their formulas. Also tests the
// orientation of the cells and the documented number of tetrahedra.
#include "Support/Arrays/ReferenceIndices.h"
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Intervals/ReferenceExtraction.h"
#include "Support/TimeVarying/ReferenceTemporalSource.h"

#include "vtkDeltaWingSource.h"
#include "vtkMath.h"
#include "vtkMinimalStandardRandomSequence.h"
#include "vtkNew.h"
#include "vtkStructuredGrid.h"
#include "vtkUnstructuredGrid.h"

#include <array>
#include <cmath>

namespace
{

using namespace reference;

const double Pi = std::acos(-1.0);

struct Wing
{
  double Sweep, Position, Amplitude, Frequency, Spiral;

  double HalfSpan(double x) const { return x / std::tan(this->Sweep * Pi / 180.0); }

  double Broken(int side, double x, double t) const
  {
    const double beyond =
      x - this->Position - side * this->Amplitude * std::sin(2.0 * Pi * this->Frequency * t);
    return 1.0 / (1.0 + std::exp(-2.0 * beyond / 0.06));
  }

  std::array<double, 3> Axis(int side, double x, double t) const
  {
    const double b = this->HalfSpan(x);
    const double breakdown =
      this->Position + side * this->Amplitude * std::sin(2.0 * Pi * this->Frequency * t);
    const double turn = 2.0 * Pi * ((x - breakdown) / 0.34 - this->Spiral * t);
    const double radius = 0.14 * b * this->Broken(side, x, t);
    return { { x, side * (0.62 * b + radius * std::cos(turn)),
      0.42 * b + radius * std::sin(turn) } };
  }

  double Loss(const double x[3], double t) const
  {
    double sum = 0.0;
    for (int side : { -1, 1 })
    {
      const std::array<double, 3> axis = this->Axis(side, x[0], t);
      const std::array<double, 3> before = this->Axis(side, x[0] - 1e-5, t);
      const std::array<double, 3> after = this->Axis(side, x[0] + 1e-5, t);
      double from[3];
      double tangent[3];
      for (int i = 0; i < 3; ++i)
      {
        from[i] = x[i] - axis[i];
        tangent[i] = after[i] - before[i];
      }
      double normal[3];
      vtkMath::Cross(from, tangent, normal);
      const double broken = this->Broken(side, x[0], t);
      const double core = 0.12 * this->HalfSpan(x[0]) * (1.0 + 0.4 * broken);
      sum += (1.0 - broken / 4.0) *
        std::exp(-std::pow(vtkMath::Norm(normal) / vtkMath::Norm(tangent) / core, 2));
    }
    return sum;
  }
};

void CheckLoss(vtkDeltaWingSource* source, const Wing& wing, Check& check)
{
  vtkNew<vtkMinimalStandardRandomSequence> random;
  int inside = 0;
  for (int i = 0; i < 600; ++i)
  {
    const double t = random->GetNextRangeValue(-5.0, 5.0);
    std::array<double, 3> x =
      wing.Axis(i % 2 == 0 ? 1 : -1, random->GetNextRangeValue(0.1, 1.2), t);
    const double reach = 0.2 * wing.HalfSpan(x[0]);
    x[1] += random->GetNextRangeValue(-reach, reach);
    x[2] += random->GetNextRangeValue(-reach, reach);
    const double loss = wing.Loss(x.data(), t);
    check.Near(source->Evaluate(x.data(), t), loss, 1e-6, "loss", 1.0);
    inside += loss > 0.4;
  }
  check.That(inside > 100, "some points are in vortices");
}

void CheckGrid(vtkDeltaWingSource* source, const Wing& wing, Check& check)
{
  source->SetOutputScalarType(VTK_DOUBLE);
  source->UpdateTimeStep(1.0);
  vtkStructuredGrid* grid = source->GetOutput();
  int n[3];
  grid->GetDimensions(n);
  vtkIdType point = 0;
  for (const auto& [k, j] : AllIndices(n[2], n[1]))
  {
    for (int i = 0; i < n[0]; ++i, ++point)
    {
      double x[3];
      grid->GetPoint(point, x);
      const double b = wing.HalfSpan(0.1 + 1.1 * i / (n[0] - 1));
      const double up = static_cast<double>(k) / (n[2] - 1);
      check.Near(x[0], 0.1 + 1.1 * i / (n[0] - 1), 1e-13, "x", 1.0);
      check.Near(x[1], 1.5 * b * (2.0 * j / (n[1] - 1) - 1.0), 1e-13, "y", 1.0);
      check.Near(x[2], 0.7 * b * (up + up * up), 1e-13, "z", 1.0);
    }
  }
  check.Equal(CountLeftHandedCells(grid), 0, "cells that are not right-handed");
}

void CheckTetrahedra(Check& check)
{
  check.SetContext("tetrahedra");
  vtkNew<vtkDeltaWingSource> source;
  for (double t : { 0.0, 1.0 })
  {
    source->UpdateTimeStep(t);
    const Extraction found = ExtractIntervals(source->GetOutput(), { { 0.4, 0.7 } });
    check.Near(static_cast<double>(found.Volume->GetNumberOfCells()), 180000, 0.02,
      "tetrahedra at time " + std::to_string(t));
  }
}

}

int TestDeltaWingSource(int, char*[])
{
  Check check;
  vtkNew<vtkDeltaWingSource> source;
  source->SetDimensions(23, 14, 9);
  check.SetContext("defaults");
  const Wing defaults = { 65.0, 0.55, 0.06, 0.2, 0.15 };
  CheckLoss(source, defaults, check);
  CheckGrid(source, defaults, check);
  check.SetContext("other settings yield other values");
  const Wing other = { 55.0, 0.4, 0.1, 0.35, 0.25 };
  source->SetSweepAngle(other.Sweep);
  source->SetBreakdownPosition(other.Position);
  source->SetBreakdownAmplitude(other.Amplitude);
  source->SetBreakdownFrequency(other.Frequency);
  source->SetSpiralFrequency(other.Spiral);
  CheckLoss(source, other, check);
  CheckGrid(source, other, check);
  CheckTetrahedra(check);
  return check.Result();
}
