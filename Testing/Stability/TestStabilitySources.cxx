// SPDX-License-Identifier: BSD-3-Clause
// Tests sources with extreme settings, positions and times. Values are compared with formulas in
// long double or checked for general properties.
#include "StabilityChecks.h"

#include "Sources/Analytic/GradientNoise.h"

#include "Support/Checks/LargestError.h"

#include "vtkAnalyticFieldSource.h"
#include "vtkAnalyticFlowSource.h"
#include "vtkConstructiveModelSource.h"
#include "vtkConstructiveVolume.h"
#include "vtkDataArray.h"
#include "vtkDeltaWingSource.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSpatialOperation.h"
#include "vtkSpatialPrimitive.h"
#include "vtkStructuredGrid.h"
#include "vtkTaperedCylinderSource.h"
#include "vtkTurbulenceSource.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace
{

using namespace stability;
using Number = long double;

const Number Pi = std::acos(Number(-1));

/// Returns the largest difference between a field and a formula at time t, relative to the largest
/// value of the formula.
double ErrorOfField(
  vtkAnalyticFieldSource* source, double t, const std::function<Number(const double* x)>& formula)
{
  source->SetOutputScalarType(VTK_DOUBLE);
  source->UpdateTimeStep(t);
  vtkImageData* image = source->GetOutput();
  Number error = image->GetNumberOfPoints() > 0 ? 0 : NaN;
  Number scale = 0;
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    double x[3];
    image->GetPoint(i, x);
    const Number expected = formula(x);
    const Number difference =
      std::abs(image->GetPointData()->GetScalars()->GetComponent(i, 0) - expected);
    reference::KeepLargest(error, difference);
    scale = std::max(scale, std::abs(expected));
  }
  return static_cast<double>(error / scale);
}

void TestFields(StabilityCatalogue& catalogue)
{
  catalogue.SetClass("vtkAnalyticFieldSource");
  vtkNew<vtkAnalyticFieldSource> source;
  source->SetDimensions(5, 4, 3);
  source->SetFieldToLinear();
  source->SetConstant(1e6);
  source->SetRate(-1e6);
  source->SetGradient(1e6, -1e6, 1e-6);
  for (const double size : { 1e-100, 1.0, 1e6 })
  {
    source->SetBounds(-size, 2.0 * size, -size, size, 0.0, size);
    for (const double t : { 0.0, -1e6, 1e6 })
    {
      catalogue.Measure("linear-" + FormatShort(size) + "-time-" + FormatShort(t),
        "coefficients of 1e6 and 1e-6 at time " + FormatShort(t) + " in a box of " +
          FormatShort(size),
        "relative error against long double",
        ErrorOfField(source, t,
          [t](const double* x)
          {
            return Number(1e6) + Number(1e6) * x[0] - Number(1e6) * x[1] + Number(1e-6) * x[2] -
              Number(1e6) * t;
          }),
        1e-14);
    }
  }
  source->SetFieldToWave();
  source->SetBounds(-2.0, 2.0, -1.0, 1.0, -1.0, 1.0);
  for (const double t : { 1e3, 1e9 })
  {
    catalogue.Measure("wave-time-" + FormatShort(t), "a wave at time " + FormatShort(t),
      "relative error against long double",
      ErrorOfField(source, t,
        [t](const double* x)
        { return x[2] - Number(0.4) * std::cos(Pi * (x[0] + Number(x[1]) / 4 - Number(t) / 2)); }),
      4e-16 * t);
  }
  source->SetFieldToSphereDistance();
  source->SetCenter(1e6, -1e6, 1e6);
  source->SetVelocity(0.0, 0.0, 0.0);
  source->SetRadius(1e-6);
  source->SetGrowth(0.0);
  source->SetBounds(1e6 - 1.0, 1e6 + 1.0, -1e6 - 1.0, -1e6 + 1.0, 1e6 - 1.0, 1e6 + 1.0);
  catalogue.Measure("ball-far", "a sphere of radius 1e-6 at a distance of 1.7e6",
    "relative error against long double",
    ErrorOfField(source, 0.0,
      [](const double* x)
      {
        const Number d[3] = { x[0] - Number(1e6), x[1] + Number(1e6), x[2] - Number(1e6) };
        return std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]) - Number(1e-6);
      }),
    1e-15);
  source->SetFieldToVortex();
  source->SetBounds(-1.0, 1.0, -1.0, 1.0, -1.0, 1.0);
  source->UpdateTimeStep(1e9);
  catalogue.Measure("vortex-late", "vortices at time 1e9, after they have left the box",
    "values outside [0, 11]",
    CountOutside(source->GetOutput()->GetPointData()->GetScalars(), 0.0, 11.0), 0.0);
  source->SetDimensions(1, 1, 1);
  source->UpdateTimeStep(0.0);
  catalogue.Measure("one-point", "an image of one point",
    "difference of the number of points from 1",
    static_cast<double>(source->GetOutput()->GetNumberOfPoints() - 1), 0.0);
}

