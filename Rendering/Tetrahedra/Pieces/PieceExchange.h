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
 * @brief   communication between processes that each draw a partition of a volume
 *
 * ReduceSum, ReduceMax, ReduceMin, Unite and Composite are collective: all processes must call them
 * in the same order. Arrays must have the same length in all processes, except in Unite.
 */
class PieceExchange
{
public:
  /**
   * \a blend is the blend mode of all partitions, not AUTOMATIC_BLEND. \a bounds enclose all
   * partitions. \a boxes computes the visibility order of the processes; null if \a blend needs no
   * order.
   */
  PieceExchange(vtkMultiProcessController* controller, int blend,
    const std::array<double, 6>& bounds, std::unique_ptr<PieceOrder> boxes);

  int GetBlend() const { return this->Blend; }
  const std::array<double, 6>& GetBounds() const { return this->Bounds; }
  const PieceOrder* GetOrder() const { return this->Order.get(); }
  int GetRank() const;
  int GetNumberOfRanks() const;

  ///@{
  /// Replace each number with its sum, maximum or minimum over all processes.
  template <typename Number>
  void ReduceSum(std::vector<Number>& numbers) const
  {
    this->Reduce(numbers, vtkCommunicator::SUM_OP);
  }
  template <typename Number>
  void ReduceMax(std::vector<Number>& numbers) const
  {
    this->Reduce(numbers, vtkCommunicator::MAX_OP);
  }
  template <typename Number>
  void ReduceMin(std::vector<Number>& numbers) const
  {
    this->Reduce(numbers, vtkCommunicator::MIN_OP);
  }
  ///@}
  /// Returns the set union of the numbers of all processes, ascending.
  std::vector<int> Unite(const std::vector<int>& numbers) const;
  /**
   * Replaces RGBA values, premultiplied by opacity, with the composite of all processes. \a order
   * lists the processes from front to back, and must be the same in all processes.
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
   * Sends \a numbers to the process that is \a distance positions behind this process in \a order.
   * Returns the numbers of the process that is \a distance positions in front; empty if there is no
   * such process.
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
