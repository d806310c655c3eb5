// SPDX-License-Identifier: BSD-3-Clause
// Velocities compared with independent formulas, known properties and flow maps, and the Jacobian
// compared with finite differences. Also tests divergence, obstacles, pieces, threads, progress,
// abort and settings.
#include "Support/AnalyticFlows/ReferenceFlowMaps.h"
#include "Support/Arrays/ReferenceIndices.h"
#include "Support/Arrays/ReferenceVector.h"
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceMessages.h"
#include "Support/Checks/ReferenceProgress.h"
#include "Support/Checks/ReferenceRandom.h"
#include "Support/Meshes/ReferenceImageSource.h"

#include "vtkAnalyticFlowSource.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace
{

using namespace reference;

constexpr double Pi = 3.14159265358979323846;

// Sets every parameter to a non-default value. No direction is parallel to a coordinate axis.
void Configure(vtkAnalyticFlowSource* source)
{
  source->SetWholeExtent(-4, 13, 0, 11, 2, 12);
  source->SetBounds(-1.0, 1.2, -0.9, 1.0, -1.1, 1.0);
  source->SetCenter(0.1, -0.05, 0.2);
  source->SetVelocity(0.7, -0.4, 0.3);
  source->SetAxis(0.5, 1.0, 2.0);
  source->SetAngularVelocity(1.7);
  source->SetSaddleRates(0.5, -1.3, 0.8);
  source->SetNodeRates(-0.6, -0.4, -0.9);
  source->SetSwirl(2.5);
  source->SetStrength(1.3);
  source->SetSeparation(0.6, 0.3, -0.2);
  source->SetCoreRadius(0.15);
  source->SetRadius(0.35);
  source->SetSpanwiseVelocity(0.2);
  source->SetAmplitudes(1.1, -0.7, 0.4);
  source->SetPeriod(1.5);
  source->SetThickness(0.3);
  source->SetHeight(2.4);
  source->SetAxisTilt(0.3, -0.2);
  source->SetAxisBend(-0.15, 0.1);
  source->SetMaximumWind(1.4);
  source->SetEyeRadius(0.3);
  source->SetUpdraft(0.5);
  source->SetCirculation(0.8);
  source->SetStrain(0.6);
}

FlowVector Evaluate(const vtkAnalyticFlowSource* source, const FlowVector& x)
{
  FlowVector v;
  source->Evaluate(x.data(), v.data());
  return v;
}

FlowMatrix Derive(const vtkAnalyticFlowSource* source, const FlowVector& x)
{
  FlowMatrix jacobian;
  source->EvaluateJacobian(x.data(), jacobian.data());
  return jacobian;
}

FlowVector Curl(const FlowMatrix& j)
{
  return { { j[7] - j[5], j[2] - j[6], j[3] - j[1] } };
}

// Image values equal the velocities at the points, in double and in float.
void CheckImages(Check& check)
{
  vtkNew<vtkAnalyticFlowSource> source;
  Configure(source);
  for (int field = 0; field < vtkAnalyticFlowSource::NUMBER_OF_FIELDS; ++field)
  {
    check.SetContext(vtkAnalyticFlowSource::GetFieldName(field));
    source->SetField(field);
    for (int type : { VTK_FLOAT, VTK_DOUBLE })
    {
      source->SetOutputScalarType(type);
      source->Update();
      vtkImageData* image = source->GetOutput();
      vtkDataArray* values = image->GetPointData()->GetArray("Velocity");
      if (!values)
      {
        check.That(false, "the array exists");
        return;
      }
      if (!check.That(values == image->GetPointData()->GetVectors() &&
              values->GetDataType() == type && values->GetNumberOfComponents() == 3,
            "the array"))
      {
        return;
      }
      for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
      {
        FlowVector x;
        image->GetPoint(i, x.data());
        const FlowVector v = Evaluate(source, x);
        for (int a = 0; a < 3; ++a)
        {
          check.Near(values->GetComponent(i, a), v[a], type == VTK_FLOAT ? 1e-7 : 1e-13,
            "velocity in the image", 1.0);
        }
      }
    }
  }
}

bool IsFreeOfDivergence(int field)
{
  return field != vtkAnalyticFlowSource::NODE && field != vtkAnalyticFlowSource::SOURCE_SINK &&
    field != vtkAnalyticFlowSource::COUPLED_CHARGE;
}

// Compares the Jacobian with fourth-order finite differences, except where their stencil crosses
// the edge of a core.
void CheckDerivatives(Check& check)
{
  vtkNew<vtkAnalyticFlowSource> source;
  Configure(source);
  Random random(7);
  for (int field = 0; field < vtkAnalyticFlowSource::NUMBER_OF_FIELDS; ++field)
  {
    check.SetContext(std::string("derivatives of ") + vtkAnalyticFlowSource::GetFieldName(field));
    source->SetField(field);
    int compared = 0;
    for (int n = 0; n < 400; ++n)
    {
      const FlowVector x = random.GetPoint(1.0);
      const FlowMatrix jacobian = Derive(source, x);
      double size = 0.0;
      for (double entry : jacobian)
      {
        size += std::abs(entry);
      }
      if (IsFreeOfDivergence(field))
      {
        check.Near(jacobian[0] + jacobian[4] + jacobian[8], 0.0, 1e-14, "divergence", size + 1.0);
      }
      const double h = 1e-3;
      for (int j = 0; j < 3; ++j)
      {
        const auto at = [&](double steps)
        {
          FlowVector moved = x;
          moved[j] += steps * h;
          return Evaluate(source, moved);
        };
        const FlowVector v[4] = { at(-2.0), at(-1.0), at(1.0), at(2.0) };
        for (int i = 0; i < 3; ++i)
        {
          const double wide = (v[3][i] - v[0][i]) / (4.0 * h);
          const double narrow = (v[2][i] - v[1][i]) / (2.0 * h);
          // The field is considered smooth where the finite differences with both step sizes agree.
          if (std::abs(wide - narrow) < 3e-3 * (size + 1.0))
          {
            ++compared;
            check.Near(jacobian[3 * i + j], (4.0 * narrow - wide) / 3.0, 2e-6,
              "derivative " + std::to_string(3 * i + j), size + 1.0);
          }
        }
      }
    }
    check.That(compared > 3300, "most derivatives are compared");
  }
}

// Compares the velocity with the time derivative of a known flow map at time 0. Also checks that
// the maps form a group: advection by s and then by t equals advection by s + t.
void CheckFlowMaps(Check& check)
{
  vtkNew<vtkAnalyticFlowSource> source;
  Configure(source);
  const FlowVector center = { { 0.1, -0.05, 0.2 } };
  const FlowVector axis = { { 0.5, 1.0, 2.0 } };
  const FlowVector velocity = { { 0.7, -0.4, 0.3 } };
  const FlowVector rates = { { -0.6, -0.4, -0.9 } };
  using Map = std::function<FlowVector(const FlowVector&, double)>;
  const std::pair<int, Map> maps[] = {
    { vtkAnalyticFlowSource::UNIFORM,
      [&](const FlowVector& x, double t) { return MapUniform(x, velocity, t); } },
    { vtkAnalyticFlowSource::ROTATION,
      [&](const FlowVector& x, double t) { return MapRotation(x, center, axis, 1.7, t); } },
    { vtkAnalyticFlowSource::SADDLE,
      [&](const FlowVector& x, double t) {
        return MapSaddle(x, center, { { 0.5, -1.3, 0.8 } }, t);
      } },
    { vtkAnalyticFlowSource::NODE,
      [&](const FlowVector& x, double t) { return MapNode(x, center, rates, axis, 2.5, t); } },
    { vtkAnalyticFlowSource::SHEAR,
      [&](const FlowVector& x, double t) { return MapShear(x, center, axis, velocity, 0.3, t); } },
  };
  Random random(3);
  for (const auto& one : maps)
  {
    source->SetField(one.first);
    check.SetContext(std::string("flow map of ") + vtkAnalyticFlowSource::GetFieldName(one.first));
    for (int n = 0; n < 50; ++n)
    {
      const FlowVector x = random.GetPoint(1.0);
      const double s = random.Get(-2.0, 2.0);
      const double t = random.Get(-2.0, 2.0);
      const FlowVector there = one.second(one.second(x, s), t);
      const FlowVector direct = one.second(x, s + t);
      const FlowVector v = Evaluate(source, x);
      const double h = 1e-3;
      const FlowVector after = one.second(x, h);
      const FlowVector before = one.second(x, -h);
      for (int i = 0; i < 3; ++i)
      {
        check.Near(there[i], direct[i], 1e-13, "the flow map is a group", 30.0);
        check.Near(v[i], (after[i] - before[i]) / (2.0 * h), 2e-5, "velocity", 1.0);
      }
    }
  }
}

// Computes the flux through a sphere: Gauss quadrature in z, trapezoidal rule in the angle.
double GetFlux(const vtkAnalyticFlowSource* source, const FlowVector& center, double radius)
{
  constexpr double nodes[4] = { -0.8611363115940526, -0.3399810435848563, 0.3399810435848563,
    0.8611363115940526 };
  constexpr double weights[4] = { 0.3478548451374538, 0.6521451548625461, 0.6521451548625461,
    0.3478548451374538 };
  constexpr int intervals = 20;
  constexpr int steps = 80;
  double flux = 0.0;
  for (const auto& [k, node] : AllIndices(intervals, 4))
  {
    const double z = -1.0 + (2.0 * k + 1.0 + nodes[node]) / intervals;
    const double r = std::sqrt(1.0 - z * z);
    for (int step = 0; step < steps; ++step)
    {
      const double angle = 2.0 * Pi * step / steps;
      const FlowVector n = { { r * std::cos(angle), r * std::sin(angle), z } };
      const FlowVector v = Evaluate(source, center + radius * n);
      flux += weights[node] / intervals * 2.0 * Pi / steps * Dot(v, n);
    }
  }
  return flux * radius * radius;
}

void CheckCharges(Check& check)
{
  check.SetContext("charges");
  vtkNew<vtkAnalyticFlowSource> source;
  Configure(source);
  source->SetField(vtkAnalyticFlowSource::SOURCE_SINK);
  const FlowVector from = { { 0.1 - 0.3, -0.05 - 0.15, 0.2 + 0.1 } };
  const FlowVector to = { { 0.1 + 0.3, -0.05 + 0.15, 0.2 - 0.1 } };
  check.Near(GetFlux(source, from, 0.2), 1.3, 1e-9, "flux out of the source");
  check.Near(GetFlux(source, to, 0.2), -1.3, 1e-9, "flux into the sink");
  check.Near(GetFlux(source, from, 0.075), 1.3 / 8.0, 1e-9, "flux out of half the core");
  check.Near(
    GetFlux(source, from, 3.0), 0.0, 1e-9, "flux through a sphere around both charges", 1.0);
  source->SetField(vtkAnalyticFlowSource::COUPLED_CHARGE);
  check.Near(GetFlux(source, from, 0.2), -GetFlux(source, to, 0.2), 1e-12,
    "coupled charges have opposite flux");
  const FlowVector x = { { 0.4, 0.3, -0.6 } };
  const FlowVector offsets[2] = { x - from, x - to };
  const double cubes[2] = { std::pow(0.0225 + std::pow(GetNorm(offsets[0]), 2), 1.5),
    std::pow(0.0225 + std::pow(GetNorm(offsets[1]), 2), 1.5) };
  for (int i = 0; i < 3; ++i)
  {
    check.Near(Evaluate(source, x)[i], 1.3 * (offsets[0][i] / cubes[0] - offsets[1][i] / cubes[1]),
      1e-13, "velocity between charges", 1.0);
  }
  // The far field is a dipole with the moment Strength * Separation.
  const FlowVector far = Evaluate(source, { { 1000.1, -0.05, 0.2 } });
  check.Near(far[0] * 1e9, -2.0 * 1.3 * 0.6, 1e-4, "far field parallel to the dipole");
  check.Near(far[1] * 1e9, 1.3 * 0.3, 1e-4, "far field perpendicular to the dipole");
}

void CheckObstacles(Check& check)
{
  vtkNew<vtkAnalyticFlowSource> source;
  Configure(source);
  Random random(5);
  const FlowVector center = { { 0.1, -0.05, 0.2 } };
  const FlowVector velocity = { { 0.7, -0.4, 0.3 } };
  const double length = std::sqrt(0.25 + 1.0 + 4.0);
  const FlowVector axis = { { 0.5 / length, 1.0 / length, 2.0 / length } };
  const double along = Dot(velocity, axis);
  for (const int field : { vtkAnalyticFlowSource::SPHERE, vtkAnalyticFlowSource::CYLINDER })
  {
    const bool isSphere = field == vtkAnalyticFlowSource::SPHERE;
    check.SetContext(vtkAnalyticFlowSource::GetFieldName(field));
    source->SetField(field);
    for (int n = 0; n < 100; ++n)
    {
      FlowVector normal = random.GetDirection();
      if (!isSphere)
      {
        const double height = Dot(normal, axis);
        normal = normal - height * axis;
        normal *= 1.0 / GetNorm(normal);
      }
      const FlowVector base = isSphere ? center : center + random.Get(-2.0, 2.0) * axis;
      const FlowVector surface = base + 0.35 * (1.0 + 1e-13) * normal;
      const FlowVector v = Evaluate(source, surface);
      check.Near(Dot(v, normal), 0.0, 1e-12, "velocity through the surface", 1.0);
      const FlowVector away = Evaluate(source, base + 1e5 * normal);
      const FlowVector expected = isSphere ? velocity : velocity + 0.2 * axis;
      const FlowVector outside = base + random.Get(0.351, 3.0) * normal;
      const FlowVector curl = Curl(Derive(source, outside));
      for (int i = 0; i < 3; ++i)
      {
        check.Near(away[i], expected[i], 1e-9, "velocity far away", 1.0);
        check.Near(curl[i], 0.0, 1e-12, "vorticity", 1.0);
      }
      const FlowVector inside = base + random.Get(0.0, 0.3499) * normal;
      check.That(GetNorm(Evaluate(source, inside)) == 0.0, "velocity is 0 inside");
      if (!isSphere)
      {
        check.Near(Dot(v, axis), along + 0.2, 1e-12, "velocity along the cylinder", 1.0);
      }
      source->SetInside(vtkAnalyticFlowSource::NOT_A_NUMBER);
      check.That(std::isnan(Evaluate(source, inside)[1]) && std::isnan(Derive(source, inside)[4]),
        "velocity is NaN inside");
      check.That(
        Evaluate(source, outside) == Evaluate(source, outside), "velocity is a number outside");
      source->SetInside(vtkAnalyticFlowSource::ZERO);
    }
    source->SetInside(vtkAnalyticFlowSource::HIDDEN);
    source->Update();
    vtkImageData* image = source->GetOutput();
    vtkUnsignedCharArray* ghosts = image->GetPointGhostArray();
    if (check.That(ghosts != nullptr, "the array of hidden points exists"))
    {
      vtkIdType hidden = 0;
      for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
      {
        FlowVector x;
        image->GetPoint(i, x.data());
        const bool isHidden = (ghosts->GetValue(i) & vtkDataSetAttributes::HIDDENPOINT) != 0;
        hidden += isHidden ? 1 : 0;
        check.That(isHidden == (GetNorm(Evaluate(source, x)) == 0.0), "points inside are hidden");
      }
      check.That(hidden > 10, "some points are hidden");
    }
    source->SetInside(vtkAnalyticFlowSource::ZERO);
  }
}

void CheckVortices(Check& check)
{
  vtkNew<vtkAnalyticFlowSource> source;
  Configure(source);
  Random random(11);
  check.SetContext("ABC");
  source->SetField(vtkAnalyticFlowSource::ABC);
  for (int n = 0; n < 50; ++n)
  {
    const FlowVector x = random.GetPoint(1.0);
    const FlowVector v = Evaluate(source, x);
    const FlowVector curl = Curl(Derive(source, x));
    const FlowVector periodic = Evaluate(source, { { x[0] + 1.5, x[1] - 3.0, x[2] + 4.5 } });
    for (int i = 0; i < 3; ++i)
    {
      check.Near(curl[i], 2.0 * Pi / 1.5 * v[i], 1e-13, "curl", 10.0);
      check.Near(periodic[i], v[i], 1e-13, "periodic", 1.0);
    }
  }
  const FlowVector origin = Evaluate(source, { { 0.1, -0.05, 0.2 } });
  check.Near(origin[0], 0.4, 1e-15, "C");
  check.Near(origin[1], 1.1, 1e-15, "A");
  check.Near(origin[2], -0.7, 1e-15, "B");

  for (const int field : { vtkAnalyticFlowSource::HURRICANE, vtkAnalyticFlowSource::TORNADO })
  {
    check.SetContext(vtkAnalyticFlowSource::GetFieldName(field));
    const bool isHurricane = field == vtkAnalyticFlowSource::HURRICANE;
    source->SetField(field);
    double strongest = 0.0;
    double highest = 0.0;
    double radiusOfHighest = 0.0;
    double lowest = 0.0;
    double inflow = 0.0;
    for (const double h : { 0.0, 0.2, 0.5, 0.7, 1.0 })
    {
      const FlowVector axis = { { 0.1 + 0.3 * (h - 0.5) - 0.15 * std::sin(Pi * h),
        -0.05 - 0.2 * (h - 0.5) + 0.1 * std::sin(Pi * h), 0.2 + 2.4 * (h - 0.5) } };
      const FlowVector slope = { { (0.3 - 0.15 * Pi * std::cos(Pi * h)) / 2.4,
        (-0.2 + 0.1 * Pi * std::cos(Pi * h)) / 2.4, 1.0 } };
      const FlowVector onAxis = Evaluate(source, axis);
      for (int i = 0; i < 3; ++i)
      {
        check.Near(onAxis[i], onAxis[2] * slope[i], 1e-12, "the axis is a streamline", 1.0);
      }
      check.Near(onAxis[2],
        isHurricane ? -0.5 * std::sin(Pi * h) * 0.05 / (4.4 * 343.0 / 10648.0) : 0.6 * 2.4 * h,
        1e-12, "velocity on the axis", 1.0);
      for (int step = 1; step < 200; ++step)
      {
        const double r = 0.01 * step;
        const FlowVector v = Evaluate(source, { { axis[0] + r, axis[1], axis[2] } });
        // Subtracts the component along the axis.
        const FlowVector across = v - v[2] * slope;
        const double swirl = isHurricane
          ? 1.4 * 2.0 * (r / 0.3) / ((1.0 + r * r / 0.09) * (1.0 + h * h))
          : 0.8 / (2.0 * Pi * r) * (1.0 - std::exp(-r * r / 0.0225));
        check.Near(across[1], swirl, 1e-12, "swirl", 1.0);
        if (!isHurricane)
        {
          check.Near(across[0], -0.3 * r, 1e-12, "inflow", 1.0);
          check.Near(v[2], 0.6 * 2.4 * h, 1e-12, "rise", 1.0);
        }
        strongest = std::max(strongest, across[1]);
        lowest = std::min(lowest, v[2]);
        if (v[2] > highest)
        {
          highest = v[2];
          radiusOfHighest = r;
        }
        if (r > 0.3 && (h < 0.3 || h > 0.7))
        {
          inflow = std::min(inflow, h < 0.3 ? across[0] : -across[0]);
          check.That(!isHurricane || (h < 0.3) == (across[0] < 0.0), "inflow below, outflow above");
        }
      }
    }
    if (isHurricane)
    {
      check.Near(strongest, 1.4, 1e-3, "strongest wind");
      check.Near(highest, 0.5, 1e-3, "largest rise");
      check.Near(radiusOfHighest, 0.3 * std::sqrt(4.8 / 4.2), 0.02, "radius of the eye wall");
      check.That(lowest < -0.15, "air sinks in the eye");
    }
  }
}

// Close to the axis, the formula for the swirl suffers from cancellation. The expected values use
// the series of phi(s) = (1 - exp(-s)) / s.
void CheckCore(Check& check)
{
  check.SetContext("core of the tornado");
  vtkNew<vtkAnalyticFlowSource> source;
  source->SetField(vtkAnalyticFlowSource::TORNADO);
  source->SetAxisTilt(0.0, 0.0);
  source->SetAxisBend(0.0, 0.0);
  for (const double s : { 0.0, 1e-12, 1e-5, 9e-4, 1.1e-3, 0.01, 0.1 })
  {
    double phi = 0.0;
    double slope = 0.0;
    double power = 1.0;
    double factorial = 1.0;
    for (int n = 0; n < 15; ++n)
    {
      factorial *= n + 1;
      phi += power / factorial;
      slope -= (n + 1) * power / (factorial * (n + 2));
      power *= -s;
    }
    const double y = 0.1 * std::sqrt(s);
    const FlowMatrix jacobian = Derive(source, { { 0.0, y, 0.3 } });
    const double rate = 1.0 / (2.0 * Pi * 0.01);
    check.Near(jacobian[3], rate * phi, 1e-13, "swirl");
    check.Near(jacobian[1], -rate * (phi + 2.0 * s * slope), 1e-13, "swirl and its derivative");
  }
}

void CheckSettings(Check& check)
{
  check.SetContext("settings");
  vtkNew<vtkAnalyticFlowSource> source;
  CheckPrinted(Print(source),
    { "Field: hurricane", "OutputScalarType: 11", "Center: 0 0 0", "Velocity: 1 0 0", "Axis: 0 0 1",
      "AngularVelocity: 1", "SaddleRates: 1 1 -2", "NodeRates: 1 1 1", "Swirl: 0", "Strength: 1",
      "Separation: 1 0 0", "CoreRadius: 0.1", "Radius: 0.25", "Inside: zero",
      "SpanwiseVelocity: 0.1", "Amplitudes: 1 1 1", "Period: 2", "Thickness: 0.1", "Height: 2",
      "AxisTilt: 0.2 0.1", "AxisBend: 0.1 -0.05", "MaximumWind: 1", "EyeRadius: 0.2",
      "Updraft: 0.3", "Circulation: 1", "Strain: 0.5" },
    check);
  const vtkMTimeType time = source->GetMTime();
  const double nan = std::nan("");
  source->SetCenter(nan, nan, nan);
  source->SetRadius(nan);
  source->SetUpdraft(nan);
  source->SetAxisTilt(nan, nan);
  source->SetOutputScalarType(VTK_INT);
  check.That(source->GetMTime() == time, "NaN is ignored");
  const std::string error = CaptureErrors(source, [&]() { source->SetAxis(0.0, 0.0, 0.0); }) +
    CaptureErrors(source, [&]() { source->SetAxis(1.0, nan, 0.0); }) +
    CaptureErrors(source, [&]() { source->SetAxis(0.0, 0.0, INFINITY); });
  check.That(error.find("Axis 0 0 0 is zero or not finite") != std::string::npos &&
      error.find("Axis 1 nan 0 is zero or not finite") != std::string::npos &&
      error.find("Axis 0 0 inf is zero or not finite") != std::string::npos,
    "a zero or non-finite axis is an error");
  check.That(
    source->GetAxis()[2] == 1.0 && source->GetAxis()[0] == 0.0, "an invalid axis is ignored");
  source->SetThickness(-1.0);
  source->SetStrength(1e300);
  source->SetField(100);
  source->SetInside(-1);
  check.That(source->GetThickness() == 1e-12 && source->GetStrength() == 1e12 &&
      source->GetField() == vtkAnalyticFlowSource::TORNADO &&
      source->GetInside() == vtkAnalyticFlowSource::ZERO,
    "clamped values");
  check.That(!vtkAnalyticFlowSource::GetFieldName(12) && !vtkAnalyticFlowSource::GetFieldName(-1) &&
      !vtkAnalyticFlowSource::GetInsideName(3),
    "invalid indices have no name");
  source->SetAxis(1e-200, 0.0, 0.0);
  source->SetField(vtkAnalyticFlowSource::ROTATION);
  const FlowVector v = Evaluate(source, { { 0.0, 2.0, 0.0 } });
  check.That(v == FlowVector{ { 0.0, 0.0, 2.0 } }, "the length of the axis has no effect");
}

}

int TestAnalyticFlowSource(int, char*[])
{
  Check check;
  CheckImages(check);
  CheckDerivatives(check);
  CheckFlowMaps(check);
  CheckCharges(check);
  CheckObstacles(check);
  CheckVortices(check);
  CheckCore(check);
  vtkNew<vtkAnalyticFlowSource> source;
  Configure(source);
  check.SetContext("execution");
  CheckImageSource(source, check);
  CheckSettings(check);
  return check.Result();
}
