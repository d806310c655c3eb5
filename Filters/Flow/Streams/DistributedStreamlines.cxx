// SPDX-License-Identifier: BSD-3-Clause
#include "Streams/DistributedStreamlines.h"

#include "Streams/FlowReport.h"
#include "Streams/LocalStreamlines.h"
#include "Streams/MessageBytes.h"
#include "Streams/PartitionedField.h"
#include "Streams/PartitionedCellSearch.h"
#include "Streams/DistributedField.h"
#include "Streams/SampleQueue.h"
#include "Streams/StreamlineIntegrator.h"
#include "Streams/PartitionedStructuredField.h"
#include "Streams/PartitionedUnstructuredField.h"

#include "vtkAlgorithm.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkRectilinearGrid.h"
#include "vtkSMPThreadLocal.h"
#include "vtkSMPTools.h"
#include "vtkStructuredGrid.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <deque>
#include <iterator>
#include <type_traits>
#include <utility>

namespace interlume
{

namespace
{
/// Kinds of messages and their contents:
/// - Start: the start position of a streamline, in a cell of the receiver,
/// - Search: a start position for which several processes search,
/// - Finding: a process's result of a search,
/// - Continue: the state of a streamline to continue,
/// - Result: the result of a streamline,
/// - Aborted: none; the execution was aborted,
/// - Position: a position at which to evaluate the velocity,
/// - Velocity: the velocity at a position.
enum class Kind : int
{
  Start,
  Search,
  Finding,
  Continue,
  Result,
  Aborted,
  Position,
  Velocity
};

/// Process that sent a request, and the index of the streamline or position in that process.
struct Request
{
  int Rank = 0;
  vtkIdType Number = 0;
};

/// Streamline waiting to be traced, or position to search for.
struct QueuedStreamline
{
  Request For;
  /// Start position; unused if State is set.
  double X[3] = { 0.0, 0.0, 0.0 };
  std::unique_ptr<AdvectionState> State;
};

void PutHead(RankExchange::Bytes& bytes, Kind kind, const Request& request)
{
  MessageBytes::Put(bytes, kind);
  MessageBytes::Put(bytes, request.Rank);
  MessageBytes::Put(bytes, request.Number);
}

void PutPosition(RankExchange::Bytes& bytes, const double x[3])
{
  for (int axis = 0; axis < 3; ++axis)
  {
    MessageBytes::Put(bytes, x[axis]);
  }
}

using Outbox = std::vector<RankExchange::Bytes>;

template <typename Walker>
class PartStreamlines final : public DistributedStreamlines
{
public:
  using Field = typename Walker::Field;

  PartStreamlines(DistributedField& ranks, vtkAlgorithm* owner)
    : Ranks(ranks)
    , Exchange(ranks.GetExchange())
    , Owner(owner)
    , Cells(Shared, ranks)
  {
  }

  template <typename Data>
  Error Build(Data* data, vtkDataArray* vectors, const std::vector<vtkDataArray*>& arrays)
  {
    if (Error error = this->Exchange.FindFirst(
          this->Shared.BuildPart(data, vectors, arrays, this->Ranks.GetPart())))
    {
      return error;
    }
    if constexpr (IsUnstructured)
    {
      if (Error error = this->Shared.Join(this->Exchange))
      {
        return error;
      }
      if (this->Shared.GetInterfaces().IsBetweenRanks)
      {
        this->Ranks.SetPartitionError("cell faces do not match between processes");
      }
    }
    else if constexpr (Field::IsSearched)
    {
      this->Shared.Join(this->Exchange);
    }
    SpeedCount speeds = this->Shared.CountOwnSpeeds();
    speeds.Speeds.Unite([this](std::vector<vtkIdType>& numbers)
      { this->Exchange.ReduceSum(numbers); },
      [this](std::vector<double>& largest) { this->Exchange.ReduceMax(largest); });
    std::vector<vtkIdType> nonFinite{ speeds.NonFinite };
    this->Exchange.ReduceSum(nonFinite);
    speeds.NonFinite = nonFinite[0];
    this->Shared.SetSpeeds(speeds);
    return {};
  }

  int FindDomainFaces() override
  {
    if constexpr (IsUnstructured)
    {
      this->Shared.FindPatches(this->Exchange);
      return this->Shared.GetPatches()->GetNumberOfPatches();
    }
    else
    {
      return 6;
    }
  }

