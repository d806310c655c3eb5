// SPDX-License-Identifier: BSD-3-Clause
// SIMD advection of four streamlines at a time, with and without AVX2, is bit-identical to scalar
// advection. Tests images and rectilinear grids of any kind, surfaces, limits, every status, and
// every method.
#include "Support/Checks/ReferenceCheck.h"
#include "Support/Checks/ReferenceRandom.h"
#include "Support/Flow/ReferenceFlowGrid.h"
#include "Support/Meshes/ReferenceLattice.h"

#include "Advection/SimdAdvection.h"
#include "Common/SimdDispatch.h"
#include "Fields/FieldDispatch.h"
#include "Numerics/SimdPowers.h"
#include "Streams/SimdStepDispatch.h"

#include "vtkAnalyticFlowSource.h"
#include "vtkDataArray.h"
#include "vtkFlowStatus.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkRectilinearGrid.h"
#include "vtkTerminationPlane.h"
#include "vtkTerminationSphere.h"

#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <string>
#include <type_traits>
#include <vector>

namespace
{

using namespace reference;
using interlume::AdvectionOptions;
using interlume::AdvectionResult;

/// Returns the bytes of the results of a streamline, except the number of SIMD steps.
std::string GetBytes(const AdvectionResult& result)
{
  std::string bytes;
  const auto add = [&bytes](const auto& value)
  { bytes.append(reinterpret_cast<const char*>(&value), sizeof(value)); };
  for (const double value : { result.Parameters[0], result.Parameters[1], result.Time,
         result.Position[0], result.Position[1], result.Position[2], result.Nearness,
         result.MaximumSpeed, result.ArcLength, result.MeanVorticity })
  {
    // Maps -0 to 0.
    add(value + 0.0);
  }
  for (const int value : { result.Status, result.Id, result.Steps, result.RejectedSteps,
         result.StiffSteps, result.RejectedStiffSteps, result.Evaluations,
         result.JacobianEvaluations, result.DistanceEvaluations, result.Cells })
  {
    add(value);
  }
  return bytes;
}

/// Number of streamlines with each status, and numbers of steps.
struct Seen
{
  std::map<int, vtkIdType> Statuses;
  vtkIdType Steps = 0;
  vtkIdType SimdSteps = 0;
};

/// Compares SIMD advection with the results \a alone of scalar advection.
template <typename Group>
void CompareWithScalar(Group& lanes, const std::string& name, const std::vector<Vector>& starts,
  const std::vector<std::string>& alone, Seen& seen, Check& check)
{
  std::vector<vtkIdType> answered(starts.size(), 0);
  vtkIdType next = 0;
  const auto number = static_cast<vtkIdType>(starts.size());
  AdvectionResult found;
  lanes.Follow(
    [&](auto& advection, bool& goesOn)
    {
      const vtkIdType id = next < number ? next++ : -1;
      goesOn = id >= 0 && advection.Start(starts[static_cast<std::size_t>(id)].data());
      return id;
    },
    [&](vtkIdType id, auto& advection)
    {
      advection.Finish(found);
      const auto i = static_cast<std::size_t>(id);
      ++answered[i];
      seen.Steps += found.Steps;
      seen.SimdSteps += found.SimdSteps;
      check.That(GetBytes(found) == alone[i],
        name + ": bit-identical results of streamline " + std::to_string(id) + ", status " +
          std::to_string(found.Status) + ", " + std::to_string(found.Steps) + " steps");
    });
  for (const vtkIdType count : answered)
  {
    check.Equal(static_cast<int>(count), 1, "number of results of a streamline");
  }
}

template <typename Walker>
void Compare(const Walker& walker, const AdvectionOptions& options,
  const std::vector<Vector>& starts, Seen& seen, Check& check)
{
  std::vector<std::string> alone;
  interlume::Advection<Walker> advection(walker, options);
  AdvectionResult result;
  for (const Vector& start : starts)
  {
    advection.Follow(start.data(), result);
    alone.push_back(GetBytes(result));
    ++seen.Statuses[result.Status];
  }
  using Group = interlume::SimdAdvection<Walker, interlume::SimdStepDispatch::Four>;
  for (const bool isPlain : { false, true })
  {
    interlume::SimdDispatch::UseAvx2(!isPlain);
    Group group(walker, options, interlume::SimdStepDispatch::Take);
    CompareWithScalar(group, isPlain ? "plain" : "usual", starts, alone, seen, check);
  }
  interlume::SimdDispatch::UseAvx2(true);
}

std::vector<Vector> MakeStarts(vtkDataSet* data, int number, unsigned int seed)
{
  double bounds[6];
  data->GetBounds(bounds);
  Random random(seed);
  std::vector<Vector> starts;
  for (int i = 0; i < number; ++i)
  {
    // Some samples are outside the grid, some are at grid points.
    const double wide = i % 16 == 0 ? 0.2 : 0.0;
    Vector x;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double width = bounds[2 * axis + 1] - bounds[2 * axis];
      x[axis] = random.Get(bounds[2 * axis] - wide * width, bounds[2 * axis + 1] + wide * width);
    }
    if (i % 8 == 3)
    {
      data->GetPoint(
        static_cast<vtkIdType>(random.Get(0.0, data->GetNumberOfPoints() - 1.0)), x.data());
    }
    starts.push_back(x);
  }
  return starts;
}

