// SPDX-License-Identifier: BSD-3-Clause
#include "Checkpoint/CheckpointedStreamlines.h"

#include "Checkpoint/FlowCheckpoint.h"
#include "Common/DataDigest.h"
#include "Streams/RankExchange.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <chrono>

namespace interlume
{

namespace
{
/// Returns a digest of where streamlines start, and in which direction.
std::string GetDigest(
  const AdvectionOptions& options, vtkIdType number, const Streamlines::GetPosition& start)
{
  DataDigest digest;
  digest.Add(&options.Direction, sizeof(options.Direction));
  std::vector<double> positions;
  constexpr vtkIdType most = 4096;
  for (vtkIdType first = 0; first < number; first += most)
  {
    const vtkIdType last = std::min(number, first + most);
    positions.resize(static_cast<std::size_t>(3 * (last - first)));
    for (vtkIdType i = first; i < last; ++i)
    {
      start(i, &positions[static_cast<std::size_t>(3 * (i - first))]);
    }
    digest.Add(positions.data(), positions.size() * sizeof(double));
  }
  return digest.Take();
}
}

CheckpointedStreamlines::CheckpointedStreamlines(
  Streamlines& streamlines, FlowCheckpoint& checkpoint, RankExchange* exchange)
  : Inner(streamlines)
  , Checkpoint(checkpoint)
  , Exchange(exchange)
{
}

bool CheckpointedStreamlines::Follow(const AdvectionOptions& options, vtkIdType number,
  const GetPosition& start, const Take& take, double begin, double end)
{
  StreamlineRecord& record = this->Checkpoint.GetRecord();
  bool isOther = false;
  vtkIdType done = record.BeginGroup(number, GetDigest(options, number, start), isOther);
  if (isOther)
  {
    this->Checkpoint.WarnOfOther();
  }
  vtkSMPTools::For(0, done,
    [&](vtkIdType first, vtkIdType last)
    {
      AdvectionResult result;
      for (vtkIdType i = first; i < last; ++i)
      {
        record.Get(i, result);
        take(i, result);
      }
    });
  this->Checkpoint.AddResumed(done);
  const auto isLeft = [&]
  {
    const bool isHere = done < number;
    return this->Exchange ? this->Exchange->IsAnywhere(isHere) : isHere;
  };
  bool goesOn = true;
  do
  {
    goesOn = this->FollowPart(options, number, start, take, begin, end, done);
    record.SetFinished(done);
    if (!goesOn || this->Checkpoint.IsDue())
    {
      this->Checkpoint.Write();
    }
  } while (goesOn && isLeft());
  return goesOn;
}

bool CheckpointedStreamlines::FollowPart(const AdvectionOptions& options, vtkIdType number,
  const GetPosition& start, const Take& take, double begin, double end, vtkIdType& done)
{
  using Clock = std::chrono::steady_clock;
  constexpr double shortest = 0.5;
  constexpr double longest = 2.0;
  constexpr vtkIdType least = 256;
  const Clock::time_point before = Clock::now();
  const vtkIdType first = done;
  const vtkIdType part = std::min(this->Part, number - first);
  const auto getProgress = [&](vtkIdType i)
  {
    const double share = number > 0 ? static_cast<double>(i) / static_cast<double>(number) : 1.0;
    return begin + share * (end - begin);
  };
  // Those of the part that have ended, when it is aborted.
  std::vector<unsigned char> hasEnded(static_cast<std::size_t>(part), 0);
  StreamlineRecord& record = this->Checkpoint.GetRecord();
  const bool goesOn = this->Inner.Follow(
    options, part, [&](vtkIdType i, double x[3]) { start(first + i, x); },
    [&](vtkIdType i, const AdvectionResult& result)
    {
      record.Set(first + i, result);
      take(first + i, result);
      hasEnded[static_cast<std::size_t>(i)] = 1;
    },
    getProgress(first), getProgress(first + part));
  done = first + (std::find(hasEnded.begin(), hasEnded.end(), 0) - hasEnded.begin());
  const std::chrono::duration<double> seconds = Clock::now() - before;
  if (part == this->Part && seconds.count() < shortest)
  {
    this->Part *= 2;
  }
  else if (seconds.count() > longest)
  {
    this->Part = std::max(least, this->Part / 2);
  }
  return goesOn;
}

}
