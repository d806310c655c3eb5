// SPDX-License-Identifier: BSD-3-Clause
#include "TetGen/TetGenChannel.h"

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <new>
#include <stdexcept>

#include <poll.h>
#include <sys/socket.h>

namespace interlume
{

namespace
{
/// Number sent before each list. If it is missing, the other program is not the worker.
constexpr std::uint64_t ListMark = 0x496e7465726c756dU;
/// Interval between calls of WaitCallback, in milliseconds.
constexpr int WaitMilliseconds = 100;

bool AreIndices(const std::vector<int>& list, int lowest, std::size_t end)
{
  return std::all_of(list.begin(), list.end(),
    [lowest, end](int index) { return index >= lowest && index < static_cast<std::int64_t>(end); });
}

bool IsConsistent(const TetGenSolution& solution)
{
  const std::size_t points = solution.Points.size() / 3;
  return solution.Points.size() % 3 == 0 && solution.Tetrahedra.size() % 4 == 0 &&
    solution.Neighbors.size() == solution.Tetrahedra.size() &&
    solution.Triangles.size() == 3 * solution.Markers.size() &&
    AreIndices(solution.Tetrahedra, 0, points) && AreIndices(solution.Triangles, 0, points) &&
    AreIndices(solution.Neighbors, -1, solution.Tetrahedra.size() / 4);
}
}

TetGenChannel::TetGenChannel(int socket, WaitCallback callback)
  : Socket(socket)
  , MayWait(std::move(callback))
{
}

bool TetGenChannel::Wait(short event)
{
  for (;;)
  {
    pollfd ready = { this->Socket, event, 0 };
    const int number = ::poll(&ready, 1, WaitMilliseconds);
    if (number > 0)
    {
      return true;
    }
    if (number < 0 && errno != EINTR)
    {
      return false;
    }
    if (this->MayWait && !this->MayWait())
    {
      return false;
    }
  }
}

bool TetGenChannel::SendBytes(const void* data, std::size_t size)
{
  const char* at = static_cast<const char*>(data);
  while (size > 0)
  {
    const ssize_t sent = ::send(this->Socket, at, size, MSG_NOSIGNAL | MSG_DONTWAIT);
    if (sent > 0)
    {
      at += sent;
      size -= static_cast<std::size_t>(sent);
    }
    else if (!(sent < 0 && (errno == EAGAIN || errno == EINTR) && this->Wait(POLLOUT)))
    {
      return false;
    }
  }
  return true;
}

bool TetGenChannel::ReceiveBytes(void* data, std::size_t size)
{
  char* at = static_cast<char*>(data);
  while (size > 0)
  {
    const ssize_t received = ::recv(this->Socket, at, size, MSG_DONTWAIT);
    if (received > 0)
    {
      at += received;
      size -= static_cast<std::size_t>(received);
    }
    else if (!(received < 0 && (errno == EAGAIN || errno == EINTR) && this->Wait(POLLIN)))
    {
      return false;
    }
  }
  return true;
}

template <typename List>
bool TetGenChannel::SendList(const List& list)
{
  const std::uint64_t head[2] = { ListMark, list.size() };
  return this->SendBytes(head, sizeof(head)) &&
    this->SendBytes(list.data(), list.size() * sizeof(typename List::value_type));
}

template <typename List>
bool TetGenChannel::ReceiveList(List& list)
{
  std::uint64_t head[2];
  if (!this->ReceiveBytes(head, sizeof(head)) || head[0] != ListMark)
  {
    return false;
  }
  try
  {
    list.resize(head[1]);
  }
  catch (const std::bad_alloc&)
  {
    return false;
  }
  catch (const std::length_error&)
  {
    return false;
  }
  return this->ReceiveBytes(list.data(), list.size() * sizeof(typename List::value_type));
}

bool TetGenChannel::Send(const TetGenProblem& problem)
{
  return this->SendList(problem.Switches) && this->SendList(problem.Points) &&
    this->SendList(problem.Triangles) && this->SendList(problem.Markers) &&
    this->SendList(problem.Tetrahedra);
}

bool TetGenChannel::Receive(TetGenProblem& problem)
{
  return this->ReceiveList(problem.Switches) && this->ReceiveList(problem.Points) &&
    this->ReceiveList(problem.Triangles) && this->ReceiveList(problem.Markers) &&
    this->ReceiveList(problem.Tetrahedra);
}

bool TetGenChannel::Send(const TetGenSolution& solution)
{
  return this->SendBytes(&solution.Code, sizeof(solution.Code)) &&
    this->SendList(solution.Points) && this->SendList(solution.Tetrahedra) &&
    this->SendList(solution.Neighbors) && this->SendList(solution.Triangles) &&
    this->SendList(solution.Markers);
}

bool TetGenChannel::Receive(TetGenSolution& solution)
{
  return this->ReceiveBytes(&solution.Code, sizeof(solution.Code)) &&
    this->ReceiveList(solution.Points) && this->ReceiveList(solution.Tetrahedra) &&
    this->ReceiveList(solution.Neighbors) && this->ReceiveList(solution.Triangles) &&
    this->ReceiveList(solution.Markers) && IsConsistent(solution);
}

}
