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
/// Returns a digest of the start positions and the direction of integration.
std::string GetDigest(
  const AdvectionOptions& options, vtkIdType number, const Streamlines::GetPosition& start)
{
  DataDigest digest;
  digest.Add(&options.Direction, sizeof(options.Direction));
  std::vector<double> positions;
  constexpr vtkIdType blockSize = 4096;
  for (vtkIdType first = 0; first < number; first += blockSize)
  {
    const vtkIdType last = std::min(number, first + blockSize);
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
  bool isDifferent = false;
  vtkIdType done = record.BeginGroup(number, GetDigest(options, number, start), isDifferent);
  if (isDifferent)
  {
    this->Checkpoint.WarnOfMismatch();
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
  bool isActive = true;
  do
  {
    isActive = this->FollowBatch(options, number, start, take, begin, end, done);
    record.SetNumberOfFinished(done);
    if (!isActive || this->Checkpoint.IsDue())
    {
      this->Checkpoint.Write();
    }
  } while (isActive && isLeft());
  return isActive;
}

bool CheckpointedStreamlines::FollowBatch(const AdvectionOptions& options, vtkIdType number,
  const GetPosition& start, const Take& take, double begin, double end, vtkIdType& done)
{
  using Clock = std::chrono::steady_clock;
  constexpr double shortest = 0.5;
  constexpr double longest = 2.0;
  constexpr vtkIdType minimumBatch = 256;
  const Clock::time_point before = Clock::now();
  const vtkIdType first = done;
  const vtkIdType batch = std::min(this->BatchSize, number - first);
  const auto getProgress = [&](vtkIdType i)
  {
    const double fraction = number > 0 ? static_cast<double>(i) / static_cast<double>(number) : 1.0;
    return begin + fraction * (end - begin);
  };
  // 1 for each finished streamline. After an abort, some streamlines are not finished.
  std::vector<unsigned char> hasEnded(static_cast<std::size_t>(batch), 0);
  StreamlineRecord& record = this->Checkpoint.GetRecord();
  const bool isActive = this->Inner.Follow(
    options, batch, [&](vtkIdType i, double x[3]) { start(first + i, x); },
    [&](vtkIdType i, const AdvectionResult& result)
    {
      record.Set(first + i, result);
      take(first + i, result);
      hasEnded[static_cast<std::size_t>(i)] = 1;
    },
    getProgress(first), getProgress(first + batch));
  done = first + (std::find(hasEnded.begin(), hasEnded.end(), 0) - hasEnded.begin());
  const std::chrono::duration<double> seconds = Clock::now() - before;
  if (batch == this->BatchSize && seconds.count() < shortest)
  {
    this->BatchSize *= 2;
  }
  else if (seconds.count() > longest)
  {
    this->BatchSize = std::max(minimumBatch, this->BatchSize / 2);
  }
  return isActive;
}

}
