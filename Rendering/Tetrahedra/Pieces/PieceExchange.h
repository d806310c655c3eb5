// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_PieceExchange_h
#define interlume_PieceExchange_h

#include <array>
#include <vector>

class vtkMultiProcessController;

namespace interlume
{

/**
 * @class   PieceExchange
 * @brief   what the processes tell each other that each draw a piece of one volume
 *
 * Add, Maximize, Minimize and Unite are collective: every process calls them, in the same order,
 * with as many numbers.
 */
class PieceExchange
{
public:
  /**
   * \a blend is the blend mode of all pieces, none of its choices left open; \a bounds is the box
   * around them.
   */
  PieceExchange(
    vtkMultiProcessController* controller, int blend, const std::array<double, 6>& bounds);

  int GetBlend() const { return this->Blend; }
  const std::array<double, 6>& GetBounds() const { return this->Bounds; }
  int GetRank() const;
  int GetNumberOfRanks() const;

  /// Replaces numbers by their sums over all processes.
  void Add(std::vector<float>& numbers) const;
  ///@{
  /**
   * Replaces numbers by the largest, or the smallest, of all processes.
   */
  void Maximize(std::vector<int>& numbers) const;
  void Maximize(std::vector<float>& numbers) const;
  void Minimize(std::vector<int>& numbers) const;
  void Minimize(std::vector<float>& numbers) const;
  ///@}
  /// Returns the numbers that any process has, each once; every process may have another count.
  std::vector<int> Unite(const std::vector<int>& numbers) const;

private:
  template <typename Number>
  void Reduce(std::vector<Number>& numbers, int operation) const;

  vtkMultiProcessController* Controller;
  int Blend;
  std::array<double, 6> Bounds;
};

}

#endif
