// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_DistributedStreamlines_h
#define interlume_DistributedStreamlines_h

#include "Common/Error.h"
#include "Streams/Streamlines.h"

#include <memory>
#include <vector>

class vtkAlgorithm;
class vtkDataArray;

namespace interlume
{

class DistributedField;
struct FlowReport;

/**
 * @class   DistributedStreamlines
 * @brief   traces streamlines of a field that is partitioned among processes
 *
 * A streamline starts in the process that owns the cell at its start position
 * (PartitionedCellSearch). When it enters a cell of another process, that process receives its
 * complete state and continues it. The result is returned to the process that requested the
 * streamline. Processes do not wait for each other: each traces batches of received streamlines in
 * parallel.
 *
 * A step reads only one cell, and cells have the same numbers and positions as in the whole grid.
 * Therefore results are bit-identical to those of a run with a single process that holds the whole
 * field.
 *
 * If the execution is aborted in one process, it ends in all processes.
 */
class DistributedStreamlines : public Streamlines
{
public:
  /// Creates an object for this process's partition of \a field. Collective. Sets \a error and
  /// returns null if any process fails. Returns null also if \a field has a PartitionError.
  static std::unique_ptr<DistributedStreamlines> Make(DistributedField& field,
    vtkDataArray* vectors, const std::vector<vtkDataArray*>& arrays, vtkAlgorithm* owner,
    Error& error);

  /// Finds the domain faces and returns their number. Collective.
  virtual int FindDomainFaces() = 0;
  /// Return the number of steps that this process computed, and the number of streamlines that it
  /// transferred to other processes.
  virtual vtkIdType GetNumberOfSteps() const = 0;
  virtual vtkIdType GetNumberOfTransfers() const = 0;
  /// Sets the report values about mismatched cell faces in the whole grid. Collective.
  virtual void Describe(FlowReport& report) const = 0;
};

}

#endif
