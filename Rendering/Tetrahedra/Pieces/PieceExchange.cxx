// SPDX-License-Identifier: BSD-3-Clause
#include "Pieces/PieceExchange.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <set>
#include <utility>

namespace interlume
{

namespace
{
constexpr int PASS_TAG = 0x1717;
}

PieceExchange::PieceExchange(vtkMultiProcessController* controller, int blend,
  const std::array<double, 6>& bounds, std::unique_ptr<PieceOrder> boxes)
  : Controller(controller)
  , Blend(blend)
  , Bounds(bounds)
  , Order(std::move(boxes))
{
}

int PieceExchange::GetRank() const
{
  return this->Controller->GetLocalProcessId();
}

int PieceExchange::GetNumberOfRanks() const
{
  return this->Controller->GetNumberOfProcesses();
}

std::vector<int> PieceExchange::Unite(const std::vector<int>& numbers) const
{
  // All processes must send the same count. Shorter lists are padded with duplicates, empty lists
  // with `none`.
  constexpr int none = std::numeric_limits<int>::lowest();
  std::vector<int> maximum{ static_cast<int>(numbers.size()) };
  this->ReduceMax(maximum);
  if (maximum[0] == 0)
  {
    return {};
  }
  const auto length = static_cast<std::size_t>(maximum[0]);
  std::vector<int> sent = numbers;
  sent.resize(length, numbers.empty() ? none : numbers.back());
  std::vector<int> received(length * static_cast<std::size_t>(this->GetNumberOfRanks()));
  this->Controller->AllGather(sent.data(), received.data(), static_cast<vtkIdType>(length));
  std::set<int> united(received.begin(), received.end());
  united.erase(none);
  return { united.begin(), united.end() };
}

std::vector<float> PieceExchange::Pass(
  const std::vector<float>& numbers, const std::vector<int>& order, int distance) const
{
  const auto found = std::find(order.begin(), order.end(), this->GetRank());
  const int position = static_cast<int>(found - order.begin());
  const auto length = static_cast<vtkIdType>(numbers.size());
  const auto send = [&]()
  {
    if (order.end() - found > distance)
    {
      this->Controller->Send(numbers.data(), length, *(found + distance), PASS_TAG);
    }
  };
  std::vector<float> received;
  // Of each pair of processes, one receives while the other sends, to avoid deadlocks.
  const bool isFirst = position / distance % 2 == 0;
  if (isFirst)
  {
    send();
  }
  if (position >= distance)
  {
    received.resize(numbers.size());
    this->Controller->Receive(received.data(), length, *(found - distance), PASS_TAG);
  }
  if (!isFirst)
  {
    send();
  }
  return received;
}

void PieceExchange::Composite(std::vector<float>& colors, const std::vector<int>& order) const
{
  // Compute the transmittance of all processes in front of this one, by a prefix product in
  // log2(processes) steps.
  std::vector<float> transmittance(colors.size() / 4);
  for (std::size_t p = 0; p < transmittance.size(); ++p)
  {
    transmittance[p] = 1.0f - colors[4 * p + 3];
  }
  std::vector<float> front = this->Pass(transmittance, order, 1);
  front.resize(transmittance.size(), 1.0f);
  for (int distance = 1; distance < this->GetNumberOfRanks(); distance *= 2)
  {
    const std::vector<float> previous = this->Pass(front, order, distance);
    std::transform(
      previous.begin(), previous.end(), front.begin(), front.begin(), std::multiplies<float>());
  }
  for (std::size_t p = 0; p < transmittance.size(); ++p)
  {
    for (std::size_t c = 4 * p; c < 4 * p + 4; ++c)
    {
      colors[c] *= front[p];
    }
  }
  this->ReduceSum(colors);
}

}
