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
  // All send as many as the one that has the most; what is missing repeats one that is there.
  constexpr int none = std::numeric_limits<int>::lowest();
  std::vector<int> most{ static_cast<int>(numbers.size()) };
  this->Maximize(most);
  if (most[0] == 0)
  {
    return {};
  }
  const auto length = static_cast<std::size_t>(most[0]);
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
  const int place = static_cast<int>(found - order.begin());
  const auto length = static_cast<vtkIdType>(numbers.size());
  const auto send = [&]()
  {
    if (order.end() - found > distance)
    {
      this->Controller->Send(numbers.data(), length, *(found + distance), PASS_TAG);
    }
  };
  std::vector<float> received;
  // One of every two that are the distance apart waits while the other sends.
  const bool isFirst = place / distance % 2 == 0;
  if (isFirst)
  {
    send();
  }
  if (place >= distance)
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
  // How much is seen through all that is before: a product over ever longer runs of the order.
  std::vector<float> through(colors.size() / 4);
  for (std::size_t p = 0; p < through.size(); ++p)
  {
    through[p] = 1.0f - colors[4 * p + 3];
  }
  std::vector<float> front = this->Pass(through, order, 1);
  front.resize(through.size(), 1.0f);
  for (int distance = 1; distance < this->GetNumberOfRanks(); distance *= 2)
  {
    const std::vector<float> before = this->Pass(front, order, distance);
    std::transform(
      before.begin(), before.end(), front.begin(), front.begin(), std::multiplies<float>());
  }
  for (std::size_t p = 0; p < through.size(); ++p)
  {
    for (std::size_t c = 4 * p; c < 4 * p + 4; ++c)
    {
      colors[c] *= front[p];
    }
  }
  this->Add(colors);
}

}
