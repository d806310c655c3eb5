// SPDX-License-Identifier: BSD-3-Clause
#include "Analytic/GradientNoise.h"

#include "vtkTurbulenceSource.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <utility>

namespace interlume
{

namespace
{
constexpr int Period = 256;

// The permutation of K. Perlin's reference implementation of improved noise, 2002.
constexpr unsigned char PublishedPermutation[Period] = { 151, 160, 137, 91, 90, 15, 131, 13, 201,
  95, 96, 53, 194, 233, 7, 225, 140, 36, 103, 30, 69, 142, 8, 99, 37, 240, 21, 10, 23, 190, 6, 148,
  247, 120, 234, 75, 0, 26, 197, 62, 94, 252, 219, 203, 117, 35, 11, 32, 57, 177, 33, 88, 237, 149,
  56, 87, 174, 20, 125, 136, 171, 168, 68, 175, 74, 165, 71, 134, 139, 48, 27, 166, 77, 146, 158,
  231, 83, 111, 229, 122, 60, 211, 133, 230, 220, 105, 92, 41, 55, 46, 245, 40, 244, 102, 143, 54,
  65, 25, 63, 161, 1, 216, 80, 73, 209, 76, 132, 187, 208, 89, 18, 169, 200, 196, 135, 130, 116,
  188, 159, 86, 164, 100, 109, 198, 173, 186, 3, 64, 52, 217, 226, 250, 124, 123, 5, 202, 38, 147,
  118, 126, 255, 82, 85, 212, 207, 206, 59, 227, 47, 16, 58, 17, 182, 189, 28, 42, 223, 183, 170,
  213, 119, 248, 152, 2, 44, 154, 163, 70, 221, 153, 101, 155, 167, 43, 172, 9, 129, 22, 39, 253,
  19, 98, 108, 110, 79, 113, 224, 232, 178, 185, 112, 104, 218, 246, 97, 228, 251, 34, 242, 193,
  238, 210, 144, 12, 191, 179, 162, 241, 81, 51, 145, 235, 249, 14, 239, 107, 49, 192, 214, 31, 181,
  199, 106, 157, 184, 84, 204, 176, 115, 121, 50, 45, 127, 4, 150, 254, 138, 236, 205, 93, 222, 114,
  67, 29, 24, 72, 243, 141, 128, 195, 78, 66, 215, 61, 156, 180 };

// Returns the next number of S. Vigna's splitmix64 generator.
std::uint64_t GetNextNumber(std::uint64_t& state)
{
  state += 0x9e3779b97f4a7c15ULL;
  std::uint64_t z = state;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
  return z ^ (z >> 31);
}

// Returns floor(x), and sets \a cell to floor(x) modulo Period.
double GetCell(double x, int& cell)
{
  if (std::fabs(x) < 1e9)
  {
    // Noise evaluation spends most of its time here, so avoid calling the library's floor.
    int lower = static_cast<int>(x);
    lower -= x < lower ? 1 : 0;
    cell = lower & (Period - 1);
    return lower;
  }
  const double lower = std::floor(x);
  // The difference is exact, because both operands are integers, and lies in 0 ... Period - 1.
  cell = static_cast<int>(lower - Period * std::floor(lower / Period));
  return lower;
}

double Fade(double t)
{
  return t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
}

double Interpolate(double t, double a, double b)
{
  return a + t * (b - a);
}

// Returns the dot product of an offset and the gradient selected by a hash.
double GetGradientProduct(int hash, double x, double y, double z)
{
  const int h = hash & 15;
  const double u = h < 8 ? x : y;
  const double v = h < 4 ? y : (h == 12 || h == 14 ? x : z);
  return ((h & 1) == 0 ? u : -u) + ((h & 2) == 0 ? v : -v);
}
}

GradientNoise::GradientNoise(int seed)
{
  auto& p = this->Permutation;
  if (seed == 0)
  {
    std::copy_n(PublishedPermutation, Period, p.begin());
  }
  else
  {
    std::iota(p.begin(), p.begin() + Period, static_cast<unsigned char>(0));
    auto state = static_cast<std::uint64_t>(seed);
    for (int i = Period - 1; i > 0; --i)
    {
      std::swap(p[i], p[GetNextNumber(state) % (i + 1)]);
    }
  }
  std::copy_n(p.begin(), Period, p.begin() + Period);
}

double GradientNoise::Evaluate(const double x[3]) const
{
  int cell[3];
  double t[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    if (!std::isfinite(x[axis]))
    {
      return 0.0;
    }
    t[axis] = x[axis] - GetCell(x[axis], cell[axis]);
  }
  const auto& p = this->Permutation;
  const double u = Fade(t[0]);
  const double v = Fade(t[1]);
  const double w = Fade(t[2]);
  const int a = p[cell[0]] + cell[1];
  const int b = p[cell[0] + 1] + cell[1];
  const int hashes[4] = { p[a] + cell[2], p[b] + cell[2], p[a + 1] + cell[2], p[b + 1] + cell[2] };
  double layers[2];
  for (int k = 0; k < 2; ++k)
  {
    const double z = t[2] - k;
    const double front = Interpolate(u, GetGradientProduct(p[hashes[0] + k], t[0], t[1], z),
      GetGradientProduct(p[hashes[1] + k], t[0] - 1.0, t[1], z));
    const double back = Interpolate(u, GetGradientProduct(p[hashes[2] + k], t[0], t[1] - 1.0, z),
      GetGradientProduct(p[hashes[3] + k], t[0] - 1.0, t[1] - 1.0, z));
    layers[k] = Interpolate(v, front, back);
  }
  return Interpolate(w, layers[0], layers[1]);
}

double GradientNoise::Sum(const double x[3], int sum, int octaves) const
{
  if (sum == vtkTurbulenceSource::NOISE)
  {
    return this->Evaluate(x);
  }
  double total = 0.0;
  double scale = 1.0;
  for (int i = 0; i < octaves; ++i, scale *= 2.0)
  {
    const double scaled[3] = { scale * x[0], scale * x[1], scale * x[2] };
    const double noise = this->Evaluate(scaled) / scale;
    total += sum == vtkTurbulenceSource::TURBULENCE ? std::fabs(noise) : noise;
  }
  return total;
}

}