/// Returns the relative error of one velocity component at a point.
double ErrorOfFlow(
  vtkAnalyticFlowSource* source, const std::array<double, 3>& x, int component, double expected)
{
  double v[3] = { NaN, NaN, NaN };
  source->Evaluate(x.data(), v);
  return v[component] / expected - 1.0;
}

void TestFlows(StabilityCatalogue& catalogue)
{
  catalogue.SetClass("vtkAnalyticFlowSource");
  for (const double size : { 1e-12, 1e-6, 1e6, 1e12 })
  {
    const std::string at = "-" + FormatShort(size);
    const std::string extreme = "a size of " + FormatShort(size);
    vtkNew<vtkAnalyticFlowSource> source;
    source->SetAxisTilt(0.0, 0.0);
    source->SetAxisBend(0.0, 0.0);
    source->SetEyeRadius(size);
    source->SetCoreRadius(size);
    source->SetRadius(size);
    source->SetThickness(size);
    source->SetField(vtkAnalyticFlowSource::HURRICANE);
    catalogue.Measure("hurricane" + at, "an eye with " + extreme,
      "relative error of the largest swirl", ErrorOfFlow(source, { size, 0.0, -1.0 }, 1, 1.0),
      1e-14);
    source->SetField(vtkAnalyticFlowSource::TORNADO);
    catalogue.Measure("tornado" + at, "a core with " + extreme,
      "relative error of the swirl at the core radius",
      ErrorOfFlow(source, { size, 0.0, 0.0 }, 1,
        static_cast<double>((1 - std::exp(Number(-1))) / (2 * Pi * size))),
      1e-14);
    source->SetField(vtkAnalyticFlowSource::SPHERE);
    catalogue.Measure("sphere" + at, "a sphere with " + extreme,
      "relative error of the speed at its side", ErrorOfFlow(source, { 0.0, size, 0.0 }, 0, 1.5),
      1e-14);
    source->SetField(vtkAnalyticFlowSource::CYLINDER);
    catalogue.Measure("cylinder" + at, "a cylinder with " + extreme,
      "relative error of the speed at its side", ErrorOfFlow(source, { 0.0, size, 0.0 }, 0, 2.0),
      1e-14);
    source->SetField(vtkAnalyticFlowSource::SHEAR);
    catalogue.Measure("shear" + at, "a layer with " + extreme, "relative error of the speed in it",
      ErrorOfFlow(source, { 0.0, 0.0, size }, 0, static_cast<double>(std::tanh(Number(1)))), 1e-14);
    source->SetField(vtkAnalyticFlowSource::SOURCE_SINK);
    // The separation is clamped to 1e12, so large sizes have a smaller core.
    const double core = size > 1.0 ? 1e-3 * size : size;
    source->SetCoreRadius(core);
    source->SetSeparation(1e3 * core, 0.0, 0.0);
    double divergence[9];
    const double position[3] = { -500.0 * core, 0.25 * core, 0.0 };
    source->EvaluateJacobian(position, divergence);
    catalogue.Measure("source" + at, "a source with a core of " + FormatShort(core),
      "relative error of the divergence in the core",
      static_cast<double>(
        (Number(divergence[0]) + divergence[4] + divergence[8]) * 4 * Pi * core * core * core / 3 -
        1),
      1e-12);
    source->SetDimensions(5, 5, 5);
    source->SetBounds(-size, size, -size, size, -size, size);
    double notFinite = 0.0;
    for (int field = 0; field < vtkAnalyticFlowSource::NUMBER_OF_FIELDS; ++field)
    {
      source->SetField(field);
      source->Update();
      notFinite += CountOutside(
        source->GetOutput()->GetPointData()->GetVectors(), -VTK_DOUBLE_MAX, VTK_DOUBLE_MAX);
    }
    catalogue.Measure("all-fields" + at, "every field in a box with " + extreme,
      "values that are not finite", notFinite, 0.0);
  }
  vtkNew<vtkAnalyticFlowSource> source;
  source->SetField(vtkAnalyticFlowSource::ROTATION);
  source->SetAngularVelocity(1e300);
  catalogue.Measure("rotation-clamped", "an angular velocity of 1e300",
    "relative error of the speed for the maximum angular velocity, 1e12",
    ErrorOfFlow(source, { 1e-3, 0.0, 0.0 }, 1, 1e9), 1e-15);
}

