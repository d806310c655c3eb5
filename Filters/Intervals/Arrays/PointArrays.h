// SPDX-License-Identifier: BSD-3-Clause
#ifndef interlume_PointArrays_h
#define interlume_PointArrays_h

#include "Output/ExtractionBuffer.h"
#include "Output/ExtractionPoint.h"
#include "Output/KeptRuns.h"

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
 * @brief   coordinates and point arrays of output points, interpolated along the edges of a grid
 *
 * The points are written as one list, some at a time in their places, or as corners of triangles
 * that share no points; the bytes are the same. Arrays that are not of numbers have the value of
 * the nearer end. ExtractionArrays defines which arrays there are, and their types.
 */
class PointArrays
{
public:
  /// Creates the coordinates and arrays of a dataset; \a precision is one of vtkAlgorithm.
  PointArrays(vtkDataSet* input, int precision);

  /// Creates arrays without coordinates. Ids from \a split on are points of \a second. If that is
  /// not the first too, the arrays are those that correspond in both, and their names are keys
  /// (ArrayMatch), which tell those of several calls apart.
  PointArrays(vtkPointData* first, vtkPointData* second, vtkIdType split);

  ~PointArrays();

  /// Computes the coordinates of a list of points only.
  static vtkSmartPointer<vtkPoints> MakePoints(
    vtkDataSet* input, const ExtractionBuffer<ExtractionPoint>& points, int precision);

  /// Allocates and writes a list of points, by all threads.
  void Fill(const ExtractionBuffer<ExtractionPoint>& points);

  /// Allocates \a number points.
  void Allocate(vtkIdType number);
  bool IsAllocated() const { return this->HasRoom; }

  /// Writes \a number points from \a first on. Threads may write different points at a time.
  void Write(const ExtractionPoint* points, vtkIdType number, vtkIdType first);

  /// Leaves out all other points.
  void Keep(const KeptRuns& kept);

  /// The values of some points, and the corners of triangles, each of which is one of the points.
  struct Part
  {
    using Index = std::uint32_t;

    ExtractionBuffer<Index> Corners;
    std::size_t NumberOfPoints = 0;
    /// The values array after array.
    ExtractionBuffer<char> Values;
    /// The nearer end of each point, if there are arrays that are not of numbers.
    ExtractionBuffer<vtkIdType> Nearer;

    std::size_t GetBytes() const
    {
      return this->Corners.GetBytes() + this->Values.GetBytes() + this->Nearer.GetBytes();
    }
  };

  /// Interpolates points before their places in the output are known. Any number of threads may do
  /// so at a time.
  Part Interpolate(const ExtractionPoint* points, std::size_t number, const Part::Index* corners,
    std::size_t numberOfCorners) const;

  /// Writes the corners of a part from \a first on. Threads may write different parts at a time.
  void Write(const Part& part, vtkIdType first);

  const vtkSmartPointer<vtkPoints>& GetPoints() const { return this->Points; }
  /// Adds the arrays to \a output.
  void AddTo(vtkPointData* output);

private:
  // An array of numbers that is interpolated.
  struct Column;
  // An array of the input, or one of each of two inputs, and that of the output.
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
  // The coordinates of a grid that stores no points; else null.
  std::unique_ptr<RowCoordinates> Rows;
  std::vector<Column> Columns;
  std::vector<Carried> Arrays;
  // Whether there are arrays that are not of numbers, and the nearer end of each point.
  bool HasOthers = false;
  ExtractionBuffer<vtkIdType> Nearer;
  bool HasRoom = false;
};

}

#endif