  const FlowField& GetField() const override { return this->Shared; }
  vtkIdType GetNumberOfSteps() const override { return this->Steps; }
  vtkIdType GetNumberOfTransfers() const override { return this->Transfers; }
  void Describe(FlowReport& report) const override
  {
    if constexpr (Field::IsSearched)
    {
      std::vector<vtkIdType> joined{ this->Shared.GetMatchGaps().Number };
      std::vector<double> gap{ this->Shared.GetMatchGaps().LargestGap };
      this->Exchange.ReduceSum(joined);
      this->Exchange.ReduceMax(gap);
      report.ToleranceMatchedFaces = joined[0];
      report.LargestFaceGap = gap[0];
      NonconformingInterfaces open;
      if constexpr (IsUnstructured)
      {
        open = this->Shared.GetInterfaces().Open;
      }
      else
      {
        open = this->Shared.FindNonconformingInterfaces(this->Exchange);
      }
      report.NonconformingFaces = open.Number;
      report.FirstNonconformingCell = open.FirstCell;
    }
  }

  bool Follow(const AdvectionOptions& options, vtkIdType number, const GetPosition& start,
    const Take& take, double begin, double end) override
  {
    if (!this->Exchange.IsAnywhere(number > 0))
    {
      return !this->Exchange.IsAnywhere(this->Owner->GetAbortExecute());
    }
    Job job{ options, start, take, {}, {} };
    vtkIdType begun = 0;
    this->Exchange.Run(
      [&](const RankExchange::Bytes& received, Outbox& sent)
      {
        this->Receive(received, job, sent);
        this->Search(job.Searches, sent);
        std::vector<QueuedStreamline> batch = this->ExtractBatch(job.Queue);
        const auto all =
          std::min(number, begun + this->MaximumBatchSize - static_cast<vtkIdType>(batch.size()));
        for (; begun < all && !job.IsAborted; ++begun)
        {
          this->Begin(begun, job, batch, sent);
        }
        job.Ended += this->FollowBatch(options, batch, take, sent);
        const double fraction = number > 0 ? static_cast<double>(job.Ended) / number : 1.0;
        this->Owner->UpdateProgress(begin + fraction * (end - begin));
        if (!job.IsAborted && this->Owner->GetAbortExecute())
        {
          job.IsAborted = true;
          this->SendAbort(sent);
        }
        if (job.IsAborted)
        {
          job.Queue.clear();
          begun = number;
        }
        return job.Queue.empty() && begun == number;
      });
    return !this->Exchange.IsAnywhere(job.IsAborted);
  }

  std::vector<Velocity> GetVelocities(
    vtkIdType number, const GetPosition& position, bool withVorticity) override
  {
    std::vector<Velocity> velocities(static_cast<std::size_t>(number));
    if (!this->Exchange.IsAnywhere(number > 0))
    {
      return velocities;
    }
    bool hasBegun = false;
    std::vector<CellSearchResult> best(velocities.size());
    std::vector<int> ranks;
    Walker walker(&this->Shared);
    this->Exchange.Run(
      [&](const RankExchange::Bytes& received, Outbox& sent)
      {
        for (vtkIdType i = 0; !hasBegun && i < number; ++i)
        {
          double x[3];
          position(i, x);
          this->Cells.FindRanks(x, ranks);
          this->Send(Kind::Position, { this->Exchange.GetRank(), i }, x, ranks, sent);
        }
        hasBegun = true;
        const char* at = received.data();
        while (at < received.data() + received.size())
        {
          Kind kind;
          Request request;
          GetHead(at, kind, request);
          CellSearchResult finding;
          Velocity velocity;
          if (kind == Kind::Velocity)
          {
            const auto i = static_cast<std::size_t>(request.Number);
            MessageBytes::Get(at, finding);
            MessageBytes::Get(at, velocity);
            velocities[i] = finding.IsBefore(best[i]) ? velocity : velocities[i];
            best[i] = finding.IsBefore(best[i]) ? finding : best[i];
            continue;
          }
          double x[3];
          MessageBytes::Get(at, x);
          finding = this->Cells.Find(walker, x);
          if (finding.IsFound)
          {
            velocity = LocalStreamlines<Walker>::GetVelocityAt(walker, finding.P, withVorticity);
          }
          RankExchange::Bytes& reply = sent[static_cast<std::size_t>(request.Rank)];
          PutHead(reply, Kind::Velocity, request);
          MessageBytes::Put(reply, finding);
          MessageBytes::Put(reply, velocity);
        }
        return true;
      });
    return velocities;
  }

private:
  static constexpr bool IsUnstructured = std::is_same_v<Field, PartitionedUnstructuredField>;