void CompareOn(
  vtkDataSet* data, const AdvectionOptions& options, int number, Seen& seen, Check& check)
{
  const std::vector<Vector> starts = MakeStarts(data, number, 5);
  const interlume::Error error =
    interlume::FieldDispatch::Execute(data, data->GetPointData()->GetVectors(), {},
      [&](const auto& walker)
      {
        using Walker = std::decay_t<decltype(walker)>;
        if constexpr (std::is_same_v<Walker, interlume::ImageWalker> ||
          std::is_same_v<Walker, interlume::RectilinearWalker>)
        {
          Compare(walker, options, starts, seen, check);
        }
      });
  check.That(!error, error.GetMessage());
}

AdvectionOptions MakeOptions()
{
  AdvectionOptions options;
  options.MaximumError = 1e-6;
  options.MaximumTime = 40.0;
  options.MaximumNumberOfSteps = 3000;
  options.MinimumSpeed = 1e-9;
  options.DomainFaces = true;
  return options;
}

vtkSmartPointer<vtkImageData> MakeAnalytic(int field, int points)
{
  vtkNew<vtkAnalyticFlowSource> source;
  source->SetField(field);
  source->SetDimensions(points, points + 3, points - 2);
  source->Update();
  return source->GetOutput();
}

/// Traces fields of vtkAnalyticFlowSource forward and backward, with and without surfaces, at
/// several tolerances.
void TestFields(Seen& seen, Check& check)
{
  vtkNew<vtkTerminationSphere> sphere;
  sphere->SetCenter(0.2, -0.1, 0.15);
  sphere->SetRadius(0.2);
  sphere->Update();
  vtkNew<vtkTerminationPlane> plane;
  plane->SetOrigin(-0.5, -0.5, -0.31);
  plane->SetPoint1(0.7, -0.5, -0.31);
  plane->SetPoint2(-0.5, 0.6, -0.31);
  plane->Update();
  for (const int field :
    { vtkAnalyticFlowSource::HURRICANE, vtkAnalyticFlowSource::ABC, vtkAnalyticFlowSource::ROTATION,
      vtkAnalyticFlowSource::SADDLE, vtkAnalyticFlowSource::NODE, vtkAnalyticFlowSource::UNIFORM })
  {
    const auto image = MakeAnalytic(field, 14);
    for (const bool isBackward : { false, true })
    {
      for (const double error : { 1e-3, 1e-6, 1e-10 })
      {
        for (const bool hasSurfaces : { false, true })
        {
          check.SetContext("field " + std::to_string(field) + ", error " + std::to_string(error));
          AdvectionOptions options = MakeOptions();
          options.SetBackward(isBackward);
          options.MaximumError = error;
          options.DomainFaces = !hasSurfaces;
          if (hasSurfaces)
          {
            options.Surfaces = { { sphere, 0 }, { plane, 1 } };
          }
          CompareOn(image, options, 40, seen, check);
        }
      }
    }
  }
  check.SetContext("");
}

