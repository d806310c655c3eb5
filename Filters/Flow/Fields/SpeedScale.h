// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SpeedScale_h
#define interlume_SpeedScale_h

#include "vtkType.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace interlume
{

/**
 * @class   SpeedScale
 * @brief   the largest of many speeds, and the largest of those that are no fill values
 *
 * A fill value, such as 1e30 where nothing was measured, is alone at the top: no more than one
 * speed in a hundred is (one of less than a hundred), and from all others it is apart by about a
 * thousand, with nothing in between. Speeds that grow so large by and by are no such values. Speeds
 * of 0 do not count. The result is the same in any order of speeds.
 */
class SpeedScale
{
public:
  /// Adds a speed, which is finite.
  void Add(double speed)
  {
    if (speed > 0.0)
    {
      const auto power = static_cast<std::size_t>(std::ilogb(speed) + Offset);
      ++this->Numbers[power];
      this->Largest[power] = std::max(this->Largest[power], speed);
    }
  }
  void Add(const SpeedScale& other)
  {
    for (std::size_t power = 0; power < Powers; ++power)
    {
      this->Numbers[power] += other.Numbers[power];
      this->Largest[power] = std::max(this->Largest[power], other.Largest[power]);
    }
  }

  /// Adds the speeds of all processes: add and maximize replace the numbers of a vector by their
  /// sums, and their largest, over processes.
  template <typename AddAll, typename MaximizeAll>
  void Unite(AddAll&& add, MaximizeAll&& maximize)
  {
    std::vector<vtkIdType> numbers(this->Numbers.begin(), this->Numbers.end());
    std::vector<double> largest(this->Largest.begin(), this->Largest.end());
    add(numbers);
    maximize(largest);
    std::copy(numbers.begin(), numbers.end(), this->Numbers.begin());
    std::copy(largest.begin(), largest.end(), this->Largest.begin());
  }

  /// Returns the largest of all speeds; 0 without one.
  double GetLargest() const
  {
    return *std::max_element(this->Largest.begin(), this->Largest.end());
  }

  /// Returns the largest of those that are no fill values, and counts those that are.
  double GetScale(vtkIdType& beyond) const
  {
    vtkIdType number = 0;
    for (const vtkIdType one : this->Numbers)
    {
      number += one;
    }
    const vtkIdType most = number < LeastNumber ? 0 : std::max<vtkIdType>(number / 100, 1);
    beyond = 0;
    vtkIdType above = 0;
    double scale = this->GetLargest();
    std::size_t last = Powers;
    for (std::size_t power = Powers; power-- > 0 && above <= most;)
    {
      if (this->Numbers[power] == 0)
      {
        continue;
      }
      if (last < Powers && last - power > Gap)
      {
        beyond = above;
        scale = this->Largest[power];
      }
      above += this->Numbers[power];
      last = power;
    }
    return scale;
  }

private:
  /// The offset of the powers of 2, with those of numbers that are not normal among them.
  static constexpr int Offset = 1080;
  static constexpr std::size_t Powers = 2112;
  static constexpr std::size_t Gap = 10;
  /// The least number of speeds; among fewer, none is a fill value.
  static constexpr vtkIdType LeastNumber = 8;

  std::array<vtkIdType, Powers> Numbers{};
  std::array<double, Powers> Largest{};
};

/// The speeds in the points of a field, and the number of vectors that are not finite.
struct SpeedCount
{
  SpeedScale Speeds;
  vtkIdType NonFinite = 0;
};

}

#endif
