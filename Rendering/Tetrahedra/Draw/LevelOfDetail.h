// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_LevelOfDetail_h
#define interlume_LevelOfDetail_h

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace interlume
{

/**
 * @class   LevelOfDetail
 * @brief   chooses the level of detail for the available time
 *
 * Level 0 has full detail, and level 1 half the image's width and height. Each further level draws
 * half of the tetrahedra of the previous level, beginning with at most MAXIMUM_SUBSET. The last
 * level has a quarter of the image's width and height. Subsets have at least MINIMUM_SUBSET
 * tetrahedra.
 *
 * Times are expected to be proportional to GetCost(), from the closest measured level. Before the
 * first measurement, they are estimated.
 */
class LevelOfDetail
{
public:
  static constexpr std::uint32_t MAXIMUM_SUBSET = 1000000;
  static constexpr std::uint32_t MINIMUM_SUBSET = 20000;
  /// If a new mesh has more times as many or as few tetrahedra, measured times do not apply to it.
  static constexpr std::uint32_t MAXIMUM_CHANGE = 4;

  /// Clears the measured times. Call it when the window size or the render path changes.
  /// \a costSeconds is the estimated time per unit of GetCost().
  void Reset(std::uint32_t tetrahedra, double costSeconds)
  {
    *this = LevelOfDetail();
    this->Tetrahedra = std::max(tetrahedra, 1u);
    this->CostSeconds = costSeconds;
    while (this->FirstShift < 31 && tetrahedra >> this->FirstShift > MAXIMUM_SUBSET)
    {
      ++this->FirstShift;
    }
    int subsets = 0;
    while (tetrahedra >> (this->FirstShift + subsets) >= MINIMUM_SUBSET)
    {
      ++subsets;
    }
    this->Last = 2 + subsets;
  }

  /// Call it when the mesh changes. Times measured for a mesh of similar size are scaled by the
  /// cost.
  void ReplaceMesh(std::uint32_t tetrahedra)
  {
    const LevelOfDetail before = *this;
    this->Reset(tetrahedra, before.CostSeconds);
    const auto [smaller, larger] = std::minmax(this->Tetrahedra, before.Tetrahedra);
    if (larger / smaller >= MAXIMUM_CHANGE)
    {
      return;
    }
    this->Current = std::min(before.Current, this->Last);
    // If the new mesh has fewer levels, coarser times apply to its last level. Finer ones replace
    // them.
    for (int level = before.Last; level >= 0; --level)
    {
      const int target = std::min(level, this->Last);
      if (before.Seconds[level] > 0.0)
      {
        this->Seconds[target] =
          before.Seconds[level] * this->GetCost(target) / before.GetCost(level);
      }
    }
  }

  /// Returns the finest level that is expected to take at most the allocated time, or the last
  /// level. To avoid flicker, a level must leave some of the time if it is finer than the previous
  /// one.
  int Choose(double allocated)
  {
    int level = 0;
    while (level<this->Last&& this->GetExpectedSeconds(level)> this->GetMargin(level) * allocated)
    {
      ++level;
    }
    this->Current = level > 0 ? level : this->Current;
    return level;
  }

  void AddMeasurement(int level, double seconds)
  {
    const double before = this->Seconds[level];
    if (level > 0 && before > 0.0)
    {
      // The view changed, which affects the other levels as well. The square root damps noise.
      const double ratio = std::sqrt(seconds / before);
      for (double& other : this->Seconds)
      {
        other *= ratio;
      }
    }
    else
    {
      this->Seconds[level] = seconds;
    }
  }

  int GetPixelStride(int level) const { return level == 0 ? 1 : level < this->Last ? 2 : 4; }
  /// Returns the number of tetrahedra in the subset to draw, or 0 to draw the mesh.
  std::uint32_t GetSubsetSize(int level) const
  {
    const int subset = std::min(level, this->Last - 1) - 2;
    return subset < 0 ? 0 : this->Tetrahedra >> (this->FirstShift + subset);
  }

  /// Returns the expected time to draw a level.
  double GetExpectedSeconds(int level) const
  {
    for (int distance = 0; distance <= this->Last; ++distance)
    {
      for (int measured : { level + distance, level - distance })
      {
        if (measured >= 0 && measured <= this->Last && this->Seconds[measured] > 0.0)
        {
          return this->Seconds[measured] * this->GetCost(level) / this->GetCost(measured);
        }
      }
    }
    return this->CostSeconds * this->GetCost(level);
  }

private:
  static constexpr int FIRST_SUBSET = 2;

  /// Returns the fraction of the allocated time that a level is allowed to take.
  double GetMargin(int level) const
  {
    constexpr double finerMargin = 0.7;
    // The first subset takes longer than the mesh lets expect, and must be built.
    constexpr double firstMargin = 0.25;
    const bool isMeasured = std::any_of(this->Seconds.begin() + FIRST_SUBSET, this->Seconds.end(),
      [](double seconds) { return seconds > 0.0; });
    return level >= FIRST_SUBSET && !isMeasured ? firstMargin
      : level < this->Current                   ? finerMargin
                                                : 1.0;
  }

  /// Returns a relative cost: one unit for each tetrahedron, plus one for its pixels, which in a
  /// subset are more because tetrahedra are enlarged.
  double GetCost(int level) const
  {
    const std::uint32_t subset = this->GetSubsetSize(level);
    const double number = subset > 0 ? subset : this->Tetrahedra;
    const double pixels = std::pow(this->Tetrahedra / number, 2.0 / 3.0);
    const double stride = this->GetPixelStride(level);
    return number * (1.0 + pixels / (stride * stride));
  }

  std::uint32_t Tetrahedra = 1;
  /// Level 2 has Tetrahedra >> FirstShift tetrahedra.
  int FirstShift = 1;
  int Last = 2;
  int Current = 0;
  double CostSeconds = 0.0;
  std::array<double, 16> Seconds{};
};

}

#endif
