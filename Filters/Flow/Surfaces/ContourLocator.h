// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_ContourLocator_h
#define interlume_ContourLocator_h

#include <array>
#include <limits>
#include <utility>
#include <vector>

namespace interlume
{

/**
 * @class   ContourLocator
 * @brief   finds the nearest position on curves in the parameter plane
 */
class ContourLocator
{
public:
  using Parameters = std::array<double, 2>;

  struct Curve
  {
    /// At least two points, as in LevelContours.
    std::vector<Parameters> Points;
    /// Arc length from the first point to each point.
    std::vector<double> Lengths;
  };

  struct Location
  {
    /// Index of the curve; -1 if there are no curves.
    int Curve = -1;
    double Length = 0.0;
  };

  /// In a periodic direction, parameters that differ by integers are the same position.
  ContourLocator(std::vector<Curve> curves, std::array<bool, 2> isPeriodic);

  /// Finds the nearest position on any curve; among equally near ones, the first.
  Location Find(const Parameters& location) const;
  /// Finds the nearest position on one curve.
  Location Find(const Parameters& location, int curve) const;

private:
  static constexpr int NumberOfBins = 64;

  struct Nearest
  {
    double Distance2 = std::numeric_limits<double>::infinity();
    int Segment = -1;
    Location Best;
  };

  void Compare(const Parameters& location, int curve, int segment, Nearest& nearest) const;
  /// Returns the bin of a parameter, which may be outside the range of bins.
  static int GetBin(double parameter);
  /// Returns \a bin moved into the range of bins: wrapped in a periodic direction, clamped in
  /// others.
  int WrapBin(int bin, int direction) const;

  std::vector<Curve> Curves;
  std::array<bool, 2> IsPeriodic;
  // Segments near each bin, as indices of the curve and of the segment's first point.
  std::vector<std::vector<std::pair<int, int>>> Bins;
};

}

#endif
