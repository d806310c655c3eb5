// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_PointArrays_h
#define interlume_PointArrays_h

#include "Output/ExtractionBuffer.h"
#include "Output/ExtractionPoint.h"
#include "Output/RetainedIdRanges.h"

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

class vtkAbstractArray;
class vtkDataArray;
class vtkDataSet;
class vtkPointData;
class vtkPoints;

namespace interlume
{

class ArrayInterpolator;
class RowCoordinates;

/**
 * @class   PointArrays
 * @brief   coordinates and point arrays of output points, interpolated along grid edges
 *
 * Points are written as one list, in batches at given positions, or as corners of triangles that
 * share no points. All three methods give bit-identical values. Non-numeric arrays use the value at
 * the closer end of the edge. ExtractionArrays selects the arrays and their types.
 */
class PointArrays
{
public:
  /// Creates the coordinates and arrays of a dataset. \a precision is a value of
  /// vtkAlgorithm::DesiredOutputPrecision.
  PointArrays(vtkDataSet* input, int precision);

  /// Creates arrays without coordinates. Ids from \a split on refer to points of \a second. If \a
  /// first and \a second differ, only arrays that both contain are created, and their names are
  /// keys of ArrayMatch, so that the results of several calls can be matched.
  PointArrays(vtkPointData* first, vtkPointData* second, vtkIdType split);

  ~PointArrays();

  /// Computes only the coordinates of a list of points.
  static vtkSmartPointer<vtkPoints> MakePoints(
    vtkDataSet* input, const ExtractionBuffer<ExtractionPoint>& points, int precision);

  /// Allocates and writes a list of points in parallel.
  void Fill(const ExtractionBuffer<ExtractionPoint>& points);

  void Allocate(vtkIdType number);
  bool IsAllocated() const { return this->Allocated; }

  /// Writes \a number points, starting at index \a first. Threads may write different points
  /// concurrently.
  void Write(const ExtractionPoint* points, vtkIdType number, vtkIdType first);

  /// Removes all points that are not retained.
  void Keep(const RetainedIdRanges& retained);

  /// Interpolated values of a batch of points, and triangle corners as indices into this batch.
  struct Part
  {
    using Index = std::uint32_t;

    ExtractionBuffer<Index> Corners;
    std::size_t NumberOfPoints = 0;
    /// Values of the points, one array after the other.
    ExtractionBuffer<char> Values;
    /// For each point, the id of the closer end of its edge, if there are non-numeric arrays.
    ExtractionBuffer<vtkIdType> Nearer;

    std::size_t GetBytes() const
    {
      return this->Corners.GetBytes() + this->Values.GetBytes() + this->Nearer.GetBytes();
    }
  };

  /// Interpolates points before their output indices are known. Thread-safe.
  Part Interpolate(const ExtractionPoint* points, std::size_t number, const Part::Index* corners,
    std::size_t numberOfCorners) const;

  /// Writes one point for each corner in a part, starting at index \a first. Threads may write
  /// different parts concurrently.
  void Write(const Part& part, vtkIdType first);

  const vtkSmartPointer<vtkPoints>& GetPoints() const { return this->Points; }
  /// Adds the arrays to \a output.
  void AddTo(vtkPointData* output);

private:
  // A numeric array that is interpolated.
  struct Column;
  // An input array, or a pair of corresponding arrays of two inputs, and the output array.
  struct Carried
  {
    vtkAbstractArray* First;
    vtkAbstractArray* Second;
    vtkSmartPointer<vtkAbstractArray> Out;
  };

  PointArrays();
  void AddCoordinates(vtkDataSet* input, int precision);
  void AddArrays(vtkPointData* first, vtkPointData* second, vtkIdType split);
  void AddColumn(vtkDataArray* first, vtkDataArray* second, vtkDataArray* out);

  vtkPointData* Input = nullptr;
  bool HasKeys = false;
  vtkIdType Split = VTK_ID_MAX;
  vtkSmartPointer<vtkPoints> Points;
  // Computes the coordinates of a grid without explicit points; null for other grids.
  std::unique_ptr<RowCoordinates> Rows;
  std::vector<Column> Columns;
  std::vector<Carried> Arrays;
  // If true, there are non-numeric arrays, and Nearer has the closer edge end of each point.
  bool HasOthers = false;
  ExtractionBuffer<vtkIdType> Nearer;
  bool Allocated = false;
};

}

#endif