  /// Streamlines that this process requested, requests that it received, and their progress.
  struct Job
  {
    const AdvectionOptions& Options;
    const GetPosition& Start;
    const Take& ReleaseResult;
    /// Streamlines to trace, and positions to search for.
    std::deque<QueuedStreamline> Queue;
    std::vector<QueuedStreamline> Searches;
    /// Number of finished streamlines that this process requested.
    vtkIdType Ended = 0;
    /// True if the execution was aborted in any process.
    bool IsAborted = false;
  };

  // Maximum number of streamlines between two message exchanges. Without shared memory, a long
  // message is transferred only while both processes exchange messages.
  const vtkIdType MaximumBatchSize = 512 * std::max(vtkSMPTools::GetEstimatedNumberOfThreads(), 1);

  static void GetHead(const char*& at, Kind& kind, Request& request)
  {
    MessageBytes::Get(at, kind);
    MessageBytes::Get(at, request.Rank);
    MessageBytes::Get(at, request.Number);
  }

  /// Sends a position to the given processes.
  static void Send(Kind kind, const Request& request, const double x[3],
    const std::vector<int>& ranks, Outbox& sent)
  {
    for (const int rank : ranks)
    {
      RankExchange::Bytes& bytes = sent[static_cast<std::size_t>(rank)];
      PutHead(bytes, kind, request);
      PutPosition(bytes, x);
    }
  }

  /// Sends a start position to the process that owns its cell, or adds it to \a batch if that is
  /// this process. If several processes may own the cell, they all search for it first.
  void Begin(vtkIdType i, Job& job, std::vector<QueuedStreamline>& batch, Outbox& sent)
  {
    QueuedStreamline queued;
    queued.For = { this->Exchange.GetRank(), i };
    job.Start(i, queued.X);
    std::vector<int>& ranks = this->RanksOfStart;
    this->Cells.FindRanks(queued.X, ranks);
    if (ranks.empty())
    {
      EndOutside(i, queued.X, job);
    }
    else if (ranks.size() > 1)
    {
      this->Cells.Expect(i, ranks.size());
      Send(Kind::Search, queued.For, queued.X, ranks, sent);
    }
    else if (ranks.front() == this->Exchange.GetRank())
    {
      batch.push_back(std::move(queued));
    }
    else
    {
      Send(Kind::Start, queued.For, queued.X, ranks, sent);
    }
  }

  static void EndOutside(vtkIdType i, const double x[3], Job& job)
  {
    AdvectionResult outside;
    outside.Means.assign(job.Options.MeanNumbers.size(), 0.0);
    std::copy_n(x, 3, outside.Position);
    job.ReleaseResult(i, outside);
    ++job.Ended;
  }

  /// Finds this process's cells at the positions, sends the results to the requesters, and clears
  /// \a positions.
  void Search(std::vector<QueuedStreamline>& positions, Outbox& sent) const
  {
    std::vector<CellSearchResult> findings(positions.size());
    vtkSMPTools::For(0, static_cast<vtkIdType>(positions.size()),
      [&](vtkIdType first, vtkIdType last)
      {
        Walker walker(&this->Shared);
        for (auto i = static_cast<std::size_t>(first); i < static_cast<std::size_t>(last); ++i)
        {
          findings[i] = this->Cells.Find(walker, positions[i].X);
        }
      });
    for (std::size_t i = 0; i < positions.size(); ++i)
    {
      RankExchange::Bytes& reply = sent[static_cast<std::size_t>(positions[i].For.Rank)];
      PutHead(reply, Kind::Finding, positions[i].For);
      MessageBytes::Put(reply, this->Exchange.GetRank());
      MessageBytes::Put(reply, findings[i]);
    }
    positions.clear();
  }

