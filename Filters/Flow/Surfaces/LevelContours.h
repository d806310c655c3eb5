// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_LevelContours_h
#define interlume_LevelContours_h

#include <array>
#include <functional>
#include <vector>

namespace interlume
{

/**
 * @class   LevelContours
 * @brief   curves of a level of a function of two parameters from 0 to 1, by marching squares
 *
 * The function is sampled once on a grid of squares; each level is then followed from square to
 * square. Points of a curve lie on edges of the grid, where the function takes the level within
 * rounding. Saddles are decided by the value in the middle of the square. Squares with a corner at
 * which the function is not finite have no curve.
 */
class LevelContours
{
public:
  using Parameters = std::array<double, 2>;
  using Function = std::function<double(double u, double v)>;

  struct Contour
  {
    /// The points of the contour. Values at the level and above are on its left. Periodic
    /// parameters go on beyond 0 to 1; the last point of a closed contour is the first, but for
    /// whole periods.
    std::vector<Parameters> Points;
    bool IsClosed = false;
  };

  /// Samples the function on \a resolution squares along each parameter; where \a isPeriodic, 0 and
  /// 1 are the same place.
  LevelContours(Function function, int resolution, std::array<bool, 2> isPeriodic);

  /// Returns the contours of a level in the order of the grid's edges, open contours first.
  std::vector<Contour> Follow(double level) const;

private:
  /// An edge of the grid: the one of node (i, j) along u or v.
  struct Edge
  {
    int I;
    int J;
    int Direction;
  };

  double GetValue(int i, int j) const;
  int GetIndex(Edge edge) const;
  Edge GetEdge(int index) const;
  Parameters GetCrossing(Edge edge, double level) const;
  /// Finds for each edge the next one of its contour, or -1.
  std::vector<int> FindNext(double level) const;
  void FollowSquare(int i, int j, double level, std::vector<int>& next) const;

  Function Evaluate;
  int Resolution;
  std::array<bool, 2> IsPeriodic;
  std::vector<double> Values;
};

}

#endif
