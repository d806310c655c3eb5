// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_TetGenChannel_h
#define interlume_TetGenChannel_h

#include "TetGen/TetGenProblem.h"

#include <functional>

namespace interlume
{

/**
 * @class   TetGenChannel
 * @brief   exchanges problems and solutions over a socket
 *
 * Both programs are from the same build and run on the same machine, so numbers are sent as raw
 * memory. If the connection breaks or the data is invalid, the functions return false; they never
 * raise a signal or throw an exception.
 */
class TetGenChannel
{
public:
  /// Callback that returns false to stop waiting. It is called about ten times per second while no
  /// data arrives.
  using WaitCallback = std::function<bool()>;

  explicit TetGenChannel(int socket, WaitCallback callback = {});

  bool Send(const TetGenProblem& problem);
  bool Send(const TetGenSolution& solution);
  bool Receive(TetGenProblem& problem);
  /// Receives a solution. Returns false if a point index or a neighbor index is out of range.
  bool Receive(TetGenSolution& solution);

private:
  bool Wait(short event);
  bool SendBytes(const void* data, std::size_t size);
  bool ReceiveBytes(void* data, std::size_t size);
  template <typename List>
  bool SendList(const List& list);
  template <typename List>
  bool ReceiveList(List& list);

  int Socket;
  WaitCallback MayWait;
};

}

#endif
