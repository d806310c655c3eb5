// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_PathIntegrals_h
#define interlume_PathIntegrals_h

#include "Advection/AdvectionOptions.h"
#include "Common/Vectors.h"
#include "Numerics/DenseOutput.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace interlume
{

/**
 * @class   PathIntegrals
 * @brief   optional quantities along a streamline: maximum speed, arc length, and time averages
 *
 * Integrals use four-point Gauss quadrature on the dense output of each step. The speed is sampled
 * at both ends and the midpoint of a step. If a streamline has zero duration, the means are the
 * values at its start point.
 */
template <typename Walker>
class PathIntegrals
{
public:
  explicit PathIntegrals(const AdvectionOptions& options)
    : Options(options)
    , Sums(options.MeanNumbers.size())
  {
  }

  bool IsEmpty() const
  {
    return !this->Options.ComputeMaximumSpeed && !this->Options.ComputeArcLength &&
      !this->HasMeans();
  }

  void Begin()
  {
    this->Time = 0.0;
    this->Length = 0.0;
    this->Speed = 0.0;
    this->Vorticity = 0.0;
    std::fill(this->Sums.begin(), this->Sums.end(), 0.0);
  }

  ///@{
  /// Appends the sums to \a numbers, or reads them back.
  void Save(std::vector<double>& numbers) const
  {
    numbers.insert(numbers.end(), { this->Time, this->Length, this->Speed, this->Vorticity });
    numbers.insert(numbers.end(), this->Sums.begin(), this->Sums.end());
  }
  void Restore(const double* numbers)
  {
    for (double* number : { &this->Time, &this->Length, &this->Speed, &this->Vorticity })
    {
      *number = *numbers++;
    }
    std::copy_n(numbers, this->Sums.size(), this->Sums.begin());
  }
  ///@}

  /// Adds the part of a step from theta = 0 to \a end. \a h is the duration from theta = 0 to 1.
  void Add(const Walker& field, const DenseOutput<double>& dense, double end, double h)
  {
    if (this->Options.ComputeMaximumSpeed)
    {
      for (double theta : { 0.0, 0.5 * end, end })
      {
        double p[3];
        double rate[3];
        dense.GetPoint(theta, p);
        field.GetVelocity(p, rate);
        this->Speed = std::max(this->Speed, PathIntegrals::GetLength(field, p, rate));
      }
    }
    if (!this->Options.ComputeArcLength && !this->HasMeans())
    {
      return;
    }
    static constexpr double nodes[] = { 0.06943184420297371, 0.33000947820757187,
      0.66999052179242813, 0.93056815579702629 };
    static constexpr double weights[] = { 0.17392742256872693, 0.32607257743127307,
      0.32607257743127307, 0.17392742256872693 };
    for (int i = 0; i < 4; ++i)
    {
      double p[3];
      dense.GetPoint(end * nodes[i], p);
      if (this->Options.ComputeArcLength)
      {
        double slope[3];
        dense.GetDerivative(end * nodes[i], slope);
        this->Length += end * weights[i] * PathIntegrals::GetLength(field, p, slope);
      }
      this->AddMeans(field, p, end * h * weights[i]);
    }
    this->Time += end * h;
  }

  /// Returns the length of the vorticity vector at \a p.
  static double GetVorticity(const Walker& field, const double p[3])
  {
    double gradient[9];
    field.GetVelocityGradient(p, gradient);
    const double curl[3] = { gradient[7] - gradient[5], gradient[2] - gradient[6],
      gradient[3] - gradient[1] };
    return Vectors::SafeLength(glm::make_vec3(curl));
  }

  /// Computes the results of the streamline, which ends at \a p.
  void End(const Walker& field, const double p[3], AdvectionResult& result)
  {
    if (this->Time == 0.0)
    {
      this->Begin();
      this->AddMeans(field, p, 1.0);
      this->Time = 1.0;
      if (this->Options.ComputeMaximumSpeed)
      {
        double rate[3];
        field.GetVelocity(p, rate);
        this->Speed = PathIntegrals::GetLength(field, p, rate);
      }
    }
    result.MaximumSpeed = this->Speed;
    result.ArcLength = this->Length;
    result.MeanVorticity = this->Vorticity / this->Time;
    for (std::size_t i = 0; i < this->Sums.size(); ++i)
    {
      result.Means[i] = this->Sums[i] / this->Time;
    }
  }

private:
  bool HasMeans() const { return this->Options.ComputeMeanVorticity || !this->Sums.empty(); }

  static double GetLength(const Walker& field, const double p[3], const double d[3])
  {
    double world[3];
    field.GetWorldVector(p, d, world);
    return Vectors::SafeLength(glm::make_vec3(world));
  }

  void AddMeans(const Walker& field, const double p[3], double weight)
  {
    if (this->Options.ComputeMeanVorticity)
    {
      this->Vorticity += weight * PathIntegrals::GetVorticity(field, p);
    }
    for (std::size_t i = 0; i < this->Sums.size(); ++i)
    {
      this->Sums[i] += weight * field.Interpolate(this->Options.MeanNumbers[i], p);
    }
  }

  const AdvectionOptions& Options;
  std::vector<double> Sums;
  double Time = 0.0;
  double Length = 0.0;
  double Speed = 0.0;
  double Vorticity = 0.0;
};

}

#endif
