// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_PointArrays_h
#define interlume_PointArrays_h

#include "Arrays/CarriedArrays.h"
#include "Output/ExtractionPoint.h"
#include "Output/KeptRuns.h"

#include "vtkType.h"

#include <memory>
#include <vector>

class vtkDataArray;

namespace interlume
{

class ArrayInterpolator;
class RowCoordinates;

/**
 * @class   PointArrays
 * @brief   coordinates and point arrays of the points of an output, written a few at a time
 *
 * They have the bytes that ExtractionArrays gives for a list of all points, which is not needed.
 */
class PointArrays
{
public:
  /// \a precision is one of vtkAlgorithm.
  PointArrays(vtkDataSet* input, int precision);
  ~PointArrays();

  /// Returns whether all arrays are of numbers; others need the list.
  bool AreNumbers() const { return !this->Arrays.HasOthers(); }

  /// Makes room for \a number points.
  void Allocate(vtkIdType number);
  /// Returns whether there is room.
  bool IsAllocated() const { return this->HasRoom; }

  /// Writes \a number points from \a first on. Threads may write different points at a time.
  void Write(const ExtractionPoint* points, vtkIdType number, vtkIdType first) const;

  /// Leaves out all other points.
  void Keep(const KeptRuns& kept);

  const vtkSmartPointer<vtkPoints>& GetPoints() const { return this->Arrays.GetPoints(); }
  /// Gives the arrays to \a output.
  void AddTo(vtkPointData* output) const { this->Arrays.AddTo(output); }

private:
  struct Writer;

  void AddWriter(vtkDataArray* in, vtkDataArray* out);

  CarriedArrays Arrays;
  /// The coordinates of grids that have no points of their own; else null.
  std::unique_ptr<RowCoordinates> Rows;
  std::vector<Writer> Writers;
  bool HasRoom = false;
};

}

#endif
