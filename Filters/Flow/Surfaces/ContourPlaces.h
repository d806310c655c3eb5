// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ContourPlaces_h
#define interlume_ContourPlaces_h

#include <array>
#include <limits>
#include <utility>
#include <vector>

namespace interlume
{

/**
 * @class   ContourPlaces
 * @brief   the nearest place on curves in the plane of parameters
 */
class ContourPlaces
{
public:
  using Parameters = std::array<double, 2>;

  struct Curve
  {
    /// The points of the curve, at least two, as in LevelContours.
    std::vector<Parameters> Points;
    /// The length from the first point, for each point.
    std::vector<double> Lengths;
  };

  struct Place
  {
    /// The curve; -1 where there is no curve.
    int Curve = -1;
    double Length = 0.0;
  };

  /// Takes the curves. Where \a isPeriodic, parameters that differ by whole numbers are the same
  /// place.
  ContourPlaces(std::vector<Curve> curves, std::array<bool, 2> isPeriodic);

  /// Finds the nearest place on any curve; among equally near ones the first.
  Place Find(const Parameters& place) const;
  /// Finds the nearest place on one curve.
  Place Find(const Parameters& place, int curve) const;

private:
  static constexpr int NumberOfBins = 64;

  struct Nearest
  {
    double Distance2 = std::numeric_limits<double>::infinity();
    int Segment = -1;
    Place Best;
  };

  void Compare(const Parameters& place, int curve, int segment, Nearest& nearest) const;
  /// Returns the bin of a place along a direction, which may be beyond the bins.
  static int GetBin(double parameter);
  /// Returns the existing bin that stands for one beyond the bins; -1 where there is none.
  int WrapBin(int bin, int direction) const;

  std::vector<Curve> Curves;
  std::array<bool, 2> IsPeriodic;
  // The segments near each bin, by curve and first point.
  std::vector<std::vector<std::pair<int, int>>> Bins;
};

}

#endif
