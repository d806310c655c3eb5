// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_DiffusionGrid_h
#define interlume_DiffusionGrid_h

#include <array>
#include <cstddef>
#include <vector>

#include <glm/vec3.hpp>

namespace interlume
{

/**
 * @class   DiffusionGrid
 * @brief   solves diffusion equations on the cells of a box
 *
 *   Sink_i x_i + sum_j Coupling_ij (x_i - x_j) = b_i   over the up to six neighbors j of cell i
 *
 * The solver is the conjugate gradient method, preconditioned by one multigrid V-cycle. Coarsening
 * merges two cells along each axis. The coupling of two merged cells is half the sum of the
 * couplings across their common face, because the distance of the cell centers doubles. The result
 * does not depend on the number of threads.
 */
class DiffusionGrid
{
public:
  explicit DiffusionGrid(const glm::ivec3& cells);

  /// Returns the couplings of each cell to its upper neighbor along each axis.
  std::array<std::vector<double>, 3>& GetCouplings() { return this->Levels.front().Coupling; }
  std::vector<double>& GetSink() { return this->Levels.front().Sink; }
  /// Builds the multigrid levels. Call this after setting couplings and sinks.
  void Prepare();

  /**
   * Improves \a x until the residual is at most \a tolerance times the Euclidean norm of b, or for
   * at most \a maximumCycles cycles. Returns the relative residual and sets \a cycles to the number
   * of cycles done.
   */
  double Solve(const std::vector<double>& b, std::vector<double>& x, double tolerance,
    int maximumCycles, int& cycles);

private:
  struct Level
  {
    glm::ivec3 Cells{ 1 };
    std::array<std::vector<double>, 3> Coupling;
    std::vector<double> Sink;
    /// Reciprocal of the sum of the sink and the couplings.
    std::vector<double> Inverse;
    std::vector<double> Solution;
    std::vector<double> Source;
  };

  static void Allocate(Level& level, const glm::ivec3& cells);
  static void Coarsen(const Level& fine, Level& coarse);
  static double SumOverNeighbors(
    const Level& level, const std::vector<double>& x, int i, int j, int k);
  static void Smooth(Level& level, int color);
  static void Multiply(const Level& level, const std::vector<double>& x, std::vector<double>& y);
  void Cycle(std::size_t level);

  std::vector<Level> Levels;
};

}

#endif
