// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_RankExchange_h
#define interlume_RankExchange_h

#include "Common/Error.h"

#include "vtkType.h"

#include <functional>
#include <string>
#include <vector>

class vtkMultiProcessController;

namespace interlume
{

/**
 * @class   RankExchange
 * @brief   communication between the processes of a controller, using VTK's DIY module
 *
 * All members except the getters and IsPossible are collective: every process must call them in the
 * same order.
 */
class RankExchange
{
public:
  using Bytes = std::vector<char>;

  /// Returns true if the processes of \a controller can communicate: there are several processes,
  /// and VTK has the DIY module.
  static bool IsPossible(vtkMultiProcessController* controller);

  explicit RankExchange(vtkMultiProcessController* controller);

  int GetRank() const { return this->Rank; }
  int GetNumberOfRanks() const { return this->NumberOfRanks; }

  /// Replaces numbers with their sums over all processes.
  void ReduceSum(std::vector<vtkIdType>& numbers);
  /// Replaces numbers with their maxima over all processes.
  void ReduceMax(std::vector<double>& numbers);
  /// Replaces bounds (xmin, xmax, ymin, ...) with the union of the bounds of all processes.
  void Unite(double bounds[6]);
  /// Returns true if \a here is true in any process.
  bool IsAnywhere(bool here);
  /// Gathers the bytes of all processes.
  std::vector<Bytes> Gather(const Bytes& own);
  /// Returns the error (code and message) of the first process that has one.
  Error FindFirst(const Error& error);
  /// Returns the text of the first process whose text is not empty.
  std::string FindFirstText(const std::string& text);

  /**
   * Calls work(received, sent) repeatedly until all processes are done and all messages have been
   * received. \a received contains complete messages from any process. Bytes appended to sent[r]
   * are sent to process r. \a work returns true if it is idle until it receives a message.
   */
  using Work = std::function<bool(const Bytes& received, std::vector<Bytes>& sent)>;
  void Run(const Work& work);

private:
  vtkMultiProcessController* Controller;
  int Rank;
  int NumberOfRanks;
};

}

#endif
