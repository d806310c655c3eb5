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
 * @brief   results of streamlines in the order in which an execution requests them
 *
 * An execution requests streamlines in groups: the samples, the samples of each refinement level,
 * and samples on the far side of surfaces. A group is identified by its number of streamlines and a
 * digest of their start positions and direction. Each result is a row of numbers: 124 bytes plus 8
 * bytes per averaged array. All other output follows from these results. Therefore an execution
 * that resumes from the record has bit-identical output.
 */
class StreamlineRecord
{
public:
  /// \a means is the number of averaged arrays.
  explicit StreamlineRecord(int means);
  ~StreamlineRecord();

  ///@{
  /**
   * Begins the next group. Returns how many of its leading streamlines are recorded. If the
   * recorded group has another digest or number of streamlines, discards it and all later groups
   * and sets \a isDifferent to true.
   */
  vtkIdType BeginGroup(vtkIdType number, const std::string& digest, bool& isDifferent);
  /// Reads or writes the result of streamline \a i of the group. Threads may call these
  /// concurrently for different \a i.
  void Get(vtkIdType i, AdvectionResult& result) const;
  void Set(vtkIdType i, const AdvectionResult& result);
  /// Sets how many leading streamlines of the group are recorded.
  void SetNumberOfFinished(vtkIdType number);
  ///@}

  /// Returns the number of recorded streamlines of all groups.
  vtkIdType GetNumberOfRows() const { return this->Rows; }

  /// Deletes all records.
  void Clear();

  /// Adds all records to a table. The table shares this object's memory and must not outlive it.
  void Write(vtkTable* table) const;
  /// Reads the records from the table of a checkpoint file. Returns an error if the file is
  /// damaged.
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
  /// Index and first row of the current group.
  std::size_t Current = 0;
  vtkIdType First = 0;
  bool HasBegun = false;
  vtkIdType Rows = 0;
};

}

#endif
