// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_SpeedScale_h
#define interlume_SpeedScale_h

#include "vtkType.h"

#include <array>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace interlume
{

/// The vectors that are presumably fill values.
struct FillValues
{
  vtkIdType Number = 0;
  /// The component that all vectors of the most frequent kind have; 0 if they differ.
  double Value = 0.0;
  /// The largest speed of these vectors, and of all others.
  double LargestSpeed = 0.0;
  double Scale = 0.0;

  /// Returns a warning, ending with the remedy. \a array is the name of the vectors and may be
  /// null, \a effect is a sentence on the treatment of fill values.
  std::string Describe(const char* array, const std::string& effect) const;
};

/// Returns a warning of \a number points whose vectors are NaN or infinite, or an empty string if
/// there are none. \a array and \a effect are those of FillValues::Describe.
std::string DescribeNonFinite(vtkIdType number, const char* array, const std::string& effect);

/**
 * @class   SpeedScale
 * @brief   finds the largest of many speeds, and the largest one that belongs to no fill value
 *
 * Fill values, such as 1e20 on land, have the largest speeds, apart from all others. Vectors are
 * taken for fill values if one of these is true:
 * - They are at most one in a hundred, and at least about a thousand times as fast as all others.
 * - They are at most half of all, about ten times as fast as all others, their largest component is
 *   the same number, and most have it in two components or three.
 * - Their largest component is the same number, at least 1e10, they are 1e9 times as fast as all
 *   others, and these are at least one in a hundred.
 * Among fewer than eight vectors there are none. Vectors of length 0 do not count. The result does
 * not depend on the order of the vectors.
 */
class SpeedScale
{
public:
  /// Adds a vector, which is finite.
  void Add(const double vector[3]);
  void Add(const SpeedScale& other);

  /// Adds the speeds of all processes: add and maximize replace the numbers of a vector by their
  /// sums, and their largest, over processes.
  template <typename AddAll, typename MaximizeAll>
  void Unite(AddAll&& add, MaximizeAll&& maximize)
  {
    std::vector<vtkIdType> counts;
    std::vector<double> extremes;
    for (const Bin& bin : this->Bins)
    {
      counts.insert(counts.end(), { bin.Number, bin.Repeated });
      extremes.insert(extremes.end(), { bin.Largest, -bin.Lower, bin.Upper });
    }
    add(counts);
    maximize(extremes);
    for (std::size_t power = 0; power < Powers; ++power)
    {
      const double* extreme = &extremes[3 * power];
      this->Bins[power] = { counts[2 * power], counts[2 * power + 1], extreme[0], -extreme[1],
        extreme[2] };
    }
  }

  /// Returns the largest of all speeds; 0 without one.
  double GetLargest() const;

  /// Finds the fill values, and the largest other speed.
  FillValues FindFillValues() const;

private:
  /// The vectors whose speeds have one power of 2.
  struct Bin
  {
    vtkIdType Number = 0;
    /// The number of vectors that have their largest component twice, with a third one that is the
    /// same or small.
    vtkIdType Repeated = 0;
    double Largest = 0.0;
    /// The range of the vectors' largest components.
    double Lower = std::numeric_limits<double>::infinity();
    double Upper = -std::numeric_limits<double>::infinity();

    void Add(const Bin& other);
    bool HasOneValue() const { return this->Lower == this->Upper; }
  };

  static constexpr std::size_t Powers = 2112;

  /// Returns whether the vectors of \a top are fill values. \a above and \a number are the numbers
  /// of vectors from those on and of all vectors, \a gap is the number of powers down to the next
  /// speed.
  static bool AreFillValues(const Bin& top, vtkIdType above, vtkIdType number, std::size_t gap);

  std::array<Bin, Powers> Bins{};
};

/// The speeds in the points of a field, and the number of vectors that are not finite.
struct SpeedCount
{
  SpeedScale Speeds;
  vtkIdType NonFinite = 0;

  void Add(const double vector[3]);
  void Add(const SpeedCount& other);
};

}

#endif
