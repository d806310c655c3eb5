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
 * @brief   follows the streamlines that a checkpoint does not have, and takes the others from there
 *
 * Streamlines are followed in parts that take about a second; between them nothing is on its way,
 * and the checkpoint is written when it is due. After an abort it is written at once.
 */
class CheckpointedStreamlines : public Streamlines
{
public:
  /// \a exchange is that of the processes that have parts of the field, null where this one has
  /// all.
  CheckpointedStreamlines(
    Streamlines& streamlines, FlowCheckpoint& checkpoint, RankExchange* exchange);

  bool Follow(const AdvectionOptions& options, vtkIdType number, const GetPosition& start,
    const Take& take, double begin, double end) override;

  std::vector<Velocity> GetVelocities(vtkIdType number, const GetPosition& position) override
  {
    return this->Inner.GetVelocities(number, position);
  }
  const FlowField& GetField() const override { return this->Inner.GetField(); }

private:
  /// Follows streamlines of the group from \a done on, as many as a part has, and adds them to \a
  /// done. Returns false when the execution was aborted.
  bool FollowPart(const AdvectionOptions& options, vtkIdType number, const GetPosition& start,
    const Take& take, double begin, double end, vtkIdType& done);

  Streamlines& Inner;
  FlowCheckpoint& Checkpoint;
  RankExchange* Exchange;
  /// The number of streamlines of a part.
  vtkIdType Part = 1024;
};

}

#endif
