// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_CheckpointedStreamlines_h
#define interlume_CheckpointedStreamlines_h

#include "Streams/Streamlines.h"

namespace interlume
{

class FlowCheckpoint;
class RankExchange;

/**
 * @class   CheckpointedStreamlines
 * @brief   takes finished streamlines from a checkpoint and computes the missing ones
 *
 * Streamlines are computed in batches of about one second. Between batches, no streamline is in
 * transit between processes, and the checkpoint is written if a write is due. After an abort, it is
 * written immediately.
 */
class CheckpointedStreamlines : public Streamlines
{
public:
  /// \a exchange connects the processes that hold partitions of the field. It is null if this
  /// process holds the entire field.
  CheckpointedStreamlines(
    Streamlines& streamlines, FlowCheckpoint& checkpoint, RankExchange* exchange);

  bool Follow(const AdvectionOptions& options, vtkIdType number, const GetPosition& start,
    const Take& take, double begin, double end) override;

  std::vector<Velocity> GetVelocities(
    vtkIdType number, const GetPosition& position, bool withVorticity) override
  {
    return this->Inner.GetVelocities(number, position, withVorticity);
  }
  const FlowField& GetField() const override { return this->Inner.GetField(); }

private:
  /// Computes a batch of streamlines, starting at index \a done, and increases \a done by the
  /// number of leading streamlines that are finished. Returns false if the execution was aborted.
  bool FollowBatch(const AdvectionOptions& options, vtkIdType number, const GetPosition& start,
    const Take& take, double begin, double end, vtkIdType& done);

  Streamlines& Inner;
  FlowCheckpoint& Checkpoint;
  RankExchange* Exchange;
  vtkIdType BatchSize = 1024;
};

}

#endif
