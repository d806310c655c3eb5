// SPDX-License-Identifier: BSD-3-Clause
#include "Pieces/PieceExchange.h"

#include "vtkCommunicator.h"
#include "vtkMultiProcessController.h"

#include <algorithm>
#include <limits>
#include <set>

namespace interlume
{

PieceExchange::PieceExchange(
  vtkMultiProcessController* controller, int blend, const std::array<double, 6>& bounds)
  : Controller(controller)
  , Blend(blend)
  , Bounds(bounds)
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

template <typename Number>
void PieceExchange::Reduce(std::vector<Number>& numbers, int operation) const
{
  const std::vector<Number> own = numbers;
  this->Controller->AllReduce(
    own.data(), numbers.data(), static_cast<vtkIdType>(own.size()), operation);
}

void PieceExchange::Add(std::vector<float>& numbers) const
{
  this->Reduce(numbers, vtkCommunicator::SUM_OP);
}

void PieceExchange::Maximize(std::vector<int>& numbers) const
{
  this->Reduce(numbers, vtkCommunicator::MAX_OP);
}

void PieceExchange::Maximize(std::vector<float>& numbers) const
{
  this->Reduce(numbers, vtkCommunicator::MAX_OP);
}

void PieceExchange::Minimize(std::vector<int>& numbers) const
{
  this->Reduce(numbers, vtkCommunicator::MIN_OP);
}

void PieceExchange::Minimize(std::vector<float>& numbers) const
{
  this->Reduce(numbers, vtkCommunicator::MIN_OP);
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

}
