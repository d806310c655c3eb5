// SPDX-License-Identifier: BSD-3-Clause
#include "Streams/RankStreamlines.h"

#include "Advection/AdvectionLanes.h"
#include "Streams/LatticeSteps.h"
#include "Streams/LocalStreamlines.h"
#include "Streams/MessageBytes.h"
#include "Streams/PartField.h"
#include "Streams/RankField.h"
#include "Streams/SampleStreams.h"

#include "vtkAlgorithm.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkRectilinearGrid.h"
#include "vtkSMPThreadLocal.h"
#include "vtkSMPTools.h"

#include <deque>
#include <iterator>
#include <utility>

namespace interlume
{

namespace
{
/// What a message is about: a position to begin at, a streamline to go on with, a result; a
/// position to find the velocity at, and the velocity.
enum class Kind : int
{
  Start,
  GoOn,
  Result,
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
  {
  }

  template <typename Data>
  std::string Build(Data* data, vtkDataArray* vectors, const std::vector<vtkDataArray*>& arrays)
  {
    SpeedCount speeds;
    const std::string wrong = this->Exchange.FindFirst(
      this->Shared.BuildPart(data, vectors, arrays, this->Ranks.GetPart(), speeds));
    if (wrong.empty())
    {
      speeds.Speeds.Unite([this](std::vector<vtkIdType>& numbers) { this->Exchange.Add(numbers); },
        [this](std::vector<double>& largest) { this->Exchange.Maximize(largest); });
      std::vector<vtkIdType> nonFinite{ speeds.NonFinite };
      this->Exchange.Add(nonFinite);
      speeds.NonFinite = nonFinite[0];
      this->Shared.SetSpeeds(speeds);
    }
    return wrong;
  }

  const FlowField& GetField() const override { return this->Shared; }
  vtkIdType GetNumberOfSteps() const override { return this->Steps; }
  vtkIdType GetNumberOfHandedOn() const override { return this->HandedOn; }

  bool Follow(const AdvectionOptions& options, vtkIdType number, const GetPosition& start,
    const Take& take, double begin, double end) override
  {
    if (!this->Exchange.IsAnywhere(number > 0))
    {
      return !this->Exchange.IsAnywhere(this->Owner->GetAbortExecute());
    }
    std::deque<Waiting> queue;
    vtkIdType begun = 0;
    vtkIdType taken = 0;
    bool isAborted = false;
    this->Exchange.Run(
      [&](const RankExchange::Bytes& received, Outbox& sent)
      {
        taken += this->Receive(received, queue, take);
        std::vector<Waiting> batch = this->TakeBatch(queue);
        const auto all =
          std::min(number, begun + MostInBatch - static_cast<vtkIdType>(batch.size()));
        for (; begun < all; ++begun)
        {
          taken += this->Begin(options, begun, start, take, batch, sent);
        }
        taken += this->FollowBatch(options, batch, take, sent);
        const double share = number > 0 ? static_cast<double>(taken) / number : 1.0;
        this->Owner->UpdateProgress(begin + share * (end - begin));
        isAborted = isAborted || this->Owner->GetAbortExecute();
        if (isAborted)
        {
          queue.clear();
          begun = number;
        }
        return queue.empty() && begun == number;
      });
    return !this->Exchange.IsAnywhere(isAborted);
  }

  std::vector<Velocity> GetVelocities(vtkIdType number, const GetPosition& position) override
  {
    std::vector<Velocity> velocities(static_cast<std::size_t>(number));
    if (!this->Exchange.IsAnywhere(number > 0))
    {
      return velocities;
    }
    bool hasBegun = false;
    Walker walker(&this->Shared);
    this->Exchange.Run(
      [&](const RankExchange::Bytes& received, Outbox& sent)
      {
        for (vtkIdType i = 0; !hasBegun && i < number; ++i)
        {
          double x[3];
          position(i, x);
          this->Send(Kind::Position, { this->Exchange.GetRank(), i }, x, sent);
        }
        hasBegun = true;
        const char* at = received.data();
        while (at < received.data() + received.size())
        {
          Kind kind;
          Question question;
          GetHead(at, kind, question);
          if (kind == Kind::Velocity)
          {
            MessageBytes::Get(at, velocities[static_cast<std::size_t>(question.Number)]);
            continue;
          }
          double x[3];
          MessageBytes::Get(at, x);
          RankExchange::Bytes& answer = sent[static_cast<std::size_t>(question.Rank)];
          PutHead(answer, Kind::Velocity, question);
          MessageBytes::Put(answer, LocalStreamlines<Walker>::GetVelocity(walker, x));
        }
        return true;
      });
    return velocities;
  }

private:
  // The most streamlines that are followed until others are listened to again.
  static constexpr vtkIdType MostInBatch = 4096;

  static void GetHead(const char*& at, Kind& kind, Question& question)
  {
    MessageBytes::Get(at, kind);
    MessageBytes::Get(at, question.Rank);
    MessageBytes::Get(at, question.Number);
  }

  /// Sends a position to the process that has the cell there. Returns false where there is none.
  bool Send(Kind kind, const Question& question, const double x[3], Outbox& sent) const
  {
    const int rank = this->FindRank(x);
    if (rank >= 0)
    {
      RankExchange::Bytes& bytes = sent[static_cast<std::size_t>(rank)];
      PutHead(bytes, kind, question);
      bytes.insert(bytes.end(), reinterpret_cast<const char*>(x),
        reinterpret_cast<const char*>(x) + 3 * sizeof(double));
    }
    return rank >= 0;
  }

