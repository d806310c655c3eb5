// SPDX-License-Identifier: BSD-3-Clause
#include "Samples/ReachedBoundary.h"

#include "Common/Vectors.h"
#include "Samples/ImplicitFlowArrays.h"
#include "Samples/SampleArrays.h"

#include "vtkDataSet.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace interlume
{

namespace
{
// Number of relaxation passes over all pairs. The distances need not converge exactly.
constexpr int Passes = 32;

// Calls visit(number) for each number that is extrapolated in a result.
template <typename Visit>
void ForEachNumber(AdvectionResult& result, Visit&& visit)
{
  for (double* number : { &result.Parameters[0], &result.Parameters[1], &result.Time,
         &result.MaximumSpeed, &result.ArcLength, &result.MeanVorticity })
  {
    visit(*number);
  }
  for (double& mean : result.Means)
  {
    visit(mean);
  }
}

std::vector<double> GetNumbers(AdvectionResult result)
{
  std::vector<double> numbers;
  ForEachNumber(result, [&numbers](double number) { numbers.push_back(number); });
  return numbers;
}

// Shifts a parameter by whole periods, of length 1, to within half a period of another one.
void Unwrap(double& parameter, double other)
{
  parameter += std::round(other - parameter);
}
}

bool ReachedBoundary::Find(const std::vector<FarSideCorners::Pair>& pairs,
  const SampleArrays& results, std::vector<SampleResult>& sampleResults)
{
  std::vector<vtkIdType> samples;
  for (const FarSideCorners::Pair& pair : pairs)
  {
    samples.insert(samples.end(), { pair.Reached, pair.Other });
  }
  std::sort(samples.begin(), samples.end());
  samples.erase(std::unique(samples.begin(), samples.end()), samples.end());
  sampleResults.assign(samples.size(), SampleResult());
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    sampleResults[i].Sample = samples[i];
    sampleResults[i].IsReached = this->Arrays.IsReached(samples[i]);
    sampleResults[i].FarSide.Means.assign(this->Context.Options.MeanNumbers.size(), 0.0);
  }
  const auto find = [&samples](vtkIdType sample)
  {
    return static_cast<std::size_t>(
      std::lower_bound(samples.begin(), samples.end(), sample) - samples.begin());
  };
  this->Lines.clear();
  for (const FarSideCorners::Pair& pair : pairs)
  {
    this->Lines.push_back({ find(pair.Reached), find(pair.Other), this->Arrays.GetId(pair.Reached),
      0.0, 1.0, results.Get(pair.Reached) });
  }
  if (!this->Bisect(sampleResults))
  {
    return false;
  }
  this->SetDistances(sampleResults);
  this->Extrapolate(results, sampleResults);
  return true;
}

double ReachedBoundary::GetPosition(
  const SampleResults& sampleResults, const Line& line, double fraction, double x[3]) const
{
  double other[3];
  this->Samples->GetPoint(sampleResults[line.Reached].Sample, x);
  this->Samples->GetPoint(sampleResults[line.Other].Sample, other);
  const glm::dvec3 offset = Vectors::Difference(other, x);
  for (int axis = 0; axis < 3; ++axis)
  {
    x[axis] += fraction * offset[axis];
  }
  return Vectors::SafeLength(offset);
}

bool ReachedBoundary::Bisect(const SampleResults& sampleResults)
{
  AdvectionOptions options = this->Context.Options;
  options.MaximumNumberOfSteps =
    std::min(options.MaximumNumberOfSteps, this->Context.Boundary.MaximumSteps);
  bool isActive = true;
  for (int i = 0; i < this->Context.Boundary.Bisections && isActive; ++i)
  {
    isActive = this->Context.Field.Follow(
      options, static_cast<vtkIdType>(this->Lines.size()),
      [&](vtkIdType number, double x[3])
      {
        const Line& line = this->Lines[static_cast<std::size_t>(number)];
        this->GetPosition(sampleResults, line, line.GetFraction(), x);
      },
      [this](vtkIdType number, const AdvectionResult& result)
      {
        Line& line = this->Lines[static_cast<std::size_t>(number)];
        const double midpoint = line.GetFraction();
        const bool isReached =
          result.Status == vtkFlowStatus::REACHED_SURFACE && result.Id == line.Id;
        (isReached ? line.First : line.Last) = midpoint;
        if (isReached)
        {
          line.Result = result;
        }
      },
      this->Context.Progress, this->Context.Progress);
  }
  return isActive;
}

