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
 * @brief   solves a diffusion equation on the cells of a box
 *
 * The equation for cell i, with its up to six neighbors j, is
 *
 *   Sink_i x_i + sum_j Coupling_ij (x_i - x_j) = b_i
 *
 * The solver is the conjugate gradient method, preconditioned by one multigrid V-cycle. Coarsening
 * merges pairs of cells along each axis. The coupling between two coarse cells is half the sum of
 * the couplings across their common face, because the distance between cell centers doubles. The
 * result does not depend on the number of threads.
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
   * Improves \a x until the residual is at most \a tolerance times the Euclidean norm of b, or
   * until \a maximumCycles conjugate gradient iterations are done. Sets \a cycles to the number of
   * iterations. Returns the relative residual.
   */
  double Solve(const std::vector<double>& b, std::vector<double>& x, double tolerance,
    int maximumCycles, int& cycles);

private:
  struct Level
  {
    glm::ivec3 Cells{ 1 };
    std::array<std::vector<double>, 3> Coupling;
    std::vector<double> Sink;
    /// For each cell, the reciprocal of the sum of its sink and couplings.
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
  void RunVCycle(std::size_t level);

  std::vector<Level> Levels;
};

}

#endif
