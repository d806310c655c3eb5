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

/// Vectors that are presumably fill values.
struct FillValues
{
  vtkIdType Number = 0;
  /// Largest-magnitude component of the vectors in the most numerous group of fill values, or 0 if
  /// it differs between them. Groups are separated by gaps in speed.
  double Value = 0.0;
  /// Largest speed of all vectors.
  double LargestSpeed = 0.0;
  /// Largest speed of the vectors that are not fill values.
  double Scale = 0.0;

  /// Returns a warning that ends with a remedy. \a array is the name of the vectors and may be
  /// null. \a effect is a sentence about the treatment of fill values.
  std::string Describe(const char* array, const std::string& effect) const;
};

/// Returns a warning about \a number points with NaN or infinite vectors, or an empty string if \a
/// number is 0. For \a array and \a effect see FillValues::Describe.
std::string DescribeNonFinite(vtkIdType number, const char* array, const std::string& effect);

/**
 * @class   SpeedScale
 * @brief   finds the largest of many speeds and the largest speed that is not a fill value
 *
 * Fill values, such as 1e20 on land, have the largest speeds, separate from all others. Vectors
 * count as fill values if one of these conditions holds:
 * - At most 1% of all vectors have these speeds, and they are at least about 1000 times as fast as
 *   the others.
 * - At most half of all vectors have these speeds, they are at least about 10 times as fast as the
 *   others, their largest components are the same number, and at least half of them contain it two
 *   or three times.
 * - Their largest components are the same number, at least 1e10 in magnitude, they are at least
 *   about 1e9 times as fast as the others, and the others are at least 1% of all vectors.
 *
 * Sets of fewer than eight vectors have no fill values. Zero vectors are ignored. The result does
 * not depend on the order of the vectors.
 */
class SpeedScale
{
public:
  /// Adds a vector, which must be finite.
  void Add(const double vector[3]);
  void Add(const SpeedScale& other);

  /// Combines the speeds of all processes. \a add and \a maximize replace the elements of a vector
  /// with their sums and maxima over all processes.
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

  /// Returns the largest speed, or 0 if there are no vectors.
  double GetLargest() const;

  /// Finds the fill values and the largest other speed.
  FillValues FindFillValues() const;

private:
  /// Vectors whose speeds have the same binary exponent.
  struct Bin
  {
    vtkIdType Number = 0;
    /// Number of vectors that contain their largest component twice, with a third component that is
    /// equal or much smaller.
    vtkIdType Repeated = 0;
    double Largest = 0.0;
    /// Range of the largest-magnitude components of the vectors.
    double Lower = std::numeric_limits<double>::infinity();
    double Upper = -std::numeric_limits<double>::infinity();

    void Add(const Bin& other);
    bool HasOneValue() const { return this->Lower == this->Upper; }
  };

  static constexpr std::size_t Powers = 2112;

  /// Returns true if the vectors of \a top are fill values. \a above is the number of vectors that
  /// are at least as fast, \a number is the number of all vectors, and \a gap is the distance to
  /// the next lower speed in powers of 2.
  static bool AreFillValues(const Bin& top, vtkIdType above, vtkIdType number, std::size_t gap);

  std::array<Bin, Powers> Bins{};
};

/// Speeds at the points of a field, and the number of vectors that are not finite.
struct SpeedCount
{
  SpeedScale Speeds;
  vtkIdType NonFinite = 0;

  void Add(const double vector[3]);
  void Add(const SpeedCount& other);
};

}

#endif