/// Tests images and rectilinear grids, several vector types, and blanked and non-finite regions.
void TestGrids(Seen& seen, Check& check)
{
  const auto swirl = [](const Vector& x) {
    return Vector{ { 1.5 - x[1] + 0.1 * std::sin(3.0 * x[2]), x[0] - 2.3, 0.2 * std::cos(x[0]) } };
  };
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const auto holed = [&swirl, nan](const Vector& x) {
    return x[0] > 3.0 && x[1] < 1.0 ? Vector{ { nan, 0.0, 0.0 } } : swirl(x);
  };
  const AdvectionOptions options = MakeOptions();
  for (const int type : { VTK_FLOAT, VTK_DOUBLE, VTK_SHORT })
  {
    check.SetContext("type " + std::to_string(type));
    auto image = MakeFlowImage(9, swirl);
    AddVectors(image, swirl, type);
    CompareOn(image, options, 60, seen, check);
    image->SetExtent(-3, 5, 2, 10, 7, 15);
    image->SetDirectionMatrix(0.36, 0.48, -0.8, -0.8, 0.6, 0, 0.48, 0.64, 0.6);
    CompareOn(image, options, 60, seen, check);
  }
  check.SetContext("not finite");
  auto image = MakeFlowImage(9, holed);
  CompareOn(image, options, 80, seen, check);
  check.SetContext("blanked");
  image = MakeFlowImage(9, swirl);
  auto* marks = image->AllocateCellGhostArray();
  for (vtkIdType cell = 0; cell < image->GetNumberOfCells(); cell += 7)
  {
    marks->SetValue(cell, vtkDataSetAttributes::HIDDENCELL);
  }
  CompareOn(image, options, 80, seen, check);
  for (const auto& grid : MakeFlowGrids())
  {
    check.SetContext(grid.first);
    AddVectors(grid.second, swirl);
    CompareOn(grid.second, options, 80, seen, check);
  }
  check.SetContext("");
}

/// Tests all methods with limits of time, steps and speed, and with stiff and random fields.
void TestLimits(Seen& seen, Check& check)
{
  const auto stiff = [](const Vector& x) {
    return Vector{ { 1e-2, -3000.0 * (x[1] - 2.0), 2000.0 * (2.0 - x[2]) } };
  };
  const auto node = [](const Vector& x) {
    return Vector{ { 2.2 - x[0], 1.9 - x[1], 2.1 - x[2] } };
  };
  const auto turn = [](const Vector& x) { return Vector{ { 2.0 - x[1], x[0] - 2.0, 0.0 } }; };
  for (const int integrator : { AdvectionOptions::AUTOMATIC, AdvectionOptions::DORMAND_PRINCE,
         AdvectionOptions::RUNGE_KUTTA_4, AdvectionOptions::ROSENBROCK })
  {
    check.SetContext("method " + std::to_string(integrator));
    AdvectionOptions options = MakeOptions();
    options.SetBackward(false);
    options.Integrator = integrator;
    CompareOn(MakeFlowImage(9, stiff), options, 30, seen, check);
    options.MinimumSpeed = 0.05;
    CompareOn(MakeFlowImage(9, node), options, 30, seen, check);
    options.MinimumSpeed = 1e-9;
    options.MaximumError = 1e-3;
    CompareOn(MakeFlowImage(9, node), options, 30, seen, check);
    options.MaximumTime = VTK_DOUBLE_MAX;
    CompareOn(MakeFlowImage(9, turn), options, 30, seen, check);
    options.MaximumNumberOfSteps = 77;
    CompareOn(MakeFlowImage(9, turn), options, 30, seen, check);
    options.MaximumTime = 3.3;
    CompareOn(MakeFlowImage(9, turn), options, 30, seen, check);
    auto random = MakeFlowImage(7, node);
    AddRandomVectors(random, 11);
    CompareOn(random, options, 60, seen, check);
    options.ComputeArcLength = true;
    CompareOn(random, options, 10, seen, check);
  }
  check.SetContext("");
}

/// Tests that SIMD logarithms and powers are close to exact, and bit-identical for packs of two and
/// four lanes.
void TestPowers(Check& check)
{
  using interlume::SimdPack;
  using interlume::SimdPowers;
  for (double x = 1e-12; x < 1e12; x *= 1.0137)
  {
    const double found = SimdPowers::Log2(SimdPack<4>::Of(x)).Get(3);
    check.Near(found, std::log2(x), 1e-7, "logarithm of " + std::to_string(x), 1.0);
    check.That(found == SimdPowers::Log2(SimdPack<2>::Of(x)).Get(0), "two and four SIMD lanes");
    const double power = SimdPowers::Exp2(SimdPack<4>::Of(found)).Get(2);
    check.Near(power, x, 5e-7, "power of 2");
    check.That(power == SimdPowers::Exp2(SimdPack<2>::Of(found)).Get(1), "two and four SIMD lanes");
  }
}

}

int TestSimdAdvection(int, char*[])
{
  Check check;
  TestPowers(check);
  Seen seen;
  TestFields(seen, check);
  TestGrids(seen, check);
  check.That(seen.SimdSteps > 0.8 * seen.Steps,
    std::to_string(seen.SimdSteps) + " of " + std::to_string(seen.Steps) + " SIMD steps");
  TestLimits(seen, check);
  for (int status = 0; status < vtkFlowStatus::NUMBER_OF_VALUES; ++status)
  {
    check.That(seen.Statuses[status] >= 10,
      std::to_string(seen.Statuses[status]) + " that are " + vtkFlowStatus::GetName(status));
  }
  return check.Result();
}
