// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_TetGenChannel_h
#define interlume_TetGenChannel_h

#include "TetGen/TetGenProblem.h"

#include <functional>

namespace interlume
{

/**
 * @class   TetGenChannel
 * @brief   problems and solutions over a socket, for both of its ends
 *
 * Both ends are of one build on one machine, so numbers travel as they lie in memory. Nothing here
 * raises a signal or throws for what the other end does: a broken or wrong stream gives false.
 */
class TetGenChannel
{
public:
  /// A function that is asked some ten times a second while the other end has nothing to say; false
  /// gives up.
  using Patience = std::function<bool()>;

  explicit TetGenChannel(int socket, Patience patience = {});

  bool Send(const TetGenProblem& problem);
  bool Send(const TetGenSolution& solution);
  bool Receive(TetGenProblem& problem);
  /// Receives a solution, and checks that every index is one of a point, and every neighbour one of
  /// a tetrahedron.
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
  Patience IsPatient;
};

}

#endif