void ReachedBoundary::SetDistances(SampleResults& sampleResults) const
{
  constexpr double unknown = VTK_DOUBLE_MAX;
  std::vector<double> logs(sampleResults.size(), unknown);
  for (const Line& line : this->Lines)
  {
    double x[3];
    const double length = this->GetPosition(sampleResults, line, 0.0, x);
    for (const bool isReached : { true, false })
    {
      double& log = logs[isReached ? line.Reached : line.Other];
      const double fraction = isReached ? line.GetFraction() : 1.0 - line.GetFraction();
      log = std::min(log, std::log(fraction * length));
    }
  }
  // Least-squares fit of the logarithms of the distances, whose ratio is known for each pair. The
  // passes update the samples that reach the surface and the other samples alternately.
  std::vector<double> sums(sampleResults.size());
  std::vector<int> numbers(sampleResults.size());
  for (int pass = 0; pass < Passes; ++pass)
  {
    const bool setsReached = pass % 2 == 0;
    std::fill(sums.begin(), sums.end(), 0.0);
    std::fill(numbers.begin(), numbers.end(), 0);
    for (const Line& line : this->Lines)
    {
      const double ratio = std::log(line.GetFraction() / (1.0 - line.GetFraction()));
      const std::size_t to = setsReached ? line.Reached : line.Other;
      sums[to] += setsReached ? logs[line.Other] + ratio : logs[line.Reached] - ratio;
      ++numbers[to];
    }
    for (std::size_t i = 0; i < sampleResults.size(); ++i)
    {
      logs[i] = numbers[i] > 0 ? sums[i] / numbers[i] : logs[i];
    }
  }
  for (std::size_t i = 0; i < sampleResults.size(); ++i)
  {
    sampleResults[i].Distance = std::exp(logs[i]);
  }
}

void ReachedBoundary::Extrapolate(const SampleArrays& results, SampleResults& sampleResults) const
{
  // For each sample that does not reach the surface, the line with the largest First. Lines with
  // another id are ignored for the sample.
  std::vector<const Line*> closest(sampleResults.size(), nullptr);
  for (const Line& line : this->Lines)
  {
    const Line*& best = closest[line.Other];
    best = !best || line.First > best->First ? &line : best;
  }
  std::vector<double> weights(sampleResults.size(), 0.0);
  std::vector<std::vector<double>> sums(sampleResults.size());
  for (const Line& line : this->Lines)
  {
    const Line& best = *closest[line.Other];
    if (line.Id != best.Id)
    {
      continue;
    }
    const std::array<bool, 2> periodicity = this->Arrays.GetPeriodicity(line.Id);
    std::vector<double> start = GetNumbers(results.Get(sampleResults[line.Reached].Sample));
    std::vector<double> end = GetNumbers(line.Result);
    for (std::size_t direction = 0; direction < 2; ++direction)
    {
      if (periodicity[direction])
      {
        Unwrap(end[direction], best.Result.Parameters[direction]);
        Unwrap(start[direction], end[direction]);
      }
    }
    std::vector<double>& sum = sums[line.Other];
    sum.resize(start.size(), 0.0);
    // The extrapolated value is start + (end - start) / First, which is inaccurate if First is
    // small. Therefore its weight is First, and the sum needs no division by First.
    const double weight = std::max(line.First, 1e-9);
    for (std::size_t i = 0; i < sum.size(); ++i)
    {
      sum[i] += weight * start[i] + (end[i] - start[i]);
    }
    weights[line.Other] += weight;
  }
  for (std::size_t i = 0; i < sampleResults.size(); ++i)
  {
    if (!closest[i])
    {
      continue;
    }
    AdvectionResult& farSide = sampleResults[i].FarSide;
    farSide = closest[i]->Result;
    std::size_t next = 0;
    ForEachNumber(farSide, [&](double& number) { number = sums[i][next++] / weights[i]; });
    const std::array<bool, 2> periodicity = this->Arrays.GetPeriodicity(farSide.Id);
    for (std::size_t direction = 0; direction < 2; ++direction)
    {
      double& parameter = farSide.Parameters[direction];
      parameter -= periodicity[direction] ? std::floor(parameter) : 0.0;
    }
  }
}

}