  /// Starts a streamline in the best cell found: queues it, or sends it to the process that owns
  /// the cell. If no cell was found, ends it.
  void BeginAt(const Request& request, const typename PartitionedCellSearch<Walker>::Best& best,
    Job& job, Outbox& sent) const
  {
    double x[3];
    job.Start(request.Number, x);
    if (!best.Finding.IsFound)
    {
      EndOutside(request.Number, x, job);
      return;
    }
    QueuedStreamline queued;
    queued.For = request;
    queued.State = std::make_unique<AdvectionState>();
    std::copy_n(x, 3, queued.State->Values.Result.Position);
    queued.State->Values.Cell = best.Finding.Cell;
    std::copy_n(best.Finding.P, 3, queued.State->Values.Point);
    if (best.Rank == this->Exchange.GetRank())
    {
      job.Queue.push_back(std::move(queued));
      return;
    }
    PutState(request, *queued.State, sent[static_cast<std::size_t>(best.Rank)]);
  }

  /// Notifies all other processes of an abort.
  void SendAbort(Outbox& sent) const
  {
    for (int rank = 0; rank < this->Exchange.GetNumberOfRanks(); ++rank)
    {
      if (rank != this->Exchange.GetRank())
      {
        PutHead(sent[static_cast<std::size_t>(rank)], Kind::Aborted, Request());
      }
    }
  }

  static void PutState(
    const Request& request, const AdvectionState& state, RankExchange::Bytes& bytes)
  {
    PutHead(bytes, Kind::Continue, request);
    MessageBytes::Put(bytes, state.Values);
    MessageBytes::Put(bytes, state.Numbers);
  }

  std::vector<QueuedStreamline> ExtractBatch(std::deque<QueuedStreamline>& queue) const
  {
    const auto number =
      std::min<std::ptrdiff_t>(static_cast<std::ptrdiff_t>(queue.size()), this->MaximumBatchSize);
    std::vector<QueuedStreamline> batch(
      std::make_move_iterator(queue.begin()), std::make_move_iterator(queue.begin() + number));
    queue.erase(queue.begin(), queue.begin() + number);
    return batch;
  }

  void Receive(const RankExchange::Bytes& received, Job& job, Outbox& sent)
  {
    const char* at = received.data();
    while (at < received.data() + received.size())
    {
      Kind kind;
      QueuedStreamline queued;
      GetHead(at, kind, queued.For);
      switch (kind)
      {
        case Kind::Aborted:
          job.IsAborted = true;
          break;
        case Kind::Result:
        {
          AdvectionResult result;
          MessageBytes::Get(at, static_cast<AdvectionEnd&>(result));
          MessageBytes::Get(at, result.Means);
          job.ReleaseResult(queued.For.Number, result);
          ++job.Ended;
          break;
        }
        case Kind::Finding:
        {
          int rank = 0;
          CellSearchResult finding;
          typename PartitionedCellSearch<Walker>::Best best;
          MessageBytes::Get(at, rank);
          MessageBytes::Get(at, finding);
          if (this->Cells.Take(queued.For.Number, rank, finding, best))
          {
            this->BeginAt(queued.For, best, job, sent);
          }
          break;
        }
        case Kind::Continue:
          queued.State = std::make_unique<AdvectionState>();
          MessageBytes::Get(at, queued.State->Values);
          MessageBytes::Get(at, queued.State->Numbers);
          job.Queue.push_back(std::move(queued));
          break;
        default:
          MessageBytes::Get(at, queued.X);
          if (kind == Kind::Search)
          {
            job.Searches.push_back(std::move(queued));
          }
          else
          {
            job.Queue.push_back(std::move(queued));
          }
      }
    }
    if (job.IsAborted)
    {
      job.Queue.clear();
    }
  }

  /// One thread's outgoing messages and counters.
  struct Done
  {
    Outbox Sent;
    vtkIdType Finished = 0;
    vtkIdType Steps = 0;
    vtkIdType Transfers = 0;
  };

  /// Traces streamlines until they end or leave the cells of this process. Returns how many of the
  /// finished ones this process requested.
  vtkIdType FollowBatch(const AdvectionOptions& options, const std::vector<QueuedStreamline>& batch,
    const Take& take, Outbox& sent)
  {
    if (batch.empty())
    {
      return 0;
    }
    vtkSMPThreadLocal<Done> threads;
    SampleQueue::RunRange(0, static_cast<vtkIdType>(batch.size()),
      [&](auto&& next)
      {
        Done& done = threads.Local();
        done.Sent.resize(sent.size());
        this->FollowEach(options, batch, take, next, done);
      });
    vtkIdType finished = 0;
    for (const Done& done : threads)
    {
      for (std::size_t rank = 0; rank < sent.size(); ++rank)
      {
        sent[rank].insert(sent[rank].end(), done.Sent[rank].begin(), done.Sent[rank].end());
      }
      finished += done.Finished;
      this->Steps += done.Steps;
      this->Transfers += done.Transfers;
    }
    return finished;
  }

