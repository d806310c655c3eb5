// SPDX-License-Identifier: BSD-3-Clause
#include "Streams/RankExchange.h"

#include "vtkCommunicator.h"
#include "vtkMultiProcessController.h"

#if VTK_MODULE_ENABLE_VTK_ParallelDIY
#include "vtkDIYUtilities.h"
#endif

#include <numeric>

namespace interlume
{

bool RankExchange::IsPossible(vtkMultiProcessController* controller)
{
#if VTK_MODULE_ENABLE_VTK_ParallelDIY
  return controller && controller->GetNumberOfProcesses() > 1 &&
    vtkDIYUtilities::GetCommunicator(controller).size() == controller->GetNumberOfProcesses();
#else
  static_cast<void>(controller);
  return false;
#endif
}

RankExchange::RankExchange(vtkMultiProcessController* controller)
  : Controller(controller)
  , Rank(controller->GetLocalProcessId())
  , NumberOfRanks(controller->GetNumberOfProcesses())
{
}

void RankExchange::ReduceSum(std::vector<vtkIdType>& numbers)
{
  const std::vector<vtkIdType> own = numbers;
  this->Controller->AllReduce(
    own.data(), numbers.data(), static_cast<vtkIdType>(own.size()), vtkCommunicator::SUM_OP);
}

void RankExchange::ReduceMax(std::vector<double>& numbers)
{
  const std::vector<double> own = numbers;
  this->Controller->AllReduce(
    own.data(), numbers.data(), static_cast<vtkIdType>(own.size()), vtkCommunicator::MAX_OP);
}

void RankExchange::Unite(double bounds[6])
{
  std::vector<double> ends(6);
  const auto negateLower = [](std::size_t i, double end) { return i % 2 ? end : -end; };
  for (std::size_t i = 0; i < 6; ++i)
  {
    ends[i] = negateLower(i, bounds[i]);
  }
  this->ReduceMax(ends);
  for (std::size_t i = 0; i < 6; ++i)
  {
    bounds[i] = negateLower(i, ends[i]);
  }
}

bool RankExchange::IsAnywhere(bool here)
{
  std::vector<vtkIdType> number{ here ? 1 : 0 };
  this->ReduceSum(number);
  return number[0] > 0;
}

std::vector<RankExchange::Bytes> RankExchange::Gather(const Bytes& own)
{
  const auto ranks = static_cast<std::size_t>(this->NumberOfRanks);
  std::vector<vtkIdType> sizes(ranks, 0);
  sizes[static_cast<std::size_t>(this->Rank)] = static_cast<vtkIdType>(own.size());
  this->ReduceSum(sizes);
  std::vector<vtkIdType> locations(ranks + 1, 0);
  std::partial_sum(sizes.begin(), sizes.end(), locations.begin() + 1);
  Bytes all(static_cast<std::size_t>(locations.back()));
  this->Controller->AllGatherV(
    own.data(), all.data(), static_cast<vtkIdType>(own.size()), sizes.data(), locations.data());
  std::vector<Bytes> gathered;
  for (std::size_t rank = 0; rank < ranks; ++rank)
  {
    gathered.emplace_back(all.begin() + locations[rank], all.begin() + locations[rank + 1]);
  }
  return gathered;
}

Error RankExchange::FindFirst(const Error& error)
{
  // The first character of the text is the error code.
  const std::string first = this->FindFirstText(
    error ? static_cast<char>(error.GetCode()) + error.GetMessage() : std::string());
  return first.empty() ? Error() : Error(first.substr(1), static_cast<ErrorCode>(first[0]));
}

std::string RankExchange::FindFirstText(const std::string& text)
{
  const int own = text.empty() ? this->NumberOfRanks : this->Rank;
  int first = own;
  this->Controller->AllReduce(&own, &first, 1, vtkCommunicator::MIN_OP);
  if (first == this->NumberOfRanks)
  {
    return {};
  }
  int length = static_cast<int>(text.size());
  this->Controller->Broadcast(&length, 1, first);
  std::string found = text;
  found.resize(static_cast<std::size_t>(length));
  this->Controller->Broadcast(&found[0], length, first);
  return found;
}

void RankExchange::Run(const Work& work)
{
#if VTK_MODULE_ENABLE_VTK_ParallelDIY
  struct Block
  {
  };
  Block block;
  diy::mpi::communicator communicator = vtkDIYUtilities::GetCommunicator(this->Controller);
  diy::Master master(communicator, 1);
  // Link all processes: a streamline continues in an adjacent partition, but any process may need
  // its start position or its result.
  auto* link = new diy::Link;
  for (int rank = 0; rank < this->NumberOfRanks; ++rank)
  {
    if (rank != this->Rank)
    {
      link->add_neighbor(diy::BlockID{ rank, rank });
    }
  }
  master.add(this->Rank, &block, link);
  std::vector<Bytes> sent(static_cast<std::size_t>(this->NumberOfRanks));
  Bytes received;
  master.iexchange(
    [&](Block*, const diy::Master::ProxyWithLink& proxy)
    {
      received.clear();
      std::vector<int> senders;
      proxy.incoming(senders);
      for (const int sender : senders)
      {
        diy::MemoryBuffer& queue = proxy.incoming(sender);
        received.insert(received.end(),
          queue.buffer.begin() + static_cast<std::ptrdiff_t>(queue.position), queue.buffer.end());
        queue.wipe();
      }
      const bool isDone = work(received, sent);
      for (int rank = 0; rank < this->NumberOfRanks; ++rank)
      {
        Bytes& message = sent[static_cast<std::size_t>(rank)];
        if (!message.empty())
        {
          proxy.enqueue(diy::BlockID{ rank, rank }, message.data(), message.size());
          message.clear();
        }
      }
      return isDone;
    });
#else
  static_cast<void>(work);
#endif
}

}
