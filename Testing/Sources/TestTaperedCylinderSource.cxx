// SPDX-License-Identifier: BSD-3-Clause
// Wake and grid compared with independent implementations of their formulas. Also tests the seam,
// the orientation of the cells and the documented number of tetrahedra.
#include "Support/Arrays/ReferenceIndices.h"
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Intervals/ReferenceExtraction.h"
#include "Support/TimeVarying/ReferenceTemporalSource.h"

#include "vtkMath.h"
#include "vtkMinimalStandardRandomSequence.h"
#include "vtkNew.h"
#include "vtkStructuredGrid.h"
#include "vtkTaperedCylinderSource.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>

namespace
{

using namespace reference;

const double Pi = std::acos(-1.0);

struct Wake
{
  double Bottom, Top, Height, Outer, Speed, Strouhal;

  double Diameter(double z) const
  {
    return 2.0 * (this->Bottom + (this->Top - this->Bottom) * z / this->Height);
  }

  // Sums the contributions of many vortices, except those that have not been shed yet or have
  // decayed.
  double DeficitOfCell(int cell, const double x[3], double t) const
  {
    const double f =
      this->Strouhal * this->Speed / this->Diameter((cell + 0.5) * this->Height / 3.0);
    const double d = this->Diameter(x[2]);
    const double u = 0.85 * this->Speed;
    const double life = this->Outer / u;
    double sum = 0.0;
    for (int n = -1000; n <= 1000; ++n)
    {
      const double age = t - (n + 2.2 * x[2] / this->Height) / (2.0 * f);
      if (age < 0.0 || age > life)
      {
        continue;
      }
      const double from[3] = { x[0] - d / 2.0 - u * age, x[1] - (n % 2 == 0 ? 0.5 : -0.5) * d,
        0.0 };
      const double line[3] = { -u * 2.2 / (2.0 * f * this->Height), 0.0, 1.0 };
      double normal[3];
      vtkMath::Cross(from, line, normal);
      const double distance = vtkMath::Norm(normal) / vtkMath::Norm(line);
      const double core = std::pow(0.55 * d, 2) + 4.0 * 0.008 * this->Speed * d * age;
      sum += 0.018 * (1.0 - std::exp(-age * this->Speed / (0.7 * d))) *
        (1.0 - std::pow(age / life, 2)) * std::exp(-distance * distance / core);
    }
    return sum;
  }

  double Density(const double x[3], double t) const
  {
    const auto step = [](double u) { return 1.0 / (1.0 + std::exp(-2.0 * u)); };
    const double p = x[2] / this->Height;
    const double lowest = 1.0 - step((p - 1.0 / 3.0) / 0.08);
    const double highest = step((p - 2.0 / 3.0) / 0.08);
    return 1.0 - lowest * this->DeficitOfCell(0, x, t) -
      (1.0 - lowest - highest) * this->DeficitOfCell(1, x, t) -
      highest * this->DeficitOfCell(2, x, t);
  }
};

void CheckWake(vtkTaperedCylinderSource* source, const Wake& wake, Check& check)
{
  vtkNew<vtkMinimalStandardRandomSequence> random;
  double least = 1.0;
  for (int i = 0; i < 300; ++i)
  {
    const double x[3] = { random->GetNextRangeValue(0.0, wake.Outer),
      random->GetNextRangeValue(-1.0, 1.0), random->GetNextRangeValue(0.0, wake.Height) };
    const double t = random->GetNextRangeValue(-20.0, 20.0);
    const double density = wake.Density(x, t);
    check.Near(source->Evaluate(x, t), density, 1e-12, "density");
    least = std::min(least, density);
  }
  check.That(least < 0.99, "some points are in vortices");
}

void CheckGrid(vtkTaperedCylinderSource* source, const Wake& wake, Check& check)
{
  source->SetOutputScalarType(VTK_DOUBLE);
  source->UpdateTimeStep(1.0);
  vtkStructuredGrid* grid = source->GetOutput();
  int n[3];
  grid->GetDimensions(n);
  for (const auto& [k, j] : AllIndices(n[2], n[1]))
  {
    for (int i = 0; i < n[0]; ++i)
    {
      double x[3];
      grid->GetPoint(i + n[0] * (j + n[1] * k), x);
      const double z = k * wake.Height / (n[2] - 1);
      const double wall = wake.Diameter(z) / 2.0;
      const double r =
        wall + (wake.Outer - wall) * (std::exp(2.0 * i / (n[0] - 1)) - 1.0) / (std::exp(2.0) - 1.0);
      const double around = 2.0 * Pi * j / (n[1] - 1);
      const double angle = around - Pi + 0.75 * std::sin(around);
      check.Near(x[0], r * std::cos(angle), 1e-12, "x", wake.Outer);
      check.Near(x[1], r * std::sin(angle), 1e-12, "y", wake.Outer);
      check.Near(x[2], z, 1e-13, "z", wake.Height);
    }
    double first[3];
    double last[3];
    grid->GetPoint(n[0] * n[1] * k + j % n[0], first);
    grid->GetPoint(n[0] * (n[1] * (k + 1) - 1) + j % n[0], last);
    check.That(std::equal(first, first + 3, last), "the points at the seam are bit-identical");
  }
  check.Equal(CountLeftHandedCells(grid), 0, "cells that are not right-handed");
}

void CheckTetrahedra(Check& check)
{
  check.SetContext("tetrahedra");
  vtkNew<vtkTaperedCylinderSource> source;
  for (double t : { 0.0, 1.0, 2.0 })
  {
    source->UpdateTimeStep(t);
    const Extraction found = ExtractIntervals(source->GetOutput(), { { 0.9934, 0.9944 } });
    check.Near(static_cast<double>(found.Volume->GetNumberOfCells()), 50000, 0.02,
      "tetrahedra at time " + std::to_string(t));
  }
}

}

int TestTaperedCylinderSource(int, char*[])
{
  Check check;
  vtkNew<vtkTaperedCylinderSource> source;
  check.SetContext("defaults");
  const Wake defaults = { 0.5, 0.3, 12.0, 9.0, 1.0, 0.2 };
  CheckWake(source, defaults, check);
  CheckGrid(source, defaults, check);
  check.SetContext("other settings yield other values");
  const Wake other = { 0.2, 0.4, 5.0, 6.0, 2.5, 0.15 };
  source->SetRadii(other.Bottom, other.Top);
  source->SetHeight(other.Height);
  source->SetOuterRadius(other.Outer);
  source->SetSpeed(other.Speed);
  source->SetStrouhalNumber(other.Strouhal);
  source->SetDimensions(12, 15, 7);
  CheckWake(source, other, check);
  CheckGrid(source, other, check);
  CheckTetrahedra(check);
  return check.Result();
}
