// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_RankStreamlines_h
#define interlume_RankStreamlines_h

#include "Common/Error.h"
#include "Streams/Streamlines.h"

#include <memory>
#include <vector>

class vtkAlgorithm;
class vtkDataArray;

namespace interlume
{

class RankField;
struct FlowReport;

/**
 * @class   RankStreamlines
 * @brief   streamlines of a field that processes hold in parts
 *
 * A streamline begins in the process whose own the cell of its start is (PartSearch), goes on with
 * its whole state in the next one where it enters a cell of that, and its result goes back to the
 * process that asked for it. Nobody waits: what has come in is followed by threads, a batch at a
 * time, while others do the same. Steps see one cell only and cells are numbered and placed as in
 * the whole, so that results have the bytes that they have where one process holds all.
 *
 * When the execution is aborted in one process it ends in all.
 */
class RankStreamlines : public Streamlines
{
public:
  /// Builds the field, whose part \a field has. Collective. Returns null after an \a error in any
  /// process, and if \a field cannot be in parts, and has the PartitionError.
  static std::unique_ptr<RankStreamlines> Make(RankField& field, vtkDataArray* vectors,
    const std::vector<vtkDataArray*>& arrays, vtkAlgorithm* owner, Error& error);

  /// Makes the faces of the domain known to walkers, where they have to be found. Collective.
  /// Returns their number.
  virtual int FindDomainFaces() = 0;
  /// Returns the number of steps that this process took, and of streamlines that it handed on.
  virtual vtkIdType GetNumberOfSteps() const = 0;
  virtual vtkIdType GetNumberOfHandedOn() const = 0;
  /// Fills what describes how the cells of the whole are joined. Collective.
  virtual void Describe(FlowReport& report) const = 0;
};

}

#endif
