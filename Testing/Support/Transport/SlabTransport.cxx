// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Transport/SlabTransport.h"

#include "Support/Transport/FunctionMedium.h"
#include "Support/Transport/TransportFlight.h"

#include "vtkSMPTools.h"
#include "vtkType.h"

#include <algorithm>
#include <cmath>

namespace reference
{

namespace
{

/// Number of paths in a batch. One thread sums all paths of a batch, and the batches are added in
/// order, so that the result does not depend on the number of threads.
constexpr std::uint64_t PathsPerBatch = 4096;

struct PathScore
{
  double Reflected = 0.0;
  double Transmitted = 0.0;
  /// Control variate: the martingale of TraceSlab() at the end of the path minus its initial value.
  double Control = 0.0;
};

/// Sums over paths of a score, the control variate, their squares, and their product.
struct ControlledSums
{
  double Score = 0.0;
  double ScoreSquare = 0.0;
  double Control = 0.0;
  double ControlSquare = 0.0;
  double Product = 0.0;

  void Add(double score, double control)
  {
    this->Score += score;
    this->ScoreSquare += score * score;
    this->Control += control;
    this->ControlSquare += control * control;
    this->Product += score * control;
  }

  void Add(const ControlledSums& other)
  {
    this->Score += other.Score;
    this->ScoreSquare += other.ScoreSquare;
    this->Control += other.Control;
    this->ControlSquare += other.ControlSquare;
    this->Product += other.Product;
  }

  TransportEstimate GetEstimate(double paths) const
  {
    const double score = this->Score / paths;
    const double control = this->Control / paths;
    const double variance = this->ScoreSquare / paths - score * score;
    const double controlVariance = this->ControlSquare / paths - control * control;
    const double covariance = this->Product / paths - score * control;
    const double factor = controlVariance > 0.0 ? covariance / controlVariance : 0.0;
    return { score - factor * control,
      std::sqrt(std::max(variance - factor * covariance, 0.0) / paths) };
  }
};

struct SlabSums
{
  ControlledSums Reflected;
  ControlledSums Transmitted;
};

class SlabPaths
{
public:
  explicit SlabPaths(const SlabTransportSettings& settings)
    : Settings(settings)
    , Medium(MakeMedium(settings))
    , Reach(1.0 / (1.0 - settings.Phase.GetMeanCosine()))
    , Collided(-std::expm1(-settings.Depth / settings.Cosine))
  {
  }

  PathScore Follow(std::uint64_t number) const
  {
    TransportRandom random(this->Settings.Seed, number);
    const double g = this->Settings.Phase.GetMeanCosine();
    const double mu = this->Settings.Cosine;
    TransportRay ray;
    ray.Direction = { std::sqrt((1.0 - mu) * (1.0 + mu)), 0.0, mu };
    ray.Origin.z = std::min(-mu * std::log1p(-this->Collided * random.Get()), this->Settings.Depth);
    glm::dvec3 weight(1.0);
    PathScore score;
    score.Control = -(ray.Origin.z + g * mu * this->Reach);
    for (;;)
    {
      weight *= this->Settings.Albedo;
      if (!TransportFlight::ApplyRussianRoulette(weight, random))
      {
        score.Control += ray.Origin.z + g * ray.Direction.z * this->Reach;
        return score;
      }
      ray.Direction = this->Settings.Phase.Scatter(ray.Direction, random);
      const double distance = TransportFlight::SampleCollision(this->Medium, ray, random);
      if (!std::isfinite(distance))
      {
        const bool isBack = ray.Direction.z < 0.0;
        (isBack ? score.Reflected : score.Transmitted) = this->Collided * weight.x;
        score.Control += (isBack ? 0.0 : this->Settings.Depth) + ray.Direction.z * this->Reach;
        return score;
      }
      // The slab is infinite and homogeneous in x and y, so only z matters.
      ray.Origin.z += distance * ray.Direction.z;
    }
  }

private:
  static FunctionMedium MakeMedium(const SlabTransportSettings& settings)
  {
    constexpr double never = std::numeric_limits<double>::infinity();
    const glm::dvec3 albedo(settings.Albedo);
    return settings.Majorant > 1.0
      ? FunctionMedium(
          { -never, -never, 0.0 }, { never, never, settings.Depth }, { 0.0, settings.Majorant },
          [](const glm::dvec3&) { return 1.0; }, [albedo](const glm::dvec3&) { return albedo; })
      : FunctionMedium::Slab(settings.Depth, 1.0, albedo);
  }

  const SlabTransportSettings& Settings;
  FunctionMedium Medium;
  double Reach;
  double Collided;
};

}

SlabTransportResult TraceSlab(const SlabTransportSettings& settings)
{
  const SlabPaths paths(settings);
  const std::uint64_t batches = (settings.Paths + PathsPerBatch - 1) / PathsPerBatch;
  std::vector<SlabSums> sums(batches);
  vtkSMPTools::For(0, static_cast<vtkIdType>(batches), 1,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType batch = begin; batch < end; ++batch)
      {
        SlabSums& sum = sums[static_cast<std::size_t>(batch)];
        const std::uint64_t first = static_cast<std::uint64_t>(batch) * PathsPerBatch;
        for (std::uint64_t i = first; i < std::min(first + PathsPerBatch, settings.Paths); ++i)
        {
          const PathScore score = paths.Follow(i);
          sum.Reflected.Add(score.Reflected, score.Control);
          sum.Transmitted.Add(score.Transmitted, score.Control);
        }
      }
    });
  SlabSums all;
  for (const SlabSums& sum : sums)
  {
    all.Reflected.Add(sum.Reflected);
    all.Transmitted.Add(sum.Transmitted);
  }
  const double count = static_cast<double>(settings.Paths);
  return { all.Reflected.GetEstimate(count), all.Transmitted.GetEstimate(count),
    std::exp(-settings.Depth / settings.Cosine) };
}

}
