// SPDX-License-Identifier: BSD-3-Clause
// Phase functions: normalization, moments compared with formulas, and errors.
#include "Support/Checks/ReferenceCheck.h"

#include "Scattering/PhaseFunction.h"

#include <cmath>
#include <limits>

namespace
{

using namespace reference;
using interlume::PhaseFunction;

constexpr double Pi = 3.14159265358979323846;

/// Integrates the phase function times a power of the cosine over all directions with a cosine
/// above \a lower. Steps are smaller near both ends of the interval.
double Integrate(const PhaseFunction& phase, int power, double lower = -1.0)
{
  constexpr int steps = 40000;
  double sum = 0.0;
  for (int i = 0; i < steps; ++i)
  {
    // The cosine is a smooth step of t with zero slope at both ends.
    const double t = (i + 0.5) / steps;
    const double smoothStep = t - std::sin(2.0 * Pi * t) / (2.0 * Pi);
    const double cosine = lower + (1.0 - lower) * smoothStep;
    const double width = (1.0 - lower) * (1.0 - std::cos(2.0 * Pi * t)) / steps;
    sum += 2.0 * Pi * width * phase.Value(cosine) * std::pow(cosine, power);
  }
  return sum;
}

void CheckFormula(Check& check)
{
  for (const double g : { -0.99, -0.5, 0.0, 0.3, 0.75, 0.9, 0.99 })
  {
    PhaseFunction phase;
    check.That(!phase.SetHenyeyGreenstein(g), "an anisotropy between -1 and 1 is accepted");
    check.SetContext("g = " + std::to_string(g) + ": ");
    check.Near(Integrate(phase, 0), 1.0, 1e-4, "integral over the sphere");
    check.Near(Integrate(phase, 1), g, 1e-4, "mean cosine", 1.0);
    check.Near(phase.Moment(1), g, 1e-12, "first moment", 1.0);
    check.Near(phase.Moment(2), g * g, 1e-12, "second moment", 1.0);
    check.Near(phase.ForwardFraction(), Integrate(phase, 0, 0.0), 1e-4, "forward fraction", 1.0);
    const double squares = Integrate(phase, 0, 0.0) - Integrate(phase, 2, 0.0);
    check.Near(phase.ForwardVariance(), 0.5 * squares / Integrate(phase, 0, 0.0), 1e-3,
      "variance of the forward angles");
  }
  check.SetContext("");
  check.Near(PhaseFunction().Value(0.3), 1.0 / (4.0 * Pi), 1e-12, "isotropic");
  check.Near(PhaseFunction().ForwardVariance(), 1.0 / 3.0, 1e-4, "variance of all angles");
}

void CheckTable(Check& check)
{
  PhaseFunction table;
  check.That(!table.SetTable({ 7.0, 7.0, 7.0 }), "a table is accepted");
  check.Near(table.Value(-0.7), 1.0 / (4.0 * Pi), 1e-12, "a constant table is isotropic");
  // The table describes p = (1 + cosine) / (4 pi).
  check.That(!table.SetTable({ 0.0, 1.0, 2.0 }), "a table may contain 0");
  check.Near(table.Value(0.5), 1.5 / (4.0 * Pi), 1e-12, "linear between values");
  check.Near(table.Moment(0), 1.0, 1e-12, "normalized");
  check.Near(table.Moment(1), 1.0 / 3.0, 1e-4, "mean cosine of a linear table");
  check.Near(table.Moment(2), 0.0, 1e-4, "second moment of a linear table", 1.0);
  check.Near(table.ForwardFraction(), 0.75, 1e-4, "forward fraction of a linear table");
  PhaseFunction fine;
  std::vector<double> values;
  PhaseFunction formula;
  check.That(!formula.SetHenyeyGreenstein(0.6), "no error");
  for (int i = 0; i <= 1000; ++i)
  {
    values.push_back(formula.Value(-1.0 + 0.002 * i));
  }
  check.That(!fine.SetTable(values), "no error");
  check.Near(fine.Moment(1), 0.6, 1e-3, "mean cosine of a tabulated Henyey-Greenstein function");
  check.Near(fine.Moment(2), 0.36, 2e-3, "second moment of a tabulated Henyey-Greenstein function");
}

void CheckErrors(Check& check)
{
  PhaseFunction phase;
  check.That(!phase.SetHenyeyGreenstein(0.5), "no error");
  const PhaseFunction before = phase;
  const double notANumber = std::numeric_limits<double>::quiet_NaN();
  for (const double g : { -1.0, 1.0, 1.5, notANumber })
  {
    check.That(static_cast<bool>(phase.SetHenyeyGreenstein(g)),
      "an anisotropy outside the range is rejected");
  }
  for (const std::vector<double>& values : std::vector<std::vector<double>>{
         {}, { 1.0 }, { 1.0, -0.1 }, { 1.0, notANumber }, { 0.0, 0.0 } })
  {
    check.That(static_cast<bool>(phase.SetTable(values)), "an invalid table is rejected");
  }
  check.That(phase == before, "invalid values leave the function unchanged");
}

}

int TestPhaseFunction(int, char*[])
{
  Check check;
  CheckFormula(check);
  CheckTable(check);
  CheckErrors(check);
  return check.Result();
}