void TestNoise(StabilityCatalogue& catalogue)
{
  catalogue.SetClass("vtkTurbulenceSource");
  vtkNew<vtkTurbulenceSource> noise;
  noise->SetSeed(7);
  noise->SetFrequency(1.0);
  noise->SetSum(vtkTurbulenceSource::NOISE);
  const double near[3] = { 0.375, 17.25, 3.5 };
  for (const double periods : { 0x1p20, 0x1p30, -0x1p40 })
  {
    const double far[3] = { near[0] + 256.0 * periods, near[1], near[2] - 256.0 * periods };
    catalogue.Measure("far-" + FormatShort(periods), FormatShort(periods) + " periods away",
      "difference from the noise near the origin", noise->Evaluate(far) - noise->Evaluate(near),
      0.0);
  }

  vtkNew<vtkTurbulenceSource> source;
  source->SetDimensions(9, 9, 9);
  const auto outside = [&](double bound)
  {
    source->Update();
    return CountOutside(source->GetOutput()->GetPointData()->GetScalars(), -bound, bound);
  };
  source->SetFrequency(0.0);
  source->SetOffset(0.25);
  source->Update();
  catalogue.Measure("frequency-0", "a frequency of 0", "values other than the offset",
    CountOutside(source->GetOutput()->GetPointData()->GetScalars(), 0.25, 0.25), 0.0);
  source->SetOffset(0.0);
  source->SetFrequency(1e300);
  source->SetNumberOfOctaves(16);
  catalogue.Measure("frequency-1e12", "16 octaves from a frequency of 1e12, the maximum",
    "values above twice the largest noise", outside(2.0 * interlume::GradientNoise::LargestNoise),
    0.0);
  source->SetFrequency(2.0);
  const double position[3] = { 0.1, 0.2, 0.3 };
  const double plain = source->Evaluate(position);
  source->SetAmplitude(1e300);
  catalogue.Measure("amplitude-1e12", "an amplitude of 1e12, the maximum",
    "relative error of a value", source->Evaluate(position) / (1e12 * plain) - 1.0, 1e-15);
  catalogue.Measure("amplitude-1e12-values", "an amplitude of 1e12, the maximum",
    "values above twice the largest noise", outside(2e12 * interlume::GradientNoise::LargestNoise),
    0.0);
  source->SetAmplitude(NaN);
  source->SetTopFraction(0.0);
  source->SetFalloff(vtkTurbulenceSource::EXPONENTIAL);
  source->SetBounds(-1e-300, 1e-300, -1.0, 1.0, -1e300, 1e300);
  catalogue.Measure("bounds", "bounds of 1e-300 and 1e300", "values that are not finite",
    outside(VTK_FLOAT_MAX), 0.0);
}

/// Returns the relative error of a sampled sphere's volume.
double ErrorOfSphere(double size, int subsamples)
{
  vtkNew<vtkSpatialPrimitive> sphere;
  sphere->SetRadius(size);
  vtkNew<vtkConstructiveVolume> source;
  source->SetRoot(sphere);
  source->SetDimensions(25, 25, 25);
  source->SetBounds(-1.2 * size, 1.2 * size, -1.2 * size, 1.2 * size, -1.2 * size, 1.2 * size);
  source->SetNumberOfSubsamples(subsamples);
  source->Update();
  vtkDataArray* values = source->GetOutput()->GetPointData()->GetScalars();
  double sum = 0.0;
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    sum += values->GetComponent(i, 0);
  }
  return sum * 1e-3 / (4.0 / 3.0 * vtkMath::Pi()) - 1.0;
}

