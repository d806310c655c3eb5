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
 * Both ends are the same build on the same machine, so numbers are sent as raw memory. For broken
 * connections and invalid data, the functions return false; they never raise a signal or an
 * exception.
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
  /// Receives a solution. Returns false if an index is not the index of a point, or a neighbor not
  /// the index of a tetrahedron.
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
