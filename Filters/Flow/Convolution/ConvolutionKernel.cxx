// SPDX-License-Identifier: BSD-3-Clause
#include "Convolution/ConvolutionKernel.h"

#include "Convolution/LatticeNoise.h"

#include "vtkMath.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace interlume
{

namespace
{
/// Autocorrelation of a lattice point's interpolation weight, tabulated by offset in lattice units.
class Correlation
{
public:
  Correlation()
  {
    for (int i = 0; i <= TableSize; ++i)
    {
      const double d = 2.0 * i / TableSize;
      double sum = 0.0;
      // The trapezoidal rule is accurate, because the weight and its first two derivatives are 0 at
      // both ends.
      for (int k = -Samples; k <= Samples; ++k)
      {
        const double t = static_cast<double>(k) / Samples;
        sum += Weight(t) * Weight(t + d);
      }
      this->Table[i] = sum / Samples;
    }
  }
  double Get(double d) const
  {
    const double position = std::min(0.5 * std::abs(d) * TableSize, static_cast<double>(TableSize));
    const int lower = std::min(static_cast<int>(position), TableSize - 1);
    return this->Table[lower] + (position - lower) * (this->Table[lower + 1] - this->Table[lower]);
  }

private:
  static constexpr int TableSize = 512;
  static constexpr int Samples = 128;
  static double Weight(double t)
  {
    return std::abs(t) < 1.0 ? 1.0 - LatticeNoise::Fade(std::abs(t)) : 0.0;
  }
  std::array<double, TableSize + 1> Table;
};

/// Returns the covariance of the noise at distance \a d in lattice units, averaged over directions.
double GetCovariance(const Correlation& correlation, double d)
{
  constexpr int rings = 16;
  double sum = 0.0;
  // Averages over the directions in an octant, with the midpoint rule in z and in the azimuth.
  for (int i = 0; i < rings; ++i)
  {
    const double z = (i + 0.5) / rings;
    const double across = std::sqrt(1.0 - z * z);
    for (int j = 0; j < rings; ++j)
    {
      const double angle = 0.5 * vtkMath::Pi() * (j + 0.5) / rings;
      sum += correlation.Get(d * across * std::cos(angle)) *
        correlation.Get(d * across * std::sin(angle)) * correlation.Get(d * z);
    }
  }
  return LatticeNoise::Variance * sum / (rings * rings);
}
}

ConvolutionKernel::ConvolutionKernel(bool isHann, int steps, double step, double scale)
{
  for (int j = 0; j <= steps; ++j)
  {
    double weight = isHann ? 0.5 * (1.0 + std::cos(vtkMath::Pi() * j / steps)) : 1.0;
    weight *= j == steps ? 0.5 : 1.0;
    this->Weights.push_back(weight);
    this->Sums.push_back(weight + (j > 0 ? this->Sums.back() : 0.0));
  }
  const Correlation correlation;
  std::vector<double> covariance;
  const double unit = step / scale;
  for (int j = 0; j <= 2 * steps && j * unit < 2.0 * std::sqrt(3.0); ++j)
  {
    covariance.push_back(GetCovariance(correlation, j * unit));
  }
  const int range = static_cast<int>(covariance.size()) - 1;
  for (int j = 0; j <= steps; ++j)
  {
    double front = this->Weights[j] * covariance[0];
    double back = j > 0 ? front : 0.0;
    for (int other = std::max(0, j - range); other < j; ++other)
    {
      const double pair = 2.0 * this->Weights[other] * covariance[j - other];
      front += pair;
      back += other > 0 ? pair : 0.0;
    }
    this->FrontPairs.push_back(this->Weights[j] * front + (j > 0 ? this->FrontPairs.back() : 0.0));
    this->BackPairs.push_back(this->Weights[j] * back + (j > 0 ? this->BackPairs.back() : 0.0));
  }
  this->Reach = std::min(range, steps);
  const int size = this->Reach + 1;
  this->CrossPairs.assign(static_cast<std::size_t>(size) * size, 0.0);
  for (int b = 1; b < size; ++b)
  {
    double row = 0.0;
    for (int f = 0; f < size; ++f)
    {
      row += b + f <= range ? 2.0 * this->Weights[b] * this->Weights[f] * covariance[b + f] : 0.0;
      this->CrossPairs[b * size + f] = this->CrossPairs[(b - 1) * size + f] + row;
    }
  }
}

double ConvolutionKernel::GetDeviation(int back, int front) const
{
  const int size = this->Reach + 1;
  const double cross =
    this->CrossPairs[std::min(back, this->Reach) * size + std::min(front, this->Reach)];
  const double variance = this->FrontPairs[front] + this->BackPairs[back] + cross;
  return std::sqrt(variance) / this->GetSum(back, front);
}

}
