// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ExtractionValues_h
#define interlume_ExtractionValues_h

#include "vtkIsotable.h" // for the kinds

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <vector>

namespace interlume
{

/**
 * @class   ExtractionValues
 * @brief   the isovalues of an extraction in ascending order, and the codes of scalars relative to
 * them
 *
 * The distinct isovalues v0 < v1 < ... < v(m-1) divide the number line into 2m + 1 parts. Their
 * codes are 2k between v(k-1) and vk, and 2k + 1 at vk. The combinatorial part of an extraction
 * uses only codes, so one consistent rule applies to values equal to an isovalue.
 */
class ExtractionValues
{
public:
  using Code = std::uint16_t;

  /// A contour or an interval: the indices of its isovalues, and the conversion of codes to digits
  /// of the case key.
  struct Item
  {
    int Lower;
    int Upper;
    /// The smallest codes that have the digits 1 and 2, or NoCode if there is none.
    Code First;
    Code Second;
    /// If true, the item is an interval of zero width.
    bool IsFlat;

    std::uint8_t GetDigit(Code code) const
    {
      return static_cast<std::uint8_t>((code >= this->First) + (code >= this->Second));
    }

    /// For an interval: returns whether all codes in [minimum, maximum] are inside (digit 1).
    bool IsInside(Code minimum, Code maximum) const
    {
      return minimum >= this->First && maximum < this->Second;
    }

    /// Returns the smallest code that has the largest digit.
    Code GetLast(vtkIsotable::Kinds kind) const
    {
      return kind == vtkIsotable::INTERVAL ? this->Second : this->First;
    }
  };
  static constexpr Code NoCode = 65535;

  /// Creates the values for isosurfaces, with one item per isovalue.
  static ExtractionValues ForContours(const std::vector<double>& values);
  /// Creates the values for interval volumes, with one item per interval. Each interval must have
  /// lower <= upper.
  static ExtractionValues ForIntervals(const std::vector<std::array<double, 2>>& intervals);
  /// Creates the values for the regions outside all of these closed intervals, in ascending order.
  /// The first lower and the last upper value are infinite.
  static ExtractionValues ForComplement(std::vector<std::array<double, 2>> intervals);
  /// Removes the intervals of zero width and returns their values. Such an interval consists of
  /// cells, which ForComplement() cannot exclude.
  static std::vector<double> TakeConstants(std::vector<std::array<double, 2>>& intervals);

  vtkIsotable::Kinds GetKind() const { return this->Kind; }
  const std::vector<double>& GetValues() const { return this->Values; }
  const std::vector<Item>& GetItems() const { return this->Items; }
  /// Returns whether a grid point with this code may be an output point.
  bool IsOutputPoint(Code code) const { return this->Points[code] != 0; }
  /// Returns the code of NaN and infinities.
  Code GetNonFiniteCode() const { return static_cast<Code>(2 * this->Values.size() + 1); }
  /// Returns the base of case keys.
  int GetBase() const { return this->Kind == vtkIsotable::INTERVAL ? 3 : 2; }
  /// Returns whether an item has no output in a cell whose codes are in [lowest, highest].
  bool IsOutside(const Item& item, Code lowest, Code highest) const
  {
    return highest < item.First || lowest >= item.GetLast(this->Kind);
  }
  /// Returns whether any item is an interval of zero width.
  bool HasFlatItem() const { return this->FlatItem; }
  static bool IsTie(Code code) { return code & 1; }

  /// Returns the index of the first isovalue strictly above the lower end of an edge. \a a and \a b
  /// are the codes of the ends.
  static int GetFirstCrossing(Code a, Code b) { return ((a < b ? a : b) + 1) >> 1; }

  /// Returns the number of isovalues strictly between the ends of an edge.
  int CountCrossings(Code a, Code b) const
  {
    const Code high = a < b ? b : a;
    const int number = (high >> 1) - GetFirstCrossing(a, b);
    return number > 0 && high != this->GetNonFiniteCode() ? number : 0;
  }

  /// Returns whether the range [minimum, maximum] overlaps an item.
  bool Overlaps(double minimum, double maximum) const;

  /**
   * Returns the thresholds: the smallest numbers of type T with the codes 1, 2, 3, ... The list
   * ends early if no larger T exists. Scalars are thus compared exactly, in their own type.
   */
  template <typename T>
  std::vector<T> GetThresholds() const
  {
    std::vector<T> thresholds;
    for (const double value : this->Values)
    {
      if constexpr (std::is_integral<T>::value)
      {
        constexpr double minimum = static_cast<double>(std::numeric_limits<T>::min());
        // The largest T plus one, which is exact as double.
        const double above = std::ldexp(1.0, std::numeric_limits<T>::digits);
        const double reach = std::ceil(value);
        if (reach >= above)
        {
          return thresholds;
        }
        constexpr T first = std::numeric_limits<T>::min();
        thresholds.push_back(reach <= minimum ? first : static_cast<T>(reach));
        // The next integer is computed in type T, since above 2^53 adding 1 to a double has no
        // effect.
        const double below = std::floor(value);
        const T integer = below < minimum ? first : static_cast<T>(below);
        if (integer == std::numeric_limits<T>::max())
        {
          return thresholds;
        }
        thresholds.push_back(below < minimum ? first : static_cast<T>(integer + 1));
      }
      else
      {
        const T infinity = std::numeric_limits<T>::infinity();
        const T near = Narrow<T>(value);
        thresholds.push_back(near >= value ? near : std::nextafter(near, infinity));
        thresholds.push_back(near > value ? near : std::nextafter(near, infinity));
      }
    }
    return thresholds;
  }

private:
  // Converts with saturation, since converting an out-of-range value is undefined behavior.
  template <typename T>
  static T Narrow(double value)
  {
    constexpr double maximum = static_cast<double>(std::numeric_limits<T>::max());
    return static_cast<T>(value > maximum ? maximum : value < -maximum ? -maximum : value);
  }

  void FindPoints();
  int IndexOf(double value) const;

  vtkIsotable::Kinds Kind = vtkIsotable::CONTOUR;
  std::vector<double> Values;
  std::vector<Item> Items;
  std::vector<std::uint8_t> Points;
  bool FlatItem = false;
};

}

#endif