  /// Returns the process in whose part of the grid a position is; -1 outside.
  int FindRank(const double x[3]) const
  {
    int index[3];
    double p[3];
    return this->Shared.LocateIndex(x, index, p) ? this->Ranks.FindRank(index) : -1;
  }

  /// Sends a start to where its cell is, or adds it to what is followed here. Returns how many have
  /// ended by being outside.
  vtkIdType Begin(const AdvectionOptions& options, vtkIdType i, const GetPosition& start,
    const Take& take, std::vector<Waiting>& batch, Outbox& sent) const
  {
    Waiting waiting;
    waiting.For = { this->Exchange.GetRank(), i };
    start(i, waiting.X);
    if (this->FindRank(waiting.X) == this->Exchange.GetRank())
    {
      batch.push_back(std::move(waiting));
      return 0;
    }
    if (this->Send(Kind::Start, waiting.For, waiting.X, sent))
    {
      return 0;
    }
    AdvectionResult outside;
    outside.Means.assign(options.MeanNumbers.size(), 0.0);
    std::copy_n(waiting.X, 3, outside.Position);
    take(i, outside);
    return 1;
  }

  static std::vector<Waiting> TakeBatch(std::deque<Waiting>& queue)
  {
    const auto number =
      std::min<std::ptrdiff_t>(static_cast<std::ptrdiff_t>(queue.size()), MostInBatch);
    std::vector<Waiting> batch(
      std::make_move_iterator(queue.begin()), std::make_move_iterator(queue.begin() + number));
    queue.erase(queue.begin(), queue.begin() + number);
    return batch;
  }

  /// Takes what has come. Returns how many results were among it.
  vtkIdType Receive(
    const RankExchange::Bytes& received, std::deque<Waiting>& queue, const Take& take) const
  {
    vtkIdType results = 0;
    const char* at = received.data();
    while (at < received.data() + received.size())
    {
      Kind kind;
      Waiting waiting;
      GetHead(at, kind, waiting.For);
      if (kind == Kind::Result)
      {
        AdvectionResult result;
        MessageBytes::Get(at, static_cast<AdvectionEnd&>(result));
        MessageBytes::Get(at, result.Means);
        take(waiting.For.Number, result);
        ++results;
        continue;
      }
      if (kind == Kind::Start)
      {
        MessageBytes::Get(at, waiting.X);
      }
      else
      {
        waiting.State = std::make_unique<AdvectionState>();
        MessageBytes::Get(at, waiting.State->Values);
        MessageBytes::Get(at, waiting.State->Numbers);
      }
      queue.push_back(std::move(waiting));
    }
    return results;
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
    using Group = AdvectionLanes<Walker, LatticeSteps::Four>;
    Group advection(Walker(&this->Shared), options, LatticeSteps::Take);
    AdvectionState state;
    advection.FollowEach(
      [&](int, Advection<Walker>& one, AdvectionResult& result, bool& goesOn)
      {
        const vtkIdType i = next();
        if (i >= 0)
        {
          const Waiting& waiting = batch[static_cast<std::size_t>(i)];
          goesOn =
            waiting.State ? one.Resume(*waiting.State, result) : one.Start(waiting.X, result);
          done.Steps -= waiting.State ? waiting.State->Values.Result.GetNumberOfSteps() : 0;
        }
        return i;
      },
      [&](vtkIdType i, int, Advection<Walker>& one, const AdvectionResult& result)
      {
        const Question& question = batch[static_cast<std::size_t>(i)].For;
        done.Steps += result.GetNumberOfSteps();
        if (one.IsElsewhere())
        {
          one.Save(state);
          RankExchange::Bytes& bytes = done.Sent[static_cast<std::size_t>(
            this->Ranks.FindRank(this->Shared.GetPlace(state.Values.Cell).Index))];
          PutHead(bytes, Kind::GoOn, question);
          MessageBytes::Put(bytes, state.Values);
          MessageBytes::Put(bytes, state.Numbers);
          ++done.HandedOn;
          return;
        }
        one.Finish();
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
  vtkIdType Steps = 0;
  vtkIdType HandedOn = 0;
};

template <typename Walker, typename Data>
std::unique_ptr<RankStreamlines> MakeOf(RankField& field, Data* data, vtkDataArray* vectors,
  const std::vector<vtkDataArray*>& arrays, vtkAlgorithm* owner, std::string& error)
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
  return error.empty() ? std::move(streamlines) : nullptr;
}
}

std::unique_ptr<RankStreamlines> RankStreamlines::Make(RankField& field, vtkDataArray* vectors,
  const std::vector<vtkDataArray*>& arrays, vtkAlgorithm* owner, std::string& error)
{
  if (auto* image = vtkImageData::SafeDownCast(field.GetData()))
  {
    return MakeOf<ImagePartWalker>(field, image, vectors, arrays, owner, error);
  }
  auto* grid = vtkRectilinearGrid::SafeDownCast(field.GetData());
  return MakeOf<RectilinearPartWalker>(field, grid, vectors, arrays, owner, error);
}

}
