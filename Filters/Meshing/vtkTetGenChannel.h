#ifndef vtkTetGenChannel_h
#define vtkTetGenChannel_h

#include "vtkTetGenProblem.h"

#include <functional>

/**
 * @class   vtkTetGenChannel
 * @brief   problems and solutions over a socket, for both of its ends
 *
 * Both ends are of one build on one machine, so numbers travel as they lie in memory. Nothing here
 * raises a signal or throws for what the other end does: a broken or wrong stream gives false.
 */
class vtkTetGenChannel
{
public:
  /// Asked some ten times a second while the other end has nothing to say; false gives up.
  using Patience = std::function<bool()>;

  explicit vtkTetGenChannel(int socket, Patience patience = {});

  bool Send(const vtkTetGenProblem& problem);
  bool Send(const vtkTetGenSolution& solution);
  bool Receive(vtkTetGenProblem& problem);
  /// Also checks that every index is one of a point, and every neighbour one of a tetrahedron.
  bool Receive(vtkTetGenSolution& solution);

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

#endif