  template <typename Next>
  void FollowEach(const AdvectionOptions& options, const std::vector<QueuedStreamline>& batch,
    const Take& take, Next&& next, Done& done) const
  {
    AdvectionState state;
    AdvectionResult result;
    StreamlineIntegrator<Walker>::Follow(
      Walker(&this->Shared), options,
      [&](Advection<Walker>& one, bool& isActive)
      {
        const vtkIdType i = next();
        if (i >= 0)
        {
          const QueuedStreamline& queued = batch[static_cast<std::size_t>(i)];
          isActive = queued.State ? one.Resume(*queued.State) : one.Start(queued.X);
          done.Steps -= queued.State ? queued.State->Values.Result.GetNumberOfSteps() : 0;
        }
        return i;
      },
      [&](vtkIdType i, Advection<Walker>& one)
      {
        const Request& request = batch[static_cast<std::size_t>(i)].For;
        done.Steps += one.GetNumberOfSteps();
        if (one.IsOnOtherProcess())
        {
          one.Save(state);
          const int rank = this->Shared.FindRank(this->Ranks, state.Values.Cell);
          PutState(request, state, done.Sent[static_cast<std::size_t>(rank)]);
          ++done.Transfers;
          return;
        }
        one.Finish(result);
        if (request.Rank == this->Exchange.GetRank())
        {
          take(request.Number, result);
          ++done.Finished;
          return;
        }
        RankExchange::Bytes& bytes = done.Sent[static_cast<std::size_t>(request.Rank)];
        PutHead(bytes, Kind::Result, request);
        MessageBytes::Put(bytes, static_cast<const AdvectionEnd&>(result));
        MessageBytes::Put(bytes, result.Means);
      });
  }

  DistributedField& Ranks;
  RankExchange& Exchange;
  vtkAlgorithm* Owner;
  Field Shared;
  PartitionedCellSearch<Walker> Cells;
  std::vector<int> RanksOfStart;
  vtkIdType Steps = 0;
  vtkIdType Transfers = 0;
};

template <typename Walker, typename Data>
std::unique_ptr<DistributedStreamlines> MakeOf(DistributedField& field, Data* data,
  vtkDataArray* vectors, const std::vector<vtkDataArray*>& arrays, vtkAlgorithm* owner,
  Error& error)
{
  auto streamlines = std::make_unique<PartStreamlines<Walker>>(field, owner);
  if (field.IsEmpty())
  {
    // Even a process without cells needs the grid, to find the owner of a start position. It needs
    // no vectors.
    vtkNew<vtkFloatArray> none;
    none->SetNumberOfComponents(3);
    error = streamlines->Build(data, none, {});
  }
  else
  {
    error = streamlines->Build(data, vectors, arrays);
  }
  return !error && !field.GetPartitionError() ? std::move(streamlines) : nullptr;
}
}

std::unique_ptr<DistributedStreamlines> DistributedStreamlines::Make(DistributedField& field,
  vtkDataArray* vectors, const std::vector<vtkDataArray*>& arrays, vtkAlgorithm* owner,
  Error& error)
{
  if (auto* image = vtkImageData::SafeDownCast(field.GetData()))
  {
    return MakeOf<ImagePartWalker>(field, image, vectors, arrays, owner, error);
  }
  if (auto* structured = vtkStructuredGrid::SafeDownCast(field.GetData()))
  {
    return MakeOf<StructuredPartWalker>(field, structured, vectors, arrays, owner, error);
  }
  if (auto* unstructured = vtkUnstructuredGrid::SafeDownCast(field.GetData()))
  {
    return MakeOf<UnstructuredPartWalker>(field, unstructured, vectors, arrays, owner, error);
  }
  auto* grid = vtkRectilinearGrid::SafeDownCast(field.GetData());
  return MakeOf<RectilinearPartWalker>(field, grid, vectors, arrays, owner, error);
}

}
