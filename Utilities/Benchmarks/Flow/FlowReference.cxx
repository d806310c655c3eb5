// SPDX-License-Identifier: BSD-3-Clause
#include "Benchmarks/Flow/FlowReference.h"

#include "Benchmarks/Flow/TrilinearFlow.h"
#include "Benchmarks/Flow/VelocityInterpolation.h"
#include "Benchmarks/Measures/BenchTiming.h"

#include "vtkCell.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkPointData.h"

#include <boost/numeric/odeint/integrate/integrate_adaptive.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

namespace flow
{
namespace
{
double Mean(const std::vector<double>& numbers)
{
  return numbers.empty()
    ? 0.0
    : std::accumulate(numbers.begin(), numbers.end(), 0.0) / static_cast<double>(numbers.size());
}

/// Streamlines of the field as VTK interpolates it.
class InterpolatedFlow
{
public:
  explicit InterpolatedFlow(const Case& what)
    : Interpolation(NewInterpolator(CellSearch::STATIC_CELL_LOCATOR, what.Field))
  {
    this->LongestStep = 0.1 * std::sqrt(what.Field->GetCell(0)->GetLength2() / 3.0) /
      what.Field->GetPointData()->GetVectors()->GetMaxNorm();
  }

  void GetVelocity(const double x[3], double v[3]) const
  {
    double position[4] = { x[0], x[1], x[2], 0.0 };
    if (this->Interpolation->FunctionValues(position, v) == 0)
    {
      std::fill(v, v + 3, 0.0);
    }
  }

  void Follow(double x[3], double time) const
  {
    namespace odeint = boost::numeric::odeint;
    using State = std::vector<double>;
    State state(x, x + 3);
    const double sign = time < 0.0 ? -1.0 : 1.0;
    const auto rate = [&](const State& at, State& v, double)
    {
      this->GetVelocity(at.data(), v.data());
      std::for_each(v.begin(), v.end(), [sign](double& component) { component *= sign; });
    };
    if (std::abs(time) > 0.0)
    {
      odeint::integrate_adaptive(odeint::make_controlled(1e-12, 1e-12, this->LongestStep,
                                   odeint::runge_kutta_fehlberg78<State>()),
        rate, state, 0.0, std::abs(time), std::min(this->LongestStep, std::abs(time)));
    }
    std::copy(state.begin(), state.end(), x);
  }

private:
  vtkSmartPointer<vtkAbstractInterpolatedVelocityField> Interpolation;
  /// Time to cross a tenth of a cell at the maximum speed.
  double LongestStep;
};

template <typename Flow>
Reference MakeReference(vtkPolyData* seeds, const std::shared_ptr<Flow>& field)
{
  return Reference(
    seeds, [field](const double x[3], double v[3]) { field->GetVelocity(x, v); },
    [field](double x[3], double time) { field->Follow(x, time); });
}
}

Reference::Reference(
  vtkPolyData* seeds, const VelocityFunction& velocity, const FollowFunction& follow)
  : Seeds(seeds)
  , GetVelocity(velocity)
  , Follow(follow)
{
}

Reference Reference::FromInterpolatedField(const Case& what)
{
  if (vtkImageData* image = vtkImageData::SafeDownCast(what.Field))
  {
    return MakeReference(what.Seeds, std::make_shared<TrilinearFlow>(image));
  }
  return MakeReference(what.Seeds, std::make_shared<InterpolatedFlow>(what));
}

Difference Reference::Compare(const MethodResult& result, vtkIdType stride, double error) const
{
  // Upper bound of the rounding error of a position.
  constexpr double rounding = 1e-13;
  std::vector<double> distances;
  std::vector<double> times;
  std::vector<double> within;
  for (vtkIdType i = 0; i < this->Seeds->GetNumberOfPoints(); i += stride)
  {
    const End& end = result.Ends[static_cast<std::size_t>(i)];
    if (!end.HasResult)
    {
      continue;
    }
    double position[3];
    this->Seeds->GetPoint(i, position);
    double time = -end.Time;
    this->Follow(position, time);
    const double carried =
      std::sqrt(vtkMath::Distance2BetweenPoints(position, end.Position.data()));
    // Move to the point of the exact streamline that is closest to the endpoint.
    for (int iteration = 0; iteration < 4; ++iteration)
    {
      double v[3];
      this->GetVelocity(position, v);
      double difference[3];
      vtkMath::Subtract(end.Position.data(), position, difference);
      const double speed2 = vtkMath::Dot(v, v);
      if (speed2 == 0.0)
      {
        break;
      }
      const double along = vtkMath::Dot(difference, v) / speed2;
      this->Follow(position, along);
      time += along;
    }
    if (!std::isfinite(time) || !std::isfinite(carried))
    {
      throw std::runtime_error(
        "The reference position of seed " + std::to_string(i) + " is not finite");
    }
    distances.push_back(std::sqrt(vtkMath::Distance2BetweenPoints(position, end.Position.data())));
    times.push_back(std::abs(end.Time + time));
    within.push_back(carried <= error * end.Time + rounding ? 1.0 : 0.0);
  }
  return { Mean(distances), Median(distances), Mean(times), Mean(within) };
}
}
