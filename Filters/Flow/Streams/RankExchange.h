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
 * @brief   what the processes of a controller tell each other, by VTK's DIY
 *
 * All members but those that ask for a number are collective: every process calls them, in the same
 * order.
 */
class RankExchange
{
public:
  using Bytes = std::vector<char>;

  /// Returns whether the processes of \a controller can exchange anything: there are several, and
  /// VTK has DIY.
  static bool IsPossible(vtkMultiProcessController* controller);

  explicit RankExchange(vtkMultiProcessController* controller);

  int GetRank() const { return this->Rank; }
  int GetNumberOfRanks() const { return this->NumberOfRanks; }

  /// Replaces numbers by their sums over all processes.
  void Add(std::vector<vtkIdType>& numbers);
  /// Replaces numbers by the largest of all processes.
  void Maximize(std::vector<double>& numbers);
  /// Replaces lower and upper x, y, z by those of the box around the boxes of all processes.
  void Unite(double bounds[6]);
  /// Returns whether anything is so in any process.
  bool IsAnywhere(bool here);
  /// Returns the bytes of each process.
  std::vector<Bytes> Gather(const Bytes& own);
  /// Returns the error, code and message, of the first process that has one.
  Error FindFirst(const Error& error);
  /// Returns the text of the first process that has one that is not empty.
  std::string FindFirstText(const std::string& text);

  /**
   * Calls work(received, sent) again and again until nobody has anything left to do and all that
   * was sent has been received. \a received are bytes from any processes, messages in one piece;
   * what is appended to sent[r] goes to process r. \a work returns whether it is done until it
   * receives something.
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
