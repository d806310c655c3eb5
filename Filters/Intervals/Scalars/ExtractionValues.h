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
 * @brief   the isovalues of an extraction in one total order, and the codes they give to scalars
 *
 * The distinct isovalues v0 < v1 < ... cut the number line into 2 m + 1 codes: 2k between v(k-1)
 * and vk, 2k + 1 at vk itself. A code is all that the combinatorial part of an extraction sees of a
 * value; one rule for values equal to an isovalue follows for everything.
 */
class ExtractionValues
{
public:
  using Code = std::uint16_t;

  /// A contour or an interval: the indices of its isovalues, and the digit of the case key by code.
  struct Item
  {
    int Lower;
    int Upper;
    /// The first codes with digits 1 and 2; NoCode where there is none.
    Code First;
    Code Second;
    /// Whether the item is an interval of zero width.
    bool IsFlat;

    std::uint8_t GetDigit(Code code) const
    {
      return static_cast<std::uint8_t>((code >= this->First) + (code >= this->Second));
    }

    /// Returns whether codes from \a least to \a greatest all have digit 1, of an interval.
    bool IsInside(Code least, Code greatest) const
    {
      return least >= this->First && greatest < this->Second;
    }

    /// Returns the first code with the greatest digit.
    Code GetLast(vtkIsotable::Kinds kind) const
    {
      return kind == vtkIsotable::INTERVAL ? this->Second : this->First;
    }
  };
  static constexpr Code NoCode = 65535;

  /// Makes the values for isosurfaces, one item each.
  static ExtractionValues ForContours(const std::vector<double>& values);
  /// Makes the values for interval volumes, one item each; lower <= upper.
  static ExtractionValues ForIntervals(const std::vector<std::array<double, 2>>& intervals);

  vtkIsotable::Kinds GetKind() const { return this->Kind; }
  const std::vector<double>& GetValues() const { return this->Values; }
  const std::vector<Item>& GetItems() const { return this->Items; }
  /// Returns whether a grid point of this code may be an output point.
  bool IsPoint(Code code) const { return this->Points[code] != 0; }
  /// Returns the code of NaN and infinities.
  Code GetNonFiniteCode() const { return static_cast<Code>(2 * this->Values.size() + 1); }
  /// Returns how many digits a case key has for a vertex.
  int GetBase() const { return this->Kind == vtkIsotable::INTERVAL ? 3 : 2; }
  /// Returns whether an item leaves no output in a cell whose codes are lowest ... highest.
  bool IsOutside(const Item& item, Code lowest, Code highest) const
  {
    return highest < item.First || lowest >= item.GetLast(this->Kind);
  }
  /// Returns whether an interval of zero width is among the items.
  bool HasFlatItem() const { return this->FlatItem; }
  static bool IsTie(Code code) { return code & 1; }

  /// Returns the first isovalue strictly above the lower end of an edge.
  static int GetFirstCrossing(Code a, Code b) { return ((a < b ? a : b) + 1) >> 1; }

  /// Returns how many isovalues lie strictly between the ends of an edge.
  int CountCrossings(Code a, Code b) const
  {
    const Code high = a < b ? b : a;
    const int number = (high >> 1) - GetFirstCrossing(a, b);
    return number > 0 && high != this->GetNonFiniteCode() ? number : 0;
  }

  /// Returns whether a value in [minimum, maximum] touches an item.
  bool Overlaps(double minimum, double maximum) const;

  /**
   * Computes the smallest numbers of type T that reach code 1, 2, 3, ...; fewer when no T is that
   * large. So a scalar is compared in its own type, exactly.
   */
  template <typename T>
  std::vector<T> GetThresholds() const
  {
    std::vector<T> thresholds;
    for (const double value : this->Values)
    {
      if constexpr (std::is_integral<T>::value)
      {
        constexpr double least = static_cast<double>(std::numeric_limits<T>::min());
        // The number one above the largest T, which a double holds exactly.
        const double above = std::ldexp(1.0, std::numeric_limits<T>::digits);
        const double reach = std::ceil(value);
        if (reach >= above)
        {
          return thresholds;
        }
        constexpr T first = std::numeric_limits<T>::min();
        thresholds.push_back(reach <= least ? first : static_cast<T>(reach));
        // The next whole number is found among the T: beyond 2^53 a double plus 1 is rounded back.
        const double below = std::floor(value);
        const T whole = below < least ? first : static_cast<T>(below);
        if (whole == std::numeric_limits<T>::max())
        {
          return thresholds;
        }
        thresholds.push_back(below < least ? first : static_cast<T>(whole + 1));
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
  // Converts with saturation, since a conversion out of range is undefined.
  template <typename T>
  static T Narrow(double value)
  {
    constexpr double most = static_cast<double>(std::numeric_limits<T>::max());
    return static_cast<T>(value > most ? most : value < -most ? -most : value);
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
