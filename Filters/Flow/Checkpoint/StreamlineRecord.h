// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_StreamlineRecord_h
#define interlume_StreamlineRecord_h

#include "Advection/AdvectionOptions.h"
#include "Common/Error.h"

#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <array>
#include <string>
#include <vector>

class vtkDataArray;
class vtkDoubleArray;
class vtkIntArray;
class vtkTable;

namespace interlume
{

/**
 * @class   StreamlineRecord
 * @brief   the results of streamlines in the order in which an execution asks for them
 *
 * An execution asks for streamlines group by group: the samples, those of each level of refinement,
 * what lies beyond surfaces. Each group is a number of streamlines with a digest of their starts; a
 * result is a row of columns of numbers, 124 bytes and 8 for each mean. Whatever else an execution
 * computes follows from these results, so that one with the same record has the same bytes.
 */
class StreamlineRecord
{
public:
  /// \a means is the number of arrays that means are taken of.
  explicit StreamlineRecord(int means);
  ~StreamlineRecord();

  ///@{
  /**
   * Begins the next group. Returns how many of its streamlines, from the first on, are recorded;
   * what was recorded of another group in its place, and after it, is dropped: \a isOther then is
   * true.
   */
  vtkIdType BeginGroup(vtkIdType number, const std::string& digest, bool& isOther);
  /// Reads and writes results of the group, which threads do at once for different ones.
  void Get(vtkIdType i, AdvectionResult& result) const;
  void Set(vtkIdType i, const AdvectionResult& result);
  /// Tells how many streamlines of the group are recorded now, from the first on.
  void SetFinished(vtkIdType number);
  ///@}

  /// Returns the number of streamlines that are recorded, of all groups.
  vtkIdType GetNumberOfRows() const { return this->Rows; }

  /// Forgets all that is recorded.
  void Clear();

  /// Adds all that is recorded to a table, without copies, which must not outlive this.
  void Write(vtkTable* table) const;
  /// Takes over what a table of a file has. Returns an error if the file is damaged.
  Error Read(vtkTable* table);

private:
  static constexpr std::size_t NumberOfInts = 11;
  static constexpr std::size_t NumberOfDoubles = 5;

  void SetCapacity(vtkIdType rows);
  std::vector<vtkDataArray*> GetColumns() const;

  std::array<vtkNew<vtkIntArray>, NumberOfInts> Ints;
  std::array<vtkNew<vtkDoubleArray>, NumberOfDoubles> Doubles;
  vtkNew<vtkDoubleArray> Parameters;
  vtkNew<vtkDoubleArray> Position;
  vtkNew<vtkDoubleArray> Means;
  int NumberOfMeans;

  struct Group
  {
    vtkIdType Number;
    std::string Digest;
  };
  std::vector<Group> Groups;
  /// The group that was begun last, and its first row.
  std::size_t Current = 0;
  vtkIdType First = 0;
  bool HasBegun = false;
  vtkIdType Rows = 0;
};

}

#endif
