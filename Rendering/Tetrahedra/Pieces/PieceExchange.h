// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_PieceExchange_h
#define interlume_PieceExchange_h

#include "Pieces/PieceOrder.h"

#include "vtkCommunicator.h"
#include "vtkMultiProcessController.h"

#include <array>
#include <memory>
#include <vector>

namespace interlume
{

/**
 * @class   PieceExchange
 * @brief   what the processes tell each other that each draw a piece of one volume
 *
 * Add, Maximize, Minimize, Unite and Composite are collective: every process calls them, in the
 * same order, with as many numbers.
 */
class PieceExchange
{
public:
  /**
   * \a blend is the blend mode of all pieces, none of its choices left open; \a bounds is the box
   * around them. \a boxes has the order of the pieces by process, null where \a blend needs none.
   */
  PieceExchange(vtkMultiProcessController* controller, int blend,
    const std::array<double, 6>& bounds, std::unique_ptr<PieceOrder> boxes);

  int GetBlend() const { return this->Blend; }
  const std::array<double, 6>& GetBounds() const { return this->Bounds; }
  const PieceOrder* GetOrder() const { return this->Order.get(); }
  int GetRank() const;
  int GetNumberOfRanks() const;

  ///@{
  /// Replace numbers by their sums, or the largest or smallest, over all processes.
  template <typename Number>
  void Add(std::vector<Number>& numbers) const
  {
    this->Reduce(numbers, vtkCommunicator::SUM_OP);
  }
  template <typename Number>
  void Maximize(std::vector<Number>& numbers) const
  {
    this->Reduce(numbers, vtkCommunicator::MAX_OP);
  }
  template <typename Number>
  void Minimize(std::vector<Number>& numbers) const
  {
    this->Reduce(numbers, vtkCommunicator::MIN_OP);
  }
  ///@}
  /// Returns the numbers that any process has, each once; every process may have another count.
  std::vector<int> Unite(const std::vector<int>& numbers) const;
  /**
   * Replaces RGBA, colour multiplied by opacity, by what all processes have of it over each other;
   * \a order has the processes from the nearest on, the same in all of them.
   */
  void Composite(std::vector<float>& colors, const std::vector<int>& order) const;

private:
  template <typename Number>
  void Reduce(std::vector<Number>& numbers, int operation) const
  {
    const std::vector<Number> own = numbers;
    this->Controller->AllReduce(
      own.data(), numbers.data(), static_cast<vtkIdType>(own.size()), operation);
  }
  /**
   * Sends numbers to the process that is \a distance places behind in an order, and returns those
   * of the one as far before; none where there is no such process.
   */
  std::vector<float> Pass(
    const std::vector<float>& numbers, const std::vector<int>& order, int distance) const;

  vtkMultiProcessController* Controller;
  int Blend;
  std::array<double, 6> Bounds;
  std::unique_ptr<PieceOrder> Order;
};

}

#endif
