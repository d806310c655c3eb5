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
 * @brief   extracts contours of a function of two parameters by marching squares
 *
 * The function is sampled once on a grid of squares over [0, 1]^2. Each level is then traced from
 * square to square. Contour points lie on grid edges, where the function equals the level up to
 * rounding error. Ambiguous squares are resolved by the value at their center. Squares with a
 * corner value that is not finite have no contour.
 */
class LevelContours
{
public:
  using Parameters = std::array<double, 2>;
  using Function = std::function<double(double u, double v)>;

  struct Contour
  {
    /// Points of the contour, with values at or above the level on its left. Periodic parameters
    /// may be outside [0, 1]. The last point of a closed contour equals the first, or differs from
    /// it by whole periods.
    std::vector<Parameters> Points;
    bool IsClosed = false;
  };

  /// Samples the function on \a resolution squares along each parameter. In a periodic direction, 0
  /// and 1 are the same position.
  LevelContours(Function function, int resolution, std::array<bool, 2> isPeriodic);

  /// Returns the contours of a level in the order of grid edges, open contours first.
  std::vector<Contour> Follow(double level) const;

private:
  /// A grid edge from node (i, j) along u or v.
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
  /// Returns, for each edge, the next edge along its contour, or -1 if there is none.
  std::vector<int> FindNext(double level) const;
  void LinkSquareEdges(int i, int j, double level, std::vector<int>& next) const;

  Function Evaluate;
  int Resolution;
  std::array<bool, 2> IsPeriodic;
  std::vector<double> Values;
};

}

#endif
