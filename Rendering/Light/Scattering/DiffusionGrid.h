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
 * @brief   solves the equations of diffusion between the cells of a box
 *
 *   Sink_i x_i + sum_j Coupling_ij (x_i - x_j) = b_i   over the up to six neighbours j of cell i,
 *
 * by conjugate gradients, preconditioned by one V-cycle of multigrid: cells are joined two by two
 * along each axis, and the couplings between joined cells are half of the sum, as their distance is
 * twice as large. The result is the same for any number of threads.
 */
class DiffusionGrid
{
public:
  explicit DiffusionGrid(const glm::ivec3& cells);

  /// Along each axis, that of a cell to its upper neighbour.
  std::array<std::vector<double>, 3>& GetCouplings() { return this->Levels.front().Coupling; }
  std::vector<double>& GetSink() { return this->Levels.front().Sink; }
  /// To be called once couplings and sinks are set.
  void Prepare();

  /**
   * Improves \a x until the residual is at most \a tolerance times b, in the Euclidean norm, or for
   * so many cycles. Returns the residual over b; \a cycles becomes the number that was needed.
   */
  double Solve(const std::vector<double>& b, std::vector<double>& x, double tolerance,
    int maximumCycles, int& cycles);

private:
  struct Level
  {
    glm::ivec3 Cells{ 1 };
    std::array<std::vector<double>, 3> Coupling;
    std::vector<double> Sink;
    /// One over the sum of the sink and the couplings.
    std::vector<double> Inverse;
    std::vector<double> Solution;
    std::vector<double> Source;
  };

  static void Allocate(Level& level, const glm::ivec3& cells);
  static void Coarsen(const Level& fine, Level& coarse);
  static double Neighbours(const Level& level, const std::vector<double>& x, int i, int j, int k);
  static void Smooth(Level& level, int color);
  static void Multiply(const Level& level, const std::vector<double>& x, std::vector<double>& y);
  void Cycle(std::size_t level);

  std::vector<Level> Levels;
};

}

#endif