void TestSolids(StabilityCatalogue& catalogue)
{
  catalogue.SetClass("vtkConstructiveVolume");
  for (const double size : { 1e-100, 1e-6, 1e6, 1e100 })
  {
    catalogue.Measure("ball-" + FormatShort(size), "a sphere of radius " + FormatShort(size),
      "relative error of its volume, 4^3 samples per point", ErrorOfSphere(size, 4), 5e-3);
  }
  vtkNew<vtkSpatialPrimitive> sphere;
  vtkNew<vtkConstructiveVolume> source;
  source->SetDimensions(8, 8, 8);
  source->SetRoot(sphere);
  sphere->SetCenter(0.013, 0.017, 0.011);
  sphere->SetRadius(1e-6);
  source->Update();
  catalogue.Measure("ball-between", "a sphere between samples", "samples with nonzero density",
    CountOutside(source->GetOutput()->GetPointData()->GetScalars(), 0.0, 0.0), 0.0);
  sphere->SetRadius(1e100);
  source->Update();
  catalogue.Measure("ball-around", "a sphere around the image", "samples with density other than 1",
    CountOutside(source->GetOutput()->GetPointData()->GetScalars(), 1.0, 1.0), 0.0);
  // A chain of nested operations.
  vtkSmartPointer<vtkSpatialObject> chain = sphere.Get();
  for (int i = 0; i < 500; ++i)
  {
    vtkNew<vtkSpatialOperation> operation;
    operation->SetOperation(
      i % 2 == 0 ? vtkSpatialOperation::UNION : vtkSpatialOperation::INTERSECTION);
    operation->AddOperand(chain);
    chain = operation;
  }
  source->SetRoot(chain);
  source->Update();
  catalogue.Measure("chain-500", "500 nested operations", "samples with density other than 1",
    CountOutside(source->GetOutput()->GetPointData()->GetScalars(), 1.0, 1.0), 0.0);

  catalogue.SetClass("vtkConstructiveModelSource");
  vtkNew<vtkConstructiveModelSource> model;
  for (const int resolution : { -5, 2, 33 })
  {
    double outside = 0.0;
    for (int i = 0; i < vtkConstructiveModelSource::NUMBER_OF_MODELS; ++i)
    {
      model->SetModel(i);
      model->SetResolution(resolution);
      model->Update();
      outside += CountOutside(model->GetOutput()->GetPointData()->GetScalars(), 0.0, 1.0);
    }
    catalogue.Measure("resolution-" + std::to_string(resolution),
      "models with a resolution of " + std::to_string(resolution), "densities outside [0, 1]",
      outside, 0.0);
  }
  model->SetResolution(1 << 30);
  catalogue.Measure("resolution-most", "a resolution of 2^30", "difference from the maximum 2048",
    model->GetResolution() - 2048.0, 0.0);
}

void TestGrids(StabilityCatalogue& catalogue)
{
  catalogue.SetClass("vtkDeltaWingSource");
  vtkNew<vtkDeltaWingSource> wing;
  wing->SetDimensions(0, -1, 1 << 30);
  catalogue.Measure("dimensions", "0, -1 and 2^30 points",
    "difference from the limits 2, 2 and 32768",
    std::abs(wing->GetDimensions()[0] - 2.0) + std::abs(wing->GetDimensions()[1] - 2.0) +
      std::abs(wing->GetDimensions()[2] - 32768.0),
    0.0);
  wing->SetDimensions(11, 12, 7);
  wing->SetBreakdownAmplitude(0.0);
  for (const double angle : { -1e300, 1e300 })
  {
    wing->SetSweepAngle(angle);
    for (const double t : { -1e6, 1e6 })
    {
      double largest = 0.0;
      for (int i = 0; i < 200; ++i)
      {
        const double x[3] = { 0.01 * i, 0.002 * i, 0.001 * i };
        const double other[3] = { x[0], -x[1], x[2] };
        const double difference = std::abs(wing->Evaluate(x, t) - wing->Evaluate(other, t));
        reference::KeepLargest(largest, difference);
      }
      catalogue.Measure("sides-" + FormatShort(angle) + "-time-" + FormatShort(t),
        "the smallest or largest sweep angle, at time " + FormatShort(t),
        "largest difference between both sides", largest, 1e-15);
    }
  }

  catalogue.SetClass("vtkTaperedCylinderSource");
  vtkNew<vtkTaperedCylinderSource> cylinder;
  cylinder->SetDimensions(9, 8, 7);
  for (const double factor : { 0.0, 1e300 })
  {
    cylinder->SetRadii(factor, factor);
    cylinder->SetHeight(factor);
    cylinder->SetOuterRadius(factor);
    cylinder->SetSpeed(factor);
    cylinder->SetStrouhalNumber(factor);
    cylinder->SetOutputScalarType(VTK_DOUBLE);
    cylinder->UpdateTimeStep(1e6);
    const std::string name = factor > 0.0 ? "largest" : "smallest";
    catalogue.Measure(name, "the " + name + " values of all settings, at time 1e6",
      "densities outside [0, 1]",
      CountOutside(cylinder->GetOutput()->GetPointData()->GetScalars(), 0.0, 1.0), 0.0);
    double x[3];
    const int first[3] = { 0, 3, 0 };
    cylinder->GetPosition(first, x);
    catalogue.Measure(name + "-wall", "the " + name + " values of all settings",
      "relative error of the wall's radius", std::hypot(x[0], x[1]) / cylinder->GetRadii()[0] - 1.0,
      1e-14);
  }
}

}

int TestStabilitySources(int argc, char* argv[])
{
  return RunCases(
    __func__, "", argc, argv, { TestFields, TestFlows, TestNoise, TestSolids, TestGrids });
}
