// SPDX-License-Identifier: BSD-3-Clause
#include "Streams/RankStreamlines.h"

#include "Streams/FlowReport.h"
#include "Streams/LocalStreamlines.h"
#include "Streams/MessageBytes.h"
#include "Streams/PartField.h"
#include "Streams/PartSearch.h"
#include "Streams/RankField.h"
#include "Streams/SampleStreams.h"
#include "Streams/StreamlineIntegrator.h"
#include "Streams/StructuredPartField.h"
#include "Streams/UnstructuredPartField.h"

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
/// What a message is about: a position to begin at; a position to look for, where others do so too,
/// and what was found; a streamline to go on with, a result; that the execution was aborted; a
/// position to find the velocity at, and the velocity.
enum class Kind : int
{
  Start,
  Search,
  Finding,
  GoOn,
  Result,
  Aborted,
  Position,
  Velocity
};

/// The process that asked, and its number for it.
struct Question
{
  int Rank = 0;
  vtkIdType Number = 0;
};

/// A streamline that waits to be followed.
struct Waiting
{
  Question For;
  /// The start, where there is no state yet.
  double X[3] = { 0.0, 0.0, 0.0 };
  std::unique_ptr<AdvectionState> State;
};

void PutHead(RankExchange::Bytes& bytes, Kind kind, const Question& question)
{
  MessageBytes::Put(bytes, kind);
  MessageBytes::Put(bytes, question.Rank);
  MessageBytes::Put(bytes, question.Number);
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
class PartStreamlines final : public RankStreamlines
{
public:
  using Field = typename Walker::Field;

  PartStreamlines(RankField& ranks, vtkAlgorithm* owner)
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
        this->Ranks.SetPartitionError("faces of cells do not fit between processes");
      }
    }
    else if constexpr (Field::IsSearched)
    {
      this->Shared.Join(this->Exchange);
    }
    SpeedCount speeds = this->Shared.CountOwnSpeeds();
    speeds.Speeds.Unite([this](std::vector<vtkIdType>& numbers) { this->Exchange.Add(numbers); },
      [this](std::vector<double>& largest) { this->Exchange.Maximize(largest); });
    std::vector<vtkIdType> nonFinite{ speeds.NonFinite };
    this->Exchange.Add(nonFinite);
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
  vtkIdType GetNumberOfHandedOn() const override { return this->HandedOn; }
  void Describe(FlowReport& report) const override
  {
    if constexpr (Field::IsSearched)
    {
      std::vector<vtkIdType> joined{ this->Shared.GetJoins().Number };
      std::vector<double> gap{ this->Shared.GetJoins().LargestGap };
      this->Exchange.Add(joined);
      this->Exchange.Maximize(gap);
      report.ToleranceMatchedFaces = joined[0];
      report.LargestFaceGap = gap[0];
      OpenInterfaces open;
      if constexpr (IsUnstructured)
      {
        open = this->Shared.GetInterfaces().Open;
      }
      else
      {
        open = this->Shared.FindOpenInterfaces(this->Exchange);
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
        this->Search(job.Searched, sent);
        std::vector<Waiting> batch = this->TakeBatch(job.Queue);
        const auto all =
          std::min(number, begun + this->MostInBatch - static_cast<vtkIdType>(batch.size()));
        for (; begun < all && !job.IsAborted; ++begun)
        {
          this->Begin(begun, job, batch, sent);
        }
        job.Ended += this->FollowBatch(options, batch, take, sent);
        const double share = number > 0 ? static_cast<double>(job.Ended) / number : 1.0;
        this->Owner->UpdateProgress(begin + share * (end - begin));
        if (!job.IsAborted && this->Owner->GetAbortExecute())
        {
          job.IsAborted = true;
          this->TellOfAbort(sent);
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

  std::vector<Velocity> GetVelocities(vtkIdType number, const GetPosition& position) override
  {
    std::vector<Velocity> velocities(static_cast<std::size_t>(number));
    if (!this->Exchange.IsAnywhere(number > 0))
    {
      return velocities;
    }
    bool hasBegun = false;
    std::vector<CellFinding> best(velocities.size());
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
          Question question;
          GetHead(at, kind, question);
          CellFinding finding;
          Velocity velocity;
          if (kind == Kind::Velocity)
          {
            const auto i = static_cast<std::size_t>(question.Number);
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
            velocity = LocalStreamlines<Walker>::GetVelocityAt(walker, finding.P);
          }
          RankExchange::Bytes& answer = sent[static_cast<std::size_t>(question.Rank)];
          PutHead(answer, Kind::Velocity, question);
          MessageBytes::Put(answer, finding);
          MessageBytes::Put(answer, velocity);
        }
        return true;
      });
    return velocities;
  }

private:
  static constexpr bool IsUnstructured = std::is_same_v<Field, UnstructuredPartField>;

  /// What is asked of this process, and how far it is.
  struct Job
  {
    const AdvectionOptions& Options;
    const GetPosition& Start;
    const Take& TakeResult;
    /// What waits to be followed, and positions that others want to be looked for.
    std::deque<Waiting> Queue;
    std::vector<Waiting> Searched;
    /// How many of this process's streamlines have ended.
    vtkIdType Ended = 0;
    /// Whether the execution was aborted, here or in another process.
    bool IsAborted = false;
  };

  // The most streamlines that are followed until others are listened to again: where memory is not
  // shared, a long message goes on only while its sender listens too.
  const vtkIdType MostInBatch = 512 * std::max(vtkSMPTools::GetEstimatedNumberOfThreads(), 1);

  static void GetHead(const char*& at, Kind& kind, Question& question)
  {
    MessageBytes::Get(at, kind);
    MessageBytes::Get(at, question.Rank);
    MessageBytes::Get(at, question.Number);
  }

  /// Sends a position to processes.
  static void Send(Kind kind, const Question& question, const double x[3],
    const std::vector<int>& ranks, Outbox& sent)
  {
    for (const int rank : ranks)
    {
      RankExchange::Bytes& bytes = sent[static_cast<std::size_t>(rank)];
      PutHead(bytes, kind, question);
      PutPosition(bytes, x);
    }
  }

  /// Sends a start to where its cell is, or adds it to what is followed here; where several
  /// processes may have the cell, they look first.
  void Begin(vtkIdType i, Job& job, std::vector<Waiting>& batch, Outbox& sent)
  {
    Waiting waiting;
    waiting.For = { this->Exchange.GetRank(), i };
    job.Start(i, waiting.X);
    std::vector<int>& ranks = this->RanksOfStart;
    this->Cells.FindRanks(waiting.X, ranks);
    if (ranks.empty())
    {
      EndOutside(i, waiting.X, job);
    }
    else if (ranks.size() > 1)
    {
      this->Cells.Expect(i, ranks.size());
      Send(Kind::Search, waiting.For, waiting.X, ranks, sent);
    }
    else if (ranks.front() == this->Exchange.GetRank())
    {
      batch.push_back(std::move(waiting));
    }
    else
    {
      Send(Kind::Start, waiting.For, waiting.X, ranks, sent);
    }
  }

  static void EndOutside(vtkIdType i, const double x[3], Job& job)
  {
    AdvectionResult outside;
    outside.Means.assign(job.Options.MeanNumbers.size(), 0.0);
    std::copy_n(x, 3, outside.Position);
    job.TakeResult(i, outside);
    ++job.Ended;
  }

  /// Looks for the cells at positions, and sends what was found.
  void Search(std::vector<Waiting>& positions, Outbox& sent) const
  {
    std::vector<CellFinding> findings(positions.size());
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
      RankExchange::Bytes& answer = sent[static_cast<std::size_t>(positions[i].For.Rank)];
      PutHead(answer, Kind::Finding, positions[i].For);
      MessageBytes::Put(answer, this->Exchange.GetRank());
      MessageBytes::Put(answer, findings[i]);
    }
    positions.clear();
  }

  /// Begins a streamline in the cell that was found, in whichever process.
  void BeginAt(const Question& question, const typename PartSearch<Walker>::Best& best, Job& job,
    Outbox& sent) const
  {
    double x[3];
    job.Start(question.Number, x);
    if (!best.Finding.IsFound)
    {
      EndOutside(question.Number, x, job);
      return;
    }
    Waiting waiting;
    waiting.For = question;
    waiting.State = std::make_unique<AdvectionState>();
    std::copy_n(x, 3, waiting.State->Values.Result.Position);
    waiting.State->Values.Cell = best.Finding.Cell;
    std::copy_n(best.Finding.P, 3, waiting.State->Values.Point);
    if (best.Rank == this->Exchange.GetRank())
    {
      job.Queue.push_back(std::move(waiting));
      return;
    }
    PutState(question, *waiting.State, sent[static_cast<std::size_t>(best.Rank)]);
  }

  /// Has all processes end.
  void TellOfAbort(Outbox& sent) const
  {
    for (int rank = 0; rank < this->Exchange.GetNumberOfRanks(); ++rank)
    {
      if (rank != this->Exchange.GetRank())
      {
        PutHead(sent[static_cast<std::size_t>(rank)], Kind::Aborted, Question());
      }
    }
  }

  static void PutState(
    const Question& question, const AdvectionState& state, RankExchange::Bytes& bytes)
  {
    PutHead(bytes, Kind::GoOn, question);
    MessageBytes::Put(bytes, state.Values);
    MessageBytes::Put(bytes, state.Numbers);
  }

  std::vector<Waiting> TakeBatch(std::deque<Waiting>& queue) const
  {
    const auto number =
      std::min<std::ptrdiff_t>(static_cast<std::ptrdiff_t>(queue.size()), this->MostInBatch);
    std::vector<Waiting> batch(
      std::make_move_iterator(queue.begin()), std::make_move_iterator(queue.begin() + number));
    queue.erase(queue.begin(), queue.begin() + number);
    return batch;
  }

  /// Takes what has come.
  void Receive(const RankExchange::Bytes& received, Job& job, Outbox& sent)
  {
    const char* at = received.data();
    while (at < received.data() + received.size())
    {
      Kind kind;
      Waiting waiting;
      GetHead(at, kind, waiting.For);
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
          job.TakeResult(waiting.For.Number, result);
          ++job.Ended;
          break;
        }
        case Kind::Finding:
        {
          int rank = 0;
          CellFinding finding;
          typename PartSearch<Walker>::Best best;
          MessageBytes::Get(at, rank);
          MessageBytes::Get(at, finding);
          if (this->Cells.Take(waiting.For.Number, rank, finding, best))
          {
            this->BeginAt(waiting.For, best, job, sent);
          }
          break;
        }
        case Kind::GoOn:
          waiting.State = std::make_unique<AdvectionState>();
          MessageBytes::Get(at, waiting.State->Values);
          MessageBytes::Get(at, waiting.State->Numbers);
          job.Queue.push_back(std::move(waiting));
          break;
        default:
          MessageBytes::Get(at, waiting.X);
          if (kind == Kind::Search)
          {
            job.Searched.push_back(std::move(waiting));
          }
          else
          {
            job.Queue.push_back(std::move(waiting));
          }
      }
    }
    if (job.IsAborted)
    {
      job.Queue.clear();
    }
  }

  /// What a thread has to send, and what it has done.
  struct Done
  {
    Outbox Sent;
    vtkIdType Taken = 0;
    vtkIdType Steps = 0;
    vtkIdType HandedOn = 0;
  };

  /// Follows streamlines as far as they are here. Returns how many of this process's have ended.
  vtkIdType FollowBatch(const AdvectionOptions& options, const std::vector<Waiting>& batch,
    const Take& take, Outbox& sent)
  {
    if (batch.empty())
    {
      return 0;
    }
    vtkSMPThreadLocal<Done> threads;
    SampleStreams::RunRange(0, static_cast<vtkIdType>(batch.size()),
      [&](auto&& next)
      {
        Done& done = threads.Local();
        done.Sent.resize(sent.size());
        this->FollowEach(options, batch, take, next, done);
      });
    vtkIdType taken = 0;
    for (const Done& done : threads)
    {
      for (std::size_t rank = 0; rank < sent.size(); ++rank)
      {
        sent[rank].insert(sent[rank].end(), done.Sent[rank].begin(), done.Sent[rank].end());
      }
      taken += done.Taken;
      this->Steps += done.Steps;
      this->HandedOn += done.HandedOn;
    }
    return taken;
  }

  template <typename Next>
  void FollowEach(const AdvectionOptions& options, const std::vector<Waiting>& batch,
    const Take& take, Next&& next, Done& done) const
  {
    AdvectionState state;
    AdvectionResult result;
    StreamlineIntegrator<Walker>::Follow(
      Walker(&this->Shared), options,
      [&](Advection<Walker>& one, bool& goesOn)
      {
        const vtkIdType i = next();
        if (i >= 0)
        {
          const Waiting& waiting = batch[static_cast<std::size_t>(i)];
          goesOn = waiting.State ? one.Resume(*waiting.State) : one.Start(waiting.X);
          done.Steps -= waiting.State ? waiting.State->Values.Result.GetNumberOfSteps() : 0;
        }
        return i;
      },
      [&](vtkIdType i, Advection<Walker>& one)
      {
        const Question& question = batch[static_cast<std::size_t>(i)].For;
        done.Steps += one.GetNumberOfSteps();
        if (one.IsElsewhere())
        {
          one.Save(state);
          const int rank = this->Shared.FindRank(this->Ranks, state.Values.Cell);
          PutState(question, state, done.Sent[static_cast<std::size_t>(rank)]);
          ++done.HandedOn;
          return;
        }
        one.Finish(result);
        if (question.Rank == this->Exchange.GetRank())
        {
          take(question.Number, result);
          ++done.Taken;
          return;
        }
        RankExchange::Bytes& bytes = done.Sent[static_cast<std::size_t>(question.Rank)];
        PutHead(bytes, Kind::Result, question);
        MessageBytes::Put(bytes, static_cast<const AdvectionEnd&>(result));
        MessageBytes::Put(bytes, result.Means);
      });
  }

  RankField& Ranks;
  RankExchange& Exchange;
  vtkAlgorithm* Owner;
  Field Shared;
  PartSearch<Walker> Cells;
  std::vector<int> RanksOfStart;
  vtkIdType Steps = 0;
  vtkIdType HandedOn = 0;
};

template <typename Walker, typename Data>
std::unique_ptr<RankStreamlines> MakeOf(RankField& field, Data* data, vtkDataArray* vectors,
  const std::vector<vtkDataArray*>& arrays, vtkAlgorithm* owner, Error& error)
{
  auto streamlines = std::make_unique<PartStreamlines<Walker>>(field, owner);
  if (field.IsEmpty())
  {
    // Positions are placed in the grid all the same, and nothing is read.
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

std::unique_ptr<RankStreamlines> RankStreamlines::Make(RankField& field, vtkDataArray* vectors,
  const std::vector<vtkDataArray*>& arrays, vtkAlgorithm* owner, Error& error)
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
