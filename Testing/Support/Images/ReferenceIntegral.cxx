// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Images/ReferenceIntegral.h"

#include <cmath>

namespace reference
{

namespace
{

using Color = std::array<double, 3>;

constexpr int Points = 4;
/// Nodes (each with both signs) and weights of the eight-point Gauss-Legendre rule on [-1, 1].
constexpr double Nodes[Points] = { 0.1834346424956498, 0.5255324099163290, 0.7966664774136267,
  0.9602898564975363 };
constexpr double Weights[Points] = { 0.3626837833783620, 0.3137066458778873, 0.2223810344533745,
  0.1012285362903763 };

class PartIntegral
{
public:
  explicit PartIntegral(const LinearPart& part)
    : Part(part)
  {
    this->Result.Depth = this->Depth(0.0, 1.0);
    for (int k = 0; k < 3; ++k)
    {
      this->Result.Emitted[k] =
        this->Rule(0.0, 1.0, [&](double t) { return this->Extinction(t) * this->GetColor(t, k); });
    }
    this->Add(0.0, 1.0, 0.0, 0);
  }

  const Light& Get() const { return this->Result; }

private:
  /// Returns the derivative of the optical depth with respect to t, where t is in [0, 1].
  double Extinction(double t) const
  {
    return this->Part.Length * Between(this->Part.Extinction, t) * Between(this->Part.Weight, t);
  }

  double GetColor(double t, int k) const
  {
    return this->Part.Color[0][k] + t * (this->Part.Color[1][k] - this->Part.Color[0][k]);
  }

  static double Between(const std::array<double, 2>& ends, double t)
  {
    return ends[0] + t * (ends[1] - ends[0]);
  }

  template <typename Function>
  static double Rule(double begin, double end, const Function& function)
  {
    const double midpoint = 0.5 * (begin + end);
    const double half = 0.5 * (end - begin);
    double sum = 0.0;
    for (int i = 0; i < Points; ++i)
    {
      sum +=
        Weights[i] * (function(midpoint - half * Nodes[i]) + function(midpoint + half * Nodes[i]));
    }
    return half * sum;
  }

  double Depth(double begin, double end) const
  {
    return Rule(begin, end, [this](double t) { return this->Extinction(t); });
  }

  Color Seen(double begin, double end, double depthInFront) const
  {
    Color seen{};
    const double midpoint = 0.5 * (begin + end);
    const double half = 0.5 * (end - begin);
    for (int i = 0; i < Points; ++i)
    {
      for (double t : { midpoint - half * Nodes[i], midpoint + half * Nodes[i] })
      {
        const double weight =
          half * Weights[i] * this->Extinction(t) * std::exp(-depthInFront - this->Depth(begin, t));
        for (int k = 0; k < 3; ++k)
        {
          seen[k] += weight * this->GetColor(t, k);
        }
      }
    }
    return seen;
  }

  void Add(double begin, double end, double depthInFront, int level)
  {
    constexpr double opaque = 50.0; // exp(-50) is below all tolerances
    constexpr double thin = 0.5;
    constexpr double tolerance = 1e-12;
    constexpr int deepest = 50; // subdivisions of [0, 1] that a double can represent
    if (depthInFront > opaque)
    {
      return;
    }
    const double midpoint = 0.5 * (begin + end);
    const double front = this->Depth(begin, midpoint);
    if (front + this->Depth(midpoint, end) < thin || level == deepest)
    {
      const Color coarse = this->Seen(begin, end, depthInFront);
      const Color first = this->Seen(begin, midpoint, depthInFront);
      const Color second = this->Seen(midpoint, end, depthInFront + front);
      double difference = 0.0;
      for (int k = 0; k < 3; ++k)
      {
        difference += std::abs(first[k] + second[k] - coarse[k]);
      }
      if (difference < tolerance || level == deepest)
      {
        for (int k = 0; k < 3; ++k)
        {
          this->Result.Seen[k] += first[k] + second[k];
        }
        return;
      }
    }
    this->Add(begin, midpoint, depthInFront, level + 1);
    this->Add(midpoint, end, depthInFront + front, level + 1);
  }

  const LinearPart& Part;
  Light Result;
};

}

double Light::GetAlpha() const
{
  return -std::expm1(-this->Depth);
}

void Light::AddBehind(const Light& back)
{
  const double through = std::exp(-this->Depth);
  this->Depth += back.Depth;
  for (int k = 0; k < 3; ++k)
  {
    this->Emitted[k] += back.Emitted[k];
    this->Seen[k] += through * back.Seen[k];
  }
}

Light Integrate(const LinearPart& part)
{
  return PartIntegral(part).Get();
}

}
