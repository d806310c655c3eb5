// SPDX-License-Identifier: BSD-3-Clause
// The reference implementations for time-varying interval volumes, compared with known numbers.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceExact.h"
#include "Support/Meshes/ReferenceField.h"
#include "Support/Meshes/ReferenceMesh.h"
#include "Support/Meshes/ReferenceVolume.h"
#include "Support/TimeVarying/ReferenceSimplices.h"
#include "Support/TimeVarying/ReferenceSpaceTime.h"
#include "Support/TimeVarying/ReferenceTemporal.h"
#include "Support/TimeVarying/ReferenceTimeSteps.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>

namespace
{

using namespace reference;

double Near(long double value)
{
  return static_cast<double>(value);
}

void CheckFractions(Check& check)
{
  check.SetContext("fractions");
  check.Near(Near(FractionBelow({ 0, 1 }, 0.25)), 0.25, 1e-18, "segment", 1);
  check.Near(Near(FractionBelow({ 0, 0, 1 }, 0.25)), 1 - 0.75 * 0.75, 1e-18, "triangle", 1);
  // The region at one vertex is a scaled copy of the simplex.
  check.Near(Near(FractionBelow({ 0, 1, 1, 1, 1 }, 0.5)), 0.0625, 1e-18, "4-simplex, below", 1);
  check.Near(Near(FractionBelow({ -3, -3, -3, -3, 1 }, 0)), 1 - std::pow(0.25, 4), 1e-18,
    "4-simplex, above", 1);
  check.Near(Near(FractionBelow({ 1, 1, 1 }, 1)), 1, 0, "constant and equal");
  check.Near(Near(FractionBelow({ 1, 1, 1 }, 0)), 0, 0, "constant and above", 1);
  // By symmetry, the fraction is 1/2 if the value 1e-15 is treated as 0.
  check.Near(Near(FractionBelow({ 0, 1e-15L, 1, 1 }, 0.5)), 0.5, 1e-14, "nearly equal values");
}

void CheckExact(Check& check)
{
  check.SetContext("exact arithmetic");
  const Exact tiny = std::ldexp(1, -200);
  const Exact huge = std::ldexp(1, 200);
  check.Equal((huge + tiny - huge).Sign(), 1, "2^200 + 2^-200 - 2^200");
  check.Equal((huge + tiny - huge - tiny).Sign(), 0, "minus 2^-200");
  check.Equal(((huge + tiny) * (huge - tiny) - huge * huge + tiny * tiny).Sign(), 0, "(a+b)(a-b)");
  check.Equal((Exact(0.1) * 10 - 1).Sign(), 1, "0.1 in binary exceeds one tenth");
  const ExactPoint o = { 0, 0, 0 };
  const ExactPoint x = { 1, 0, 0 };
  const ExactPoint y = { 0, 1, 0 };
  const ExactPoint z = { 0, 0, 1 };
  check.Near(Near(ExactDeterminant({ o, x, y, z }).Round()), 1, 0, "unit tetrahedron");
  check.Near(Near(Determinant({ 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 })), 1, 0,
    "unit tetrahedron in long double");
}

/// Integrates the volume of { x in a box : linear function <= value } over time by Gaussian
/// quadrature.
double BoxIntegral(const std::array<double, 3>& size, const LinearFunction& function, double rate,
  double value, double begin, double end)
{
  // The volume is piecewise cubic in time. With many pieces, the quadrature error is negligible.
  constexpr int pieces = 20000;
  const double step = (end - begin) / pieces;
  const double node = 0.5 / std::sqrt(3.0);
  long double sum = 0;
  for (int i = 0; i < pieces; ++i)
  {
    for (double at : { 0.5 - node, 0.5 + node })
    {
      sum += BoxVolumeBelow(size, function, value - rate * (begin + (i + at) * step)) * step / 2;
    }
  }
  return static_cast<double>(sum);
}

void CheckHypervolumes(Check& check)
{
  const LinearFunction function = { 0.3, { 0.5, -0.7, 0.2 } };
  constexpr double rate = 0.9;
  const std::vector<double> times = { 0.25, 1, 1.5 };
  const double expected = BoxIntegral({ 2, 3, 2 }, function, rate, 0.8, 0.25, 1.5) -
    BoxIntegral({ 2, 3, 2 }, function, rate, 0.1, 0.25, 1.5);
  for (MeshKind kind : { MeshKind::Voxels, MeshKind::Mixed, MeshKind::Tetrahedra5 })
  {
    check.SetContext("hypervolume, " + GetName(kind));
    const TimeSteps steps = RepeatGrid(MakeMesh(kind, { 2, 3, 2 }), times);
    AddSpaceTimeField(steps,
      [&](const std::array<double, 3>& x, double time, vtkIdType)
      { return function(x.data()) + rate * time; });
    check.Near(
      Near(HypervolumeBetween(steps, "f", 0.1, 0.8)), expected, 1e-9, "linear in space and time");
    check.Near(Near(DomainHypervolume(steps)), 12 * 1.25, 1e-15, "domain");
  }
  // The volume of the stretched box is cubic in time, so Simpson's rule is exact.
  const auto volume = [](double t)
  { return 2 * (1 + 0.31 * t) * 3 * (1 - 0.13 * t) * 2 * (1 + 0.07 * t); };
  check.SetContext("moving");
  const TimeSteps moving = RepeatGrid(MakeMesh(MeshKind::Mixed, { 2, 3, 2 }), { 0, 1, 2 });
  PerturbInteriorPoints(moving, 0.1, 4);
  MovePoints(moving, Stretch);
  check.Near(Near(DomainHypervolume(moving)), (volume(0) + 4 * volume(1) + volume(2)) / 3, 1e-14,
    "stretched domain");
}

void CheckDurations(Check& check)
{
  check.SetContext("duration");
  const TimeSteps steps = RepeatGrid(MakeMesh(MeshKind::Tetrahedra6, { 2, 2, 2 }), { 0, 1, 3 });
  AddSpaceTimeField(
    steps, [](const std::array<double, 3>& x, double time, vtkIdType) { return x[0] + time; });
  check.Near(Near(DurationAt(steps, "f", 1, 2.5, { 0.4, 0.7, 1.1 })), 1.5, 1e-15,
    "the entire interval is within the time range");
  check.Near(Near(DurationAt(steps, "f", 1, 2.5, { 1.6, 0.7, 1.1 })), 0.9, 1e-15,
    "the end of the interval is within the time range");
  check.Near(Near(DurationAt(steps, "f", 1, 2.5, { 2.6, 0.7, 1.1 })), 0, 0, "outside", 1);
}

void CheckFaces(Check& check)
{
  check.SetContext("faces");
  // Two 4-simplices that share the face with the points 1, 2, 3 and 4.
  const std::vector<FourSimplex> simplices = { { 0, 1, 2, 3, 4 }, { 1, 0 + 5, 2, 3, 4 } };
  long long inner = 0;
  long long outer = 0;
  for (const SimplexUse<4>& use : CountUses(FacesOf(simplices)))
  {
    inner += use.Plus == 1 && use.Minus == 1 ? 1 : 0;
    outer += use.Total() == 1 ? 1 : 0;
  }
  check.Equal(inner, 1, "matching faces of two 4-simplices");
  check.Equal(outer, 8, "faces of two 4-simplices that do not match");
  check.Near(Near(SimplexHypervolume({ { { 0, 0, 0, 0 }, { 1, 0, 0, 0 }, { 0, 1, 0, 0 },
               { 0, 0, 1, 0 }, { 0, 0, 0, 1 } } })),
    1.0 / 24, 1e-18, "hypervolume of the unit 4-simplex");
}

void CheckSource(Check& check)
{
  check.SetContext("source");
  const TimeSteps steps = RepeatGrid(MakeMesh(MeshKind::Mixed, { 1, 1, 1 }), { 0.5, 1.5, 2.5 });
  AddSpaceTimeField(
    steps, [](const std::array<double, 3>&, double time, vtkIdType) { return 10 * time; });
  vtkNew<TimeStepSource> source;
  source->SetSteps(steps);
  vtkSmartPointer<vtkDataArray> retained;
  for (double time : { 1.5, 2.5, 0.5 })
  {
    source->UpdateTimeStep(time);
    auto* data = vtkDataSet::SafeDownCast(source->GetOutputDataObject(0));
    if (!check.That(data && data->GetPointData()->GetScalars(), "the step exists"))
    {
      return;
    }
    check.Near(
      data->GetPointData()->GetScalars()->GetComponent(0, 0), 10 * time, 0, "values of the step");
    if (!retained)
    {
      retained = data->GetPointData()->GetScalars();
    }
  }
  check.That(
    source->GetRequests() == std::vector<int>({ 1, 2, 0 }), "steps in the requested order");
  check.Equal(source->GetMaximumStepsInMemory(), 2, "number of existing steps while one is held");
}

}

int TestTimeVaryingReference(int, char*[])
{
  Check check;
  CheckFractions(check);
  CheckExact(check);
  CheckHypervolumes(check);
  CheckDurations(check);
  CheckFaces(check);
  CheckSource(check);
  return check.Result();
}
